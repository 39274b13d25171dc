// Do the texts of a lesson show the numbers of its claims, in every language, and is every slip told?
#include <doctest/doctest.h>

#include <map>
#include <regex>

#include "error_cases.h"
#include "lessons/lesson_file.h"
#include "lessons/lesson_list.h"
#include "lessons/named_numbers.h"
#include "lessons/prose.h"
#include "lessons/scene_file.h"
#include "lessons/translation.h"
#include "lessons/typed_numbers.h"
#include "temp_folder.h"

using namespace halfdisk;

namespace {

const NamedNumbers kNumbers{{{"kept", 0.8612}, {"rays", 69904.0}, {"low", -0.25}, {"many", 1234567.891}}};

std::string shown(std::string_view text) {
    return withNumbers(text, kNumbers);
}

const std::string kRoom = "[[segment]]\nname = 'floor'\na = [0, 0]\nb = [1, 0]\n";
const std::string kHead = "title = 'T'\nsection = 'S'\nscene = 'room.toml'\n";
const std::string kClaim = "[[step.claim]]\nmeasure = 'rays'\nequals = 0.56\n";

SceneDescription room(const std::filesystem::path&) {
    return parseScene(kRoom, "room");
}

Lesson lessonOf(const std::string& text) {
    return parseLesson(text, "dir/01-x.toml", room);
}

void check(const std::string& text, std::initializer_list<std::string_view> said) {
    checkErrors({{text, said}}, "dir/01-x.toml", [](const std::string& lesson) { lessonOf(lesson); });
}

/// A lesson whose prose is this, with one claim "missing".
std::string withProse(const std::string& prose) {
    return kHead + "[[step]]\ntitle = 'A'\nprose = '''\nIt begins\nso: " + prose + "\n'''\n" + kClaim +
           "says = 'W'\nname = 'missing'\n";
}

/// How often each reference stands in a file, but for the claims' own sentences, which are not translated.
std::map<std::string, int> referencesIn(const std::filesystem::path& file) {
    static const std::regex kSays("\nsays = [^\n]*"), kReference("\\{[A-Za-z0-9_-]+(:[0-9%-]+)?\\}");
    const std::string text = std::regex_replace(readAll(file), kSays, "");
    std::map<std::string, int> references;
    for (std::sregex_iterator found(text.begin(), text.end(), kReference), end; found != end; ++found)
        ++references[found->str()];
    return references;
}

}  // namespace

TEST_CASE("a reference shows a claim's number as its format says") {
    CHECK(shown("no number") == "no number");
    CHECK(shown("{kept}") == "0.8612");
    CHECK(shown("a {kept:2}, b {kept:0}.") == "a 0.86, b 1.");
    CHECK(shown("{kept:%} {kept:1%} {kept:100}") == "86 % 86.1 % 86");
    CHECK(shown("{kept:1-%} {kept:1-1%} {kept:1-2} {kept:1-100}") == "14 % 13.9 % 0.14 14");
    CHECK(shown("{rays} {many:0} {many:1}") == "69 904 1 234 568 1 234 567.9");
    CHECK(shown("{low:2} {low:0} {low:%}") == "\u22120.25 0 \u221225 %");
    NamedNumbers comma = kNumbers;
    comma.decimalPoint = ",";
    CHECK(withNumbers("{kept:2} {many:1}", comma) == "0,86 1 234 567,9");
}

TEST_CASE("a backslash before a brace takes away its meaning, and leaves other escapes to the prose") {
    CHECK(shown("\\{kept\\}") == "{kept}");
    CHECK(shown("\\\\{kept:1} \\* \\") == "\\\\0.9 \\* \\");
    CHECK(plainText(lessonOf(withProse("\\{a\\} is \\*a\\*")).steps[0].prose) == "It begins so: {a} is *a*");
}

TEST_CASE("prose, questions, goals and claims name numbers, also of later steps") {
    const Lesson lesson = lessonOf(
        kHead + "[[step]]\ntitle = 'A'\nprose = '''\n**{missing:%}** are missing\n\n$ q = {two}\n'''\n" +
        "[step.question]\nask = 'Why {missing:2}?'\nanswer = '`{two:1}`'\n" +
        "[step.goal]\nsays = 'Reach {two}.'\nreach = 'rays'\natLeast = 3\n" +
        "[[step]]\ntitle = 'B'\nprose = 'C'\n" + kClaim + "name = 'missing'\nsays = '{missing:%} are'\n" +
        "[[step.claim]]\nname = 'two'\nsays = 'W'\nmeasure = 'rays'\natMost = 2\n");
    const Step& first = lesson.steps.at(0);
    CHECK(plainText(first.prose) == "56 % are missing\nq = 2");
    CHECK(first.prose.at(0).spans.at(0).style == SpanStyle::strong);
    CHECK(plainText(first.question->ask) == "Why 0.56?");
    CHECK(plainText(first.question->answer) == "2.0");
    CHECK(first.goal->says == "Reach 2.");
    const std::vector<Claim>& claims = lesson.steps.at(1).claims;
    CHECK(claims.at(0).name == "missing");
    CHECK(claims.at(0).says == "56 % are");
    CHECK(claims.at(1).name == "two");
}

