// Does the window speak another language, whole, and without losing what is on it?
#include <doctest/doctest.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <set>

#include "app/language.h"
#include "core/estimators.h"
#include "lessons/input_error.h"
#include "rig.h"

using namespace halfdisk;

namespace {

std::string fileText(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void appendUtf8(std::string& text, unsigned code) {
    if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xc0u | (code >> 6));
        text += static_cast<char>(0x80u | (code & 0x3fu));
    } else {
        text += static_cast<char>(0xe0u | (code >> 12));
        text += static_cast<char>(0x80u | ((code >> 6) & 0x3fu));
        text += static_cast<char>(0x80u | (code & 0x3fu));
    }
}

/// The string literals of a C++ source, neighbours joined, escapes resolved; those of #include lines and of
/// comments left out.
std::vector<std::string> literalsOf(const std::string& source) {
    std::vector<std::string> literals;
    bool joins = false;
    for (std::size_t i = 0; i < source.size(); ++i) {
        const char c = source[i];
        if (c == '#' || source.compare(i, 2, "//") == 0) {
            i = std::min(source.find('\n', i), source.size());
            continue;
        }
        if (c == '\'' && i > 0 && std::isdigit(static_cast<unsigned char>(source[i - 1]))) continue;
        if (c == '\'') {
            i = source.find('\'', source[i + 1] == '\\' ? i + 3 : i + 2);
            joins = false;
            continue;
        }
        if (c != '"') {
            joins = joins && std::isspace(static_cast<unsigned char>(c));
            continue;
        }
        if (!joins) literals.emplace_back();
        std::string& text = literals.back();
        for (++i; i < source.size() && source[i] != '"'; ++i) {
            if (source[i] != '\\') {
                text += source[i];
                continue;
            }
            const char kind = source[++i];
            if (kind == 'u') {
                appendUtf8(text, static_cast<unsigned>(std::stoul(source.substr(i + 1, 4), nullptr, 16)));
                i += 4;
            } else {
                text += kind == 'n' ? '\n' : kind;
            }
        }
        joins = true;
    }
    return literals;
}

/// Words that a reader would have to know English for: two letters in a row at least, and a blank or a
/// capital.
bool hasWords(std::string_view text) {
    std::size_t letters = 0, inBraces = 0;
    bool run = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '{') ++inBraces;
        if (text[i] == '}' && inBraces > 0) --inBraces;
        const bool letter = inBraces == 0 && std::isalpha(static_cast<unsigned char>(text[i]));
        letters = letter ? letters + 1 : 0;
        run = run || letters >= 3;
    }
    return run;
}

/// Files whose literals the window shows.
constexpr const char* kShown[] = {
    "step_text.cpp",    "run_text.cpp",       "numbers_panel.cpp",  "code_panel.cpp",
    "lesson_panel.cpp", "controls_panel.cpp", "makers_panel.cpp",   "plots.cpp",
    "profile_plot.cpp", "eye_strip.cpp",      "canvas_field.cpp",   "canvas_rays.cpp",
    "canvas_panel.cpp", "help_overlay.cpp",   "edit_panel.cpp",     "inspector.cpp",
    "doable.cpp",       "offer_editing.cpp",  "offer_settings.cpp", "palette_panel.cpp",
    "files_panel.cpp",  "drawn_curve.cpp",    "samples_panel.cpp",  "strategies_panel.cpp",
    "key_help.h"};

}  // namespace

TEST_CASE("a language keeps every placeholder, and a file that does not is refused with its place") {
    const std::string good = "name = 'X'\n[words]\n'a {} b {:.3f}' = 'c {} d {:.3f}'\n";
    const Language language = parseLanguage(good, "x.toml", "x");
    CHECK(language.words.at("a {} b {:.3f}") == "c {} d {:.3f}");
    for (const std::string bad :
         {"name = 'X'\n[words]\n'a {}' = 'c'\n", "name = 'X'\n[words]\n'a' = 'c {}'\n",
          "name = 'X'\n[words]\n'{} {:.1f}' = '{:.1f} {}'\n", "name = 'X'\n",
          "name = 'X'\n[words]\n'a' = 3\n"}) {
        CAPTURE(bad);
        CHECK_THROWS_AS(parseLanguage(bad, "x.toml", "x"), InputError);
    }
}

