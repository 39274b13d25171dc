// Are all lessons listed, however broken some are, and found by what one types?
#include "lessons/lesson_list.h"

#include <doctest/doctest.h>

#include "lessons/lesson_file.h"
#include "lessons/suggestions.h"
#include "temp_folder.h"

using namespace halfdisk;

namespace {

const std::filesystem::path kLessons = std::filesystem::path(LOADER_DATA) / "lessons";

constexpr std::string_view kLesson =
    "title='T'\nsection='S'\nscene='s.toml'\n[[step]]\ntitle='A'\nprose='B'\n[[step]]\ntitle='C'\nprose='D'"
    "\n";
constexpr std::string_view kScene = "[[segment]]\na=[0,0]\nb=[1,0]\n";

}  // namespace

TEST_CASE("lessons are listed by number, and a broken one hides no other") {
    const auto lessons = listLessons(kLessons);
    REQUIRE(lessons.size() == 4);
    CHECK(lessons[0].number == 2);
    CHECK(lessons[0].slug == "sample");
    CHECK(lessons[0].title == "A sample");
    CHECK(lessons[0].steps == 3);
    CHECK(lessons[0].error.empty());
    CHECK(lessons[1].number == 3);
    CHECK(lessons[1].slug == "broken");
    CHECK(lessons[1].error.find("03-broken.toml:8:1: unknown key \"unlok\"") != std::string::npos);
    CHECK(lessons[2].slug == "last");
    CHECK(lessons[2].error.empty());
    CHECK(lessons[3].path.filename() == "notes.toml");
    CHECK_FALSE(lessons[3].error.empty());
}

TEST_CASE("two lessons with one number or one slug are told") {
    const TempFolder folder;
    folder.write("s.toml/x", "");  // a folder, however named, is told as well
    std::filesystem::remove_all(folder.path / "s.toml");
    folder.write("s.toml", kScene);  // a scene may lie beside the lessons
    folder.write("t.toml", "title = 3");
    for (const char* name :
         {"01-a.toml", "01-b.toml", "02-a.toml", "00-zero.toml", ".#03-c.toml", "03-c.toml~"})
        folder.write(name, kLesson);
    const auto lessons = listLessons(folder.path);
    REQUIRE(lessons.size() == 5);  // t.toml is no lesson and says so, last
    CHECK(lessons[0].slug == "zero");
    CHECK(lessons[0].error.empty());
    CHECK(lessons[1].error.empty());
    CHECK(lessons[2].error.find("its number is that of 01-a.toml") != std::string::npos);
    CHECK(lessons[3].error.find("its slug is that of 01-a.toml") != std::string::npos);
    CHECK(lessons[4].error.find("t.toml") != std::string::npos);
}

TEST_CASE("a folder that cannot be read is an error of its own") {
    const TempFolder folder;
    CHECK(listLessons(folder.path).empty());
    CHECK_THROWS_WITH_AS(listLessons(folder.path / "none"), doctest::Contains("cannot be read"), InputError);
    CHECK_THROWS_AS(listLessons(folder.write("file", "")), InputError);
}

TEST_CASE("references are a slug or a number, with or without a step") {
    CHECK(parseLessonRef("as-printed") == LessonRef{"as-printed", 1});
    CHECK(parseLessonRef("as-printed:3") == LessonRef{"as-printed", 3});
    CHECK(parseLessonRef("03") == LessonRef{"03", 1});
    CHECK(parseLessonRef("3:2") == LessonRef{"3", 2});
    for (const char* bad : {"", ":", ":3"})
        CHECK_THROWS_WITH_AS(parseLessonRef(bad), doctest::Contains("names no lesson"), InputError);
    for (const char* bad : {"a:", "a:0", "a:-1", "a:x", "a:1:2", "a:1.5", "a:99999999999"})
        CHECK_THROWS_WITH_AS(parseLessonRef(bad), doctest::Contains("names no step"), InputError);
}

TEST_CASE("references find their lesson and step or say what there is") {
    const auto lessons = listLessons(kLessons);
    const auto slugOf = [&](std::string_view text) { return findLesson(lessons, parseLessonRef(text)).slug; };
    CHECK(slugOf("sample") == "sample");
    CHECK(slugOf("02") == "sample");
    CHECK(slugOf("2:3") == "sample");
    CHECK(slugOf("broken") == "broken");
    CHECK(slugOf("10") == "last");
    CHECK_THROWS_WITH_AS(slugOf("sampel"), doctest::Contains("\"sample\", \"broken\", \"last\""), InputError);
    CHECK_THROWS_WITH_AS(slugOf("sampel"), doctest::Contains("did you mean \"sample\"?"), InputError);
    CHECK_THROWS_AS(slugOf("4"), InputError);
    CHECK_THROWS_AS(findLesson({}, {"a", 1}), InputError);
    const Lesson lesson = loadLesson(kLessons / "02-sample.toml");
    CHECK(stepIndex(lesson, {"sample", 1}) == 0);
    CHECK(stepIndex(lesson, {"sample", 3}) == 2);
    CHECK_THROWS_WITH_AS(stepIndex(lesson, {"sample", 4}),
                         doctest::Contains("no step 4, expected a step from 1 to 3"), InputError);
}

TEST_CASE("a word that is refused is never offered instead of itself") {
    CHECK(expectedOneOf("sed", {"seed", "step"}) ==
          "expected one of \"seed\" or \"step\"; did you mean \"seed\"?");
    CHECK(expectedOneOf("seed", {"seed", "step"}) == "expected one of \"seed\" or \"step\"");
}
