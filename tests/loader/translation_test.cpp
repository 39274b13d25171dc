// Does a lesson speak another language, whole or not at all?
#include <doctest/doctest.h>

#include "error_cases.h"
#include "lessons/lesson_file.h"
#include "lessons/lesson_list.h"
#include "lessons/translation.h"
#include "temp_folder.h"

using namespace halfdisk;

namespace {

const std::string kLesson =
    "title = 'Light'\nsection = 'S'\nscene = 'room.toml'\n[[term]]\nname = 'ray'\nmeaning = 'a line'\n"
    "[[step]]\ntitle = 'First'\nprose = 'A [ray].'\nshow = ['rays']\n[step.question]\nask = 'Why?'\n"
    "answer = 'So.'\n[[step]]\ntitle = 'Second'\nprose = 'B'\n[step.goal]\nsays = 'Do it.'\n"
    "reach = 'profile'\natLeast = 1\n";

const std::string kTerm = "[[term]]\nname = 'Strahl'\nmeaning = 'eine Linie'\n";
const std::string kFirst =
    "[[step]]\ntitle = 'Erstens'\nprose = 'Ein [Strahl].'\nask = 'Warum?'\nanswer = 'Darum.'\n";
const std::string kSecond = "[[step]]\ntitle = 'Zweitens'\nprose = 'B'\ngoal = 'Tu es.'\n";
const std::string kHead = "title = 'Licht'\nsection = 'A'\n";

/// A folder with the lesson, its scene and, if it is not empty, its German.
struct Course {
    TempFolder folder;
    std::filesystem::path lesson, german;

    explicit Course(const std::string& translation) {
        folder.write("room.toml", "[[segment]]\nname = 'floor'\na = [0, 0]\nb = [1, 0]\n");
        lesson = folder.write("01-light.toml", kLesson);
        german = folder.path / "de" / "01-light.toml";
        if (!translation.empty()) folder.write("de/01-light.toml", translation);
    }
};

}  // namespace

TEST_CASE("a translation changes the words and nothing else") {
    const Course course(kHead + kTerm + kFirst + kSecond);
    const Lesson english = loadLesson(course.lesson);
    Lesson lesson = english;
    translateLesson(lesson, std::string("de"));
    CHECK(lesson.title == "Licht");
    CHECK(lesson.terms.at(0).name == "Strahl");
    CHECK(plainText(lesson.steps.at(0).prose) == "Ein Strahl.");
    CHECK(plainText(lesson.steps.at(0).question->answer) == "Darum.");
    CHECK(lesson.steps.at(1).goal->says == "Tu es.");
    // All but the words is as before.
    lesson.title = english.title;
    lesson.section = english.section;
    lesson.terms = english.terms;
    for (std::size_t i = 0; i < 2; ++i) {
        Step& step = lesson.steps[i];
        step.title = english.steps[i].title;
        step.prose = english.steps[i].prose;
        step.question = english.steps[i].question;
        if (step.goal) step.goal->says = english.steps[i].goal->says;
    }
    CHECK(lesson == english);
    const auto titles = translatedTitles(course.lesson, "de");
    REQUIRE(titles);
    CHECK(titles->lesson == "Licht");
    CHECK(titles->steps == std::vector<std::string>{"Erstens", "Zweitens"});
}

TEST_CASE("without a file for the language, or without a language, a lesson stays English") {
    const Course course("");
    const Lesson english = loadLesson(course.lesson);
    for (const std::string language : {"de", ""}) {
        Lesson lesson = english;
        translateLesson(lesson, language);
        CHECK(lesson == english);
        CHECK_FALSE(translatedTitles(course.lesson, language));
    }
}

TEST_CASE("a translation that is not the lesson's is refused with its place, and the lesson stays whole") {
    const auto check = [](const std::string& text, std::initializer_list<std::string_view> said) {
        const Course course("x = 1\n");
        const Lesson english = loadLesson(course.lesson);
        checkErrors({{text, said}}, course.german.string(), [&](const std::string& translation) {
            course.folder.write("de/01-light.toml", translation);
            Lesson lesson = english;
            translateLesson(lesson, std::string("de"));
        });
    };
    check("^" + kHead + kFirst + kSecond, {"number of [[term]] in the translation is 0", "expected 1"});
    check(kHead + kTerm + "^" + kFirst,
          {"number of [[step]] in the translation is 1", "expected 2", "01-light.toml"});
    check(kHead + kTerm + kFirst + "^[[step]]\ntitle = 'Zweitens'\nprose = 'B'\n", {"goal"});
    check(kHead + kTerm + "^[[step]]\ntitle = 'E'\nprose = 'B'\nanswer = 'x'\n" + kSecond, {"ask"});
    check(kHead + kTerm + kFirst + kSecond + "^ask = 'Was?'\n", {"ask"});
    check(kHead + kTerm + "[[step]]\ntitle = 'E'\nprose = 'Ein ^[Ray].'\nask = 'a'\nanswer = 'b'\n" + kSecond,
          {"Ray"});
    check(kHead + "^show = []\n" + kTerm + kFirst + kSecond, {"show"});
}

TEST_CASE("every lesson of the course has all its words in German") {
    const std::filesystem::path folder = std::filesystem::path(LESSON_SCENES).parent_path();
    std::size_t steps = 0;
    for (const LessonEntry& entry : listLessons(folder)) {
        CAPTURE(entry.slug);
        REQUIRE(entry.error.empty());
        const Lesson english = loadLesson(entry.path);
        Lesson german = english;
        translateLesson(german, folder / "de" / entry.path.filename());
        CHECK(german.title != english.title);
        for (std::size_t i = 0; i < english.steps.size(); ++i) {
            CAPTURE(i);
            CHECK(german.steps[i].prose != english.steps[i].prose);
            CHECK(german.steps[i].title != english.steps[i].title);
            if (english.steps[i].question) CHECK(german.steps[i].question != english.steps[i].question);
            ++steps;
        }
    }
    CHECK(steps > 100);
}
