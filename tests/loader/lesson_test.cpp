// Does a lesson file become the lesson that it describes?
#include <doctest/doctest.h>

#include "lessons/lesson_file.h"

using namespace halfdisk;

namespace {

const std::filesystem::path kLessons = std::filesystem::path(LOADER_DATA) / "lessons";

}  // namespace

TEST_CASE("a lesson is read with its scene, terms and steps") {
    const Lesson lesson = loadLesson(kLessons / "02-sample.toml");
    CHECK(lesson.number == 2);
    CHECK(lesson.slug == "sample");
    CHECK(lesson.title == "A sample");
    CHECK(lesson.section == "A heading");
    CHECK(lesson.file == kLessons / "02-sample.toml");
    CHECK(lesson.scenePath == kLessons / "scenes/corner.toml");
    CHECK(lesson.scene.title == "Corner");
    CHECK(lesson.terms ==
          std::vector<Term>{{"Radiance", "Power per projected length per radian.", Topic::radiance}});
    REQUIRE(lesson.steps.size() == 3);

    const Step& step = lesson.steps[0];
    CHECK(step.title == "Everything is set");
    REQUIRE(step.prose.size() == 2);
    CHECK(step.prose[0].spans[1] == Span{SpanStyle::term, "radiance", 0});
    CHECK(step.prose[1].kind == ParagraphKind::formula);
    CHECK(step.listing == std::vector<int>{16, 17});
    for (const Named<View>& view : kViews)
        CHECK(step.show.has(view.value) ==
              (view.value == View::halfdisk || view.value == View::rays || view.value == View::code));
    CHECK(step.unlock == Control::samples);
    CHECK(step.values.settings.samples == 64);
    CHECK(step.values.settings.maxDepth == 3);
    CHECK(step.values.settings.seed == 7);
    CHECK(step.values.settings.sampler == Sampler::stratified);
    CHECK(step.values.settings.emitters == Emitters::hit);
    CHECK(step.values.at == WallPoint{1, 0.25});
    CHECK(step.values.event == 12);
    for (const Named<Defect>& defect : kDefects)
        CHECK(step.values.settings.defects.has(defect.value) ==
              (defect.value == Defect::frame || defect.value == Defect::pdf));
    REQUIRE(step.question.has_value());
    CHECK(plainText(step.question->ask) == "What is left?");
    CHECK(plainText(step.question->answer) == "Nothing.");
}

TEST_CASE("every step starts from the defaults, not from the step before it") {
    const Lesson lesson = loadLesson(kLessons / "02-sample.toml");
    StepValues defaults;
    defaults.settings.samples = 32;
    defaults.settings.sampler = Sampler::cosine;
    defaults.at = {0, 0.5};
    CHECK(lesson.steps[1].values == defaults);
    CHECK_FALSE(lesson.steps[1].unlock.has_value());
    CHECK_FALSE(lesson.steps[1].question.has_value());
    CHECK(lesson.steps[1].listing.empty());
    CHECK(lesson.steps[1].show == ViewSet{});
    defaults.settings.defects = DefectSet::all();
    CHECK(lesson.steps[2].values == defaults);
}

TEST_CASE("a step may take back what the defaults say") {
    const auto scene = [](const std::filesystem::path&) {
        SceneDescription one;
        one.shapes.push_back({"w", SegmentShape{{0, 0}, {1, 0}}, "", Rgb(0.0), false});
        return one;
    };
    const Lesson lesson = parseLesson(
        "title='t'\nsection='s'\nscene='x'\n[defaults]\nasPrinted = true\nevent = 5\n"
        "[[step]]\ntitle='a'\nprose='b'\n[step.set]\nasPrinted = false\n"
        "[[step]]\ntitle='a'\nprose='b'\n[step.set]\nasPrinted = []\nevent = 0",
        "7-x.toml", scene);
    CHECK(lesson.number == 7);
    CHECK(lesson.steps.at(0).values.settings.defects == DefectSet{});
    CHECK(lesson.steps.at(0).values.event == 5);
    CHECK(lesson.steps.at(1).values.settings.defects == DefectSet{});
    CHECK(lesson.steps.at(1).values.event == 0);
}

TEST_CASE("tables of names list every value once, in order") {
    for (std::size_t i = 0; i < kViews.size(); ++i) CHECK(static_cast<std::size_t>(kViews[i].value) == i);
    for (std::size_t i = 0; i < kControls.size(); ++i)
        CHECK(static_cast<std::size_t>(kControls[i].value) == i);
}

TEST_CASE("the file name gives the number and the slug") {
    const auto name = parseLessonFileName("lessons/03-as-printed.toml");
    REQUIRE(name.has_value());
    CHECK(name->number == 3);
    CHECK(name->slug == "as-printed");
    CHECK(parseLessonFileName("12-3d.toml")->slug == "3d");
    for (const char* bad : {"as-printed.toml", "03.toml", "03-.toml", "03as.toml", "03-4.toml", "03-a.txt",
                            "-a.toml", "03-a b.toml", "03-a:b.toml", "12345-a.toml"})
        CHECK_FALSE(parseLessonFileName(bad).has_value());
}