TEST_CASE("without a language all words are the source's") {
    Rig rig("controls:2");
    CHECK(tr("Reset") == "Reset");
    const Language language = parseLanguage("name = 'X'\n[words]\n'Reset' = 'Neu'\n", "x.toml", "x");
    speak(&language);
    CHECK(tr("Reset") == "Neu");
    CHECK(tr("not there") == "not there");
    CHECK(say("{} not there", 3) == "3 not there");
    speak(nullptr);
    CHECK(tr("Reset") == "Reset");
}

TEST_CASE("another language changes words, and nothing that the reader has done") {
    Rig rig(openLesson(courseLessons(), LessonRef{"seven-steps", 4}));
    rig.settle();
    rig.apply(SetEvent{9});
    const Settings settings = rig.state().settings;
    const std::uint64_t asked = rig.state().questionId;
    const std::string english = rig.state().lesson->title;
    const auto width = [&] { return rig.session.widgets.find("Lesson/Next")->rect; };
    const Rect before = width();
    rig.apply(SetLanguage{"de"});
    rig.driver.frames(2);
    CHECK(rig.state().lesson->title != english);
    CHECK(rig.state().step == 3);
    CHECK(rig.state().playback.event == 9);
    CHECK(rig.state().settings == settings);
    CHECK(rig.state().questionId == asked);
    CHECK(rig.state().banner.empty());
    CHECK(width() == before);  // the name is still the English one
    for (const LessonEntry& entry : rig.state().lessons)
        if (entry.slug == "seven-steps") CHECK(entry.title == rig.state().lesson->title);
    rig.driver.click("Lesson/Next");
    CHECK(rig.state().step == 4);
    rig.apply(SetLanguage{""});
    CHECK(rig.state().lesson->title == english);
}

TEST_CASE("the help offers every language in its own words") {
    Rig rig(openLesson(courseLessons(), LessonRef{"seven-steps", 1}));
    rig.settle();
    rig.driver.typeText("?");
    rig.driver.frames(3);
    rig.driver.click("Keys/Deutsch");
    CHECK(rig.state().language == "de");
    rig.driver.frames(2);
    rig.driver.click("Keys/English");
    CHECK(rig.state().language.empty());
}

TEST_CASE("every word that the window shows is German in German") {
    const std::vector<Language> languages = loadLanguages();
    const Language* german = findLanguage(languages, "de");
    REQUIRE(german != nullptr);
    std::istringstream kept(
        fileText(std::filesystem::path(HALFDISK_ROOT) / "tests/app/data/not_translated.txt"));
    std::set<std::string> same;
    for (std::string line; std::getline(kept, line);) same.insert(line);
    REQUIRE(same.size() > 5);
    const auto check = [&](const std::string& words, const std::string& where) {
        if (!hasWords(words) || same.count(words)) return;
        CHECK_MESSAGE(german->words.count(words) == 1, where, ": ", words);
    };
    for (const char* file : kShown)
        for (const std::string& words :
             literalsOf(fileText(std::filesystem::path(HALFDISK_ROOT) / "app" / file)))
            check(words, file);
    const auto table = [&](const auto& entries, const char* where) {
        for (const auto& entry : entries) check(std::string(entry.meaning), where);
    };
    table(kSamplers, "kSamplers");
    table(kEmitters, "kEmitters");
    table(kDefects, "kDefects");
    table(kRuns, "kRuns");
    for (const EstimatorInfo* info : estimators()) {
        check(std::string(info->title), "estimators");
        check(std::string(info->meaning), "estimators");
        table(info->params, "parameters");
    }
}