TEST_CASE("references that cannot be written out are told with their place") {
    check(withProse("a ^{mising:%} b"), {"{mising} names no claim", "did you mean \"missing\"?"});
    check(withProse("a {missing} ^{missing:} b"), {"{missing:}", "no format", "{missing:1%}"});
    for (const std::string format : {"2f", "12", "%1", "1-", "x", "-%", " 2", "1%%"})
        check(withProse("^{missing:" + format + "}"), {"no format that is known", "{missing:2}"});
    check(withProse("^{missing"), {"never closed", "\\{"});
    check(withProse("^{missing {missing}"), {"never closed"});
    check(withProse("a ^} b"), {"} closes nothing", "\\}", "\\\\} between"});
    check(withProse("^{} b"), {"names no claim", "expected \"missing\""});
    check(kHead + "[[step]]\ntitle = 'A'\nprose = 'B ^{none}'\n", {"expected a [[step.claim]] with that"});
    check(withProse("x") + "[[step.claim]]\nmeasure = 'rays'\nequals = 1\nsays = 'a ^{missing:z}'\n",
          {"\"says\"", "no format"});
    // Markup is told where it stands, whatever numbers stand before it.
    check(withProse("{missing:%} and ^**never closed"), {"** is never closed"});
}

TEST_CASE("names of claims are checked, each is given once") {
    const std::string good = withProse("{missing}");
    const std::string next = "[[step.claim]]\nsays = 'V'\nmeasure = 'rays'\nequals = 1\nname = ";
    check(good + next + "^'missing'\n", {"two claims have the name \"missing\""});
    check(good + next + "^'two words'\n", {"\"two words\"", "expected letters"});
    check(good + next + "^''\n", {"\"name\""});
    check(good + next + "^7\n", {"\"name\" is a whole number"});
    // The claim's own fault is what is told, not that its number is missing in a text.
    check(withProse("{other}") + "^[[step.claim]]\nsays = 'V'\nmeasure = 'rays'\nname = 'other'\n",
          {"the claim has no number"});
}

TEST_CASE("a translation shows the same numbers as its language writes them") {
    const TempFolder folder;
    folder.write("room.toml", kRoom);
    const std::filesystem::path file = folder.write("01-light.toml", withProse("{missing:%}"));
    const std::string head = "title = 'L'\nsection = 'A'\n";
    const std::string step = "[[step]]\ntitle = 'E'\nprose = 'Es sind {missing:%} oder {missing:2}.'\n";
    const auto german = [&](const std::string& text) {
        folder.write("de/01-light.toml", text);
        Lesson lesson = loadLesson(file);
        translateLesson(lesson, std::string("de"));
        return plainText(lesson.steps.at(0).prose);
    };
    CHECK(german(head + step) == "Es sind 56 % oder 0.56.");
    CHECK(german(head + "decimalPoint = ','\n" + step) == "Es sind 56 % oder 0,56.");
    const std::string name = (folder.path / "de" / "01-light.toml").string();
    checkErrors({{head + "[[step]]\ntitle = 'E'\nprose = 'Es ^{fehlt:%}'\n", {"{fehlt} names no claim"}},
                 {head + "decimalPoint = ^';'\n" + step, {"\"decimalPoint\" is \";\""}}},
                name, [&](const std::string& text) { german(text); });
}

TEST_CASE("the number of a claim is what its lesson shows") {
    const std::string text = withProse("{missing:%}");
    std::string other = text;
    other.replace(other.find("0.56"), 4, "0.57");
    CHECK(plainText(lessonOf(text).steps[0].prose) == "It begins so: 56 %");
    CHECK(plainText(lessonOf(other).steps[0].prose) == "It begins so: 57 %");
}

TEST_CASE("numbers in bold that are typed are found with their places") {
    const TempFolder folder;
    const auto file =
        folder.write("01-x.toml", kHead +
                                      "[[step]]\ntitle = '**1**'\nprose = '''\n2 * 3, **four**, "
                                      "**5 %**\n**{a:2}** and **six\n7**\n'''\n"
                                      "[step.question]\nask = '**8**?'\nanswer = '9 **{a} of 10**'\n");
    CHECK(typedNumbers(file) ==
          std::vector<TypedNumber>{{{7, 18}, "5 %"}, {{8, 15}, "six\n7"}, {{12, 8}, "8"}});
}

TEST_CASE("in both languages of the course the same numbers are a claim's") {
    const std::filesystem::path folder = std::filesystem::path(LESSON_SCENES).parent_path();
    std::size_t references = 0;
    for (const LessonEntry& entry : listLessons(folder)) {
        CAPTURE(entry.slug);
        const auto english = referencesIn(entry.path);
        CHECK(english == referencesIn(folder / "de" / entry.path.filename()));
        references += english.size();
    }
    CHECK(references > 50);
}
