// Does the window speak another language, whole, and without losing what is on it?
#include <doctest/doctest.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <set>

#include "app/draw_text.h"
#include "app/key_help.h"
#include "app/key_words.h"
#include "app/language.h"
#include "app/message_words.h"
#include "app/opening.h"
#include "app/plot_tables.h"
#include "app/run_text.h"
#include "app/state_text.h"
#include "app/tree_json.h"
#include "core/estimators.h"
#include "core/requirements/requirements.h"
#include "lessons/input_error.h"
#include "lessons/lesson_file.h"
#include "lessons/lesson_list.h"
#include "lessons/scene_file.h"
#include "lessons/wall_point.h"
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
    "step_text.cpp",       "run_text.cpp",           "numbers_panel.cpp",      "code_panel.cpp",
    "lesson_panel.cpp",    "controls_panel.cpp",     "makers_panel.cpp",       "plots.cpp",
    "profile_plot.cpp",    "eye_strip.cpp",          "canvas_field.cpp",       "canvas_rays.cpp",
    "canvas_panel.cpp",    "help_overlay.cpp",       "edit_panel.cpp",         "inspector.cpp",
    "doable.cpp",          "offer_editing.cpp",      "offer_settings.cpp",     "palette_panel.cpp",
    "files_panel.cpp",     "drawn_curve.cpp",        "samples_panel.cpp",      "state_text.cpp",
    "canvas_words.cpp",    "plot_words.cpp",         "number_words.cpp",       "scene_words.cpp",
    "light_progress.cpp",  "edit_commands.cpp",      "strategies_panel.cpp",   "trade_panel.cpp",
    "trade_words.cpp",     "requirements_panel.cpp", "requirements_words.cpp", "extremes_panel.cpp",
    "instrument_words.cpp"};

/// Files that read what a teacher wrote, and refuse it.
constexpr const char* kReaders[] = {
    "lessons/atomic_file.cpp",        "lessons/claim_reader.cpp",     "lessons/geometry_check.cpp",
    "lessons/key_reader.h",           "lessons/lesson_reader.cpp",    "lessons/maker_reader.cpp",
    "lessons/lesson_list.cpp",        "lessons/material_reader.cpp",  "lessons/prose.cpp",
    "lessons/scene_expansion.cpp",    "lessons/scene_reader.cpp",     "lessons/sky_image.cpp",
    "lessons/step_values_reader.cpp", "lessons/step_values_reader.h", "lessons/suggestions.cpp",
    "lessons/table_reader.cpp",       "lessons/text_file.cpp",        "lessons/toml_document.cpp",
    "lessons/toml_hazards.cpp",       "lessons/translation.cpp",      "lessons/value_reader.cpp",
    "lessons/value_reader.h",         "lessons/wall_point.cpp",       "app/autosave.cpp",
    "app/recent_files.cpp",           "app/scene_saving.cpp",         "app/opening.cpp"};

/// A template as the messages have it: {} for each value, single braces.
std::string formOf(const std::string& words) {
    std::string form;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const char c = words[i];
        if ((c == '{' || c == '}') && words.compare(i, 2, std::string(2, c)) == 0) {
            form += c;
            ++i;
        } else if (c == '{') {
            form += "{}";
            i = std::min(words.find('}', i), words.size());
        } else {
            form += c;
        }
    }
    return form;
}

/// The first word that only English has, outside of quotes and of brackets; empty: none.
std::string englishIn(std::string_view text) {
    static const std::set<std::string, std::less<>> kEnglish{
        "the",  "of",    "is",   "are", "and",  "or",     "expected", "with",   "no",   "not",   "its",
        "that", "which", "from", "to",  "by",   "there",  "wall",     "walls",  "has",  "have",  "on",
        "it",   "as",    "file", "one", "only", "cannot", "hides",    "shines", "rays", "steps", "half"};
    std::string word;
    bool quoted = false;
    for (const char c : std::string(text) + " ") {
        if (std::isalpha(static_cast<unsigned char>(c)) || (static_cast<unsigned char>(c) & 0x80u) ||
            c == '-') {
            word += c;
            continue;
        }
        if (!quoted && kEnglish.count(word)) return word;
        word.clear();
        if (c == '"') quoted = !quoted;
        if (c == '\n') quoted = false;
    }
    return {};
}

/// A window that speaks German.
struct German {
    Rig rig{"controls:2"};
    const std::vector<Language> languages = loadLanguages();

    German() { speak(findLanguage(languages, "de")); }
    ~German() { speak(nullptr); }
    German(const German&) = delete;
    German& operator=(const German&) = delete;

    void expectGerman(const std::string& message) const {
        CAPTURE(message);
        const std::string told = trMessage(message);
        CHECK(told != message);
        CHECK_MESSAGE(englishIn(told).empty(), told);
    }
};

/// A room with a mirror, a box in the way of its lamp, and a glass that P may lie in.
constexpr const char* kRoom = R"(
[material.silver]
type = "mirror"
[material.clear]
type = "dielectric"
[[segment]]
name = "floor"
a = [0, 0]
b = [4, 0]
[[segment]]
name = "lamp"
a = [3, 3]
b = [1, 3]
emission = 1
[[box]]
name = "table"
min = [1.5, 1]
max = [2.5, 1.5]
MATERIAL
)";

std::string roomOf(const std::string& material) {
    std::string text = kRoom;
    return text.replace(text.find("MATERIAL"), 8, material.empty() ? "" : "material = '" + material + "'");
}

}  // namespace

TEST_CASE("a language keeps every value in braces, and a file that does not is refused with its place") {
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

TEST_CASE("numbers that are shown have the language's point, and files have a point in all of them") {
    AppState state = openLesson(courseLessons(), LessonRef{"trade", 5});
    apply(state, SetLanguage{"de"});
    Rig rig(std::move(state));
    rig.settle();
    CHECK(shown(0.5) == "0,5");
    CHECK(shown(Rgb(0.5, 0.25, 2.0)) == "0,5; 0,25; 2");
    CHECK(say("{:.2f} in {} of {}", 1.5, 3, "a.b") == "1,50 in 3 of a.b");
    CHECK(stateText(rig.state()).find(" 0,") != std::string::npos);
    for (const Widget& widget : rig.session.widgets.widgets)
        CHECK(widget.name.find("0.6 %") == std::string::npos);
    const std::string table = profileTable(rig.state());
    CHECK(table.find("0.") != std::string::npos);
    CHECK(table.find("\"0,") == std::string::npos);
    rig.apply(SetLanguage{""});
    rig.driver.frames(1);
    CHECK(shown(0.5) == "0.5");
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
    const German speaking;
    const Language* german = findLanguage(speaking.languages, "de");
    REQUIRE(german != nullptr);
    std::istringstream kept(
        fileText(std::filesystem::path(HALFDISK_ROOT) / "tests/app/data/not_translated.txt"));
    std::set<std::string> same;
    for (std::string line; std::getline(kept, line);) same.insert(line);
    REQUIRE(same.size() > 5);
    const auto check = [&](const std::string& words, const std::string& where) {
        if (!hasWords(words) || same.count(words)) return;
        const std::string form = formOf(words);
        CHECK_MESSAGE((german->words.count(words) == 1 || trMessage(form) != form), where, ": ", words);
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
    table(kViews, "kViews");
    table(kControls, "kControls");
    table(kEventKinds, "kEventKinds");
    table(kPathEventKinds, "kPathEventKinds");
    table(kKeyHelp, "kKeyHelp");
    for (const LessonEntry& entry : listLessons(courseLessons()))
        check(loadLesson(entry.path).scene.title, "a scene's title");
    // What the readers of files say; pieces that are joined to such a message by suggestions.cpp and others.
    const std::set<std::string> pieces{"expected ",
                                       "expected one of ",
                                       "; did you mean \"{}\"?",
                                       " or ",
                                       " and {} more",
                                       " if smooth",
                                       "Error while ",
                                       "{} while {}",
                                       "each edge would span {} degrees, expected at most {}{}",
                                       "\"{}\" has {}, expected {}",
                                       "\"{}\" has {}, expected at least {}",
                                       "\"{}\" has {}, expected one number or three [red, green, blue]",
                                       "parameter of {}",
                                       "a {}number from {:g} to {:g}",
                                       "whole ",
                                       "{}: its {} is that of {}, expected another",
                                       "a list of files"};
    for (const char* file : kReaders)
        for (const std::string& words : literalsOf(fileText(std::filesystem::path(HALFDISK_ROOT) / file)))
            if (words.find(' ') != std::string::npos && pieces.count(words) == 0) check(words, file);
    for (const EstimatorInfo* info : estimators()) {
        check(std::string(info->title), "estimators");
        check(std::string(info->meaning), "estimators");
        table(info->params, "parameters");
    }
}

TEST_CASE("a message is told by its form, its values and its place stay, and what is unknown stays whole") {
    const Language language = parseLanguage(
        "name = 'X'\n[words]\n'all of it' = 'alles'\n[messages]\n'{} is {}, expected {}' = '<{}> ist <{}>, "
        "nicht "
        "<{}>'\n'{} is red' = '{} ist rot'\n'a whole number' = 'eine Zahl'\n",
        "x.toml", "x");
    Rig rig("controls:2");
    speak(&language);
    CHECK(trMessage("all of it") == "alles");
    CHECK(trMessage("x is 3, expected a whole number") == "<x> ist <3>, nicht <eine Zahl>");
    CHECK(trMessage("/a b/c.toml:3:14: all of it") == "/a b/c.toml:3:14: alles");
    CHECK(trMessage("the wall is red") == "the wall ist rot");
    CHECK(trMessage("c.toml: one: two is red") == "c.toml: one: two ist rot");
    CHECK(trMessage("nothing of this kind: at all") == "nothing of this kind: at all");
    CHECK(trMessage("") == "");
    CHECK(trMessage(": : : :") == ": : : :");
    speak(nullptr);
    CHECK(trMessage("all of it") == "all of it");
}

TEST_CASE("keys have one name in a language, wherever they are told") {
    Rig rig("controls:2");
    CHECK(keyWords("Ctrl Z  Ctrl Y") == "Ctrl Z  Ctrl Y");
    CHECK(withKey("write the scene file", "Ctrl S") == "write the scene file (Ctrl S)");
    const German german;
    CHECK(keyWords("Ctrl Z  Ctrl Y") == "Strg Z  Strg Y");
    CHECK(keyWords("Page Down, N") == "Bild \u2193, N");
    CHECK(keyWords("Homework") == "Homework");
    CHECK(keyWords("") == "");
    CHECK(withKey("write the scene file", keyOf(KeyRow::files)) == "die Szenendatei schreiben (Strg S)");
    const auto expectNone = [](const std::string& words) {
        for (const char* name :
             {"Ctrl", "Shift", "Page Up", "Page Down", "Home", "Delete", "Escape", "arrow"})
            CHECK_MESSAGE(words.find(name) == std::string::npos, words);
    };
    for (const KeyHelp& row : kKeyHelp) expectNone(keyWords(row.keys));
    for (const auto& [english, words] : findLanguage(german.languages, "de")->words) expectNone(words);
}

TEST_CASE("every refusal of every estimator is German in German") {
    const German german;
    std::set<std::string> refusing;
    std::size_t refusals = 0;
    const auto ask = [&](const EstimatorInfo& info, const Problem& problem, const ParamValues& params) {
        std::string refusal = refusalOf(info, problem, params);
        try {
            if (refusal.empty()) (void)info.make(problem, params);
        } catch (const std::invalid_argument& found) {  // on the way
            refusal = found.what();
        }
        if (refusal.empty()) return;
        ++refusals;
        refusing.insert(std::string(info.id));
        german.expectGerman(refusal);
    };
    for (const char* material : {"", "silver", "clear"}) {
        const Scene scene = expandScene(parseScene(roomOf(material), "room.toml", {}));
        const SegmentIndex index(scene);
        const Sensor sensors[] = {Probe{{Vec2(2.0, 1.25), Vec2(0.0, 1.0)}},
                                  Probe{{Vec2(2.0, 0.0), Vec2(0.0, 1.0)}},
                                  Look{Vec2(0.5, 0.5), Vec2(1.0, 0.0)},
                                  EyeStrip{Eye{Vec2(0.5, 0.5), Vec2(1.0, 0.0)}, 8},
                                  Profile{{0}, 8},
                                  Profile{{}, 8},
                                  Profile{{0, 0}, 8},
                                  Profile{{99}, 8},
                                  Field{Vec2(0.0), Vec2(1.0), 4, 4},
                                  Field{Vec2(0.0), Vec2(0.0), 4, 4}};
        for (const EstimatorInfo* info : estimators())
            for (const Sensor& sensor : sensors)
                for (const std::uint32_t depth : {0u, 2u, 65u, 1000u}) {
                    ask(*info, {index, sensor, depth}, initialValues(*info));
                    for (std::size_t i = 0; i < info->params.size() && depth == 2; ++i) {
                        ParamValues params = initialValues(*info);
                        params[i] = info->params[i].choices.empty() ? info->params[i].most : 1e9;
                        ask(*info, {index, sensor, depth}, params);
                        params[i] = -1e300;
                        ask(*info, {index, sensor, depth}, params);
                    }
                }
    }
    CHECK(refusing.size() == std::size(estimators()));
    CHECK(refusals > 100);
}

TEST_CASE("every reason of every requirement is German in German, and what a scene may require too") {
    const German german;
    for (const RequirementInfo& info : kRequirements)
        for (const std::string_view words : {info.title, info.asks, info.fixed})
            if (!words.empty()) german.expectGerman(std::string(words));
    for (const auto& entry : std::filesystem::directory_iterator(courseLessons() / "scenes")) {
        if (entry.path().extension() != ".toml") continue;
        CAPTURE(entry.path().filename().string());
        const Scene scene = expandScene(loadScene(entry.path()));
        const SegmentIndex index(scene);
        const Sensor sensor = Profile{{0}, 8};
        const RequirementsQuestion question{.index = index, .sensor = sensor, .effort = 0.02};
        const RequirementsAnswer answer = requirementsOf(question);
        for (const Requirement& found : answer.requirements) german.expectGerman(found.reason);
        if (!answer.loses.empty()) german.expectGerman(fmt::format("This plan {}.", answer.loses));
        RequirementsQuestion forced = question;
        forced.forced = {{RequirementId::lightSampling, 0}, {RequirementId::mis, 1}};
        try {
            (void)replanned(forced, answer);
            FAIL("no refusal");
        } catch (const std::invalid_argument& refused) {
            german.expectGerman(refused.what());
        }
    }
}

TEST_CASE("what is wrong with a file is told in German, and where it is stays") {
    const German german;
    const std::string wall = "[[segment]]\nname = 'w'\na = [0, 0]\nb = [1, 0]\n";
    const std::string scenes[] = {
        "x = 1",
        "a = [",
        "a = ",
        "[[segment]]\na = [0]\nb = [1, 0]",
        "[[segment]]\nb = [1, 0]",
        "[[segment]]\na = [0, 0]\nb = [0, 0]",
        wall + wall,
        wall + "material = 'gold'",
        "[material.m]\ntype = 'miror'\n" + wall,
        "[material.m]\nalbedo = 2\n" + wall,
        "title = 3",
        "environment = { radiance = -1 }",
        "environment = { image = 'x.png', strip = [1] }",
        "eye = []",
        "[eye]\nposition = [0, 0]\ndirection = [0, 0]",
        "[[light]]\ntype = 'point'",
        "[[light]]\nx = 1",
        "[[circle]]\ncenter = [0, 0]\nradius = 1\nsegments = 2",
        "[[polyline]]\npoints = [[0, 0]]",
        "[[box]]\nmin = [1, 1]\nmax = [0, 0]",
        "[[arc]]\ncenter = [0, 0]\nradius = 1\nfrom = 0\nto = 0\nsegments = 3",
        "[[lens]]\ncenter = [0, 0]\nheight = 4\nthickness = 0.1\nradius = [1, 1]\nsegments = 8",
        wall + "twoSided = 1",
        wall + "emission = 'much'",
        "\xff",
        "title = \"a\ntitle = 'b'",
        "\xc3\xa4 = 1",
        "[material.g]\ntype = 'dielectric'\n" + wall + "material = 'g'\nemission = 1",
        "title = 'a'\ntitle = 'b'",
        "[material.m]\ntype = 'mix'\n" + wall,
        "title = 2000-01-01",
        "[[segment]]\nname = 'a:b'\n"};
    for (const std::string& text : scenes) {
        CAPTURE(text);
        try {
            (void)parseScene(text, "my scene.toml", {});
            FAIL("no error");
        } catch (const InputError& error) {
            const std::string told = trMessage(error.what());
            const std::string place = fmt::format("my scene.toml:{}:{}: ", error.line, error.column);
            CHECK(told.substr(0, place.size()) == place);
            german.expectGerman(error.what());
        }
    }
    const auto failing = [&](const auto& read) {
        try {
            read();
            FAIL("no error");
        } catch (const InputError& error) {
            german.expectGerman(error.what());
        }
    };
    failing([] { (void)loadScene("/nowhere/room.toml"); });
    failing([] { (void)loadScene("/"); });
    failing([] { (void)listLessons("/nowhere"); });
    failing([] { (void)parseLessonRef("gather:x"); });
    const auto lessons = listLessons(courseLessons());
    failing([&] { (void)findLesson(lessons, {"gathr", 1}); });
    const Lesson lesson = loadLesson(findLesson(lessons, {"gather", 1}).path);
    failing([&] { (void)stepIndex(lesson, {"gather", 99}); });
    const Scene scene = expandScene(lesson.scene);
    for (const char* place : {"floor", "flor:0.5", "floor:2"})
        failing([&] { (void)parseWallPoint(place, scene); });
    const std::string head = "title = 'T'\nsection = 'S'\nscene = 's.toml'\n",
                      step = "[[step]]\ntitle = 'A'\n";
    const std::string all = head + step + "prose = 'P'\n";
    const std::string claim = "[[step.claim]]\nsays = '{a:x} {b}'\nmeasure = 'rays'\nequals = 1\nname = '";
    const std::string texts[] = {"",
                                 head,
                                 head + step,
                                 head + "[step]",
                                 head + step + "prose = 'a *b'",
                                 head + step + "prose = 'a [ray] b'",
                                 head + step + "prose = 'a {ray} b'",
                                 head + step + "prose = 'a {ray b'",
                                 head + step + "prose = 'a } b'",
                                 all + claim + "b'",
                                 all + claim + "a'",
                                 all + claim + "two words'",
                                 all + claim + "a'\n" + claim + "a'",
                                 all + "unlock = ['seed']",
                                 all + "unlock = 'sed'",
                                 all + "show = ['ray']",
                                 all + "listing = [1, 1]",
                                 all + "[step.set]\nsamples = 0",
                                 all + "[step.set]\nat = 'flor:0'",
                                 all + "[step.set]\nestimator = 'pth'",
                                 all + "[step.set]\nestimator = 'path'\nparams = { x = 1 }",
                                 all + "[step.set]\nestimator = 'path'\nparams = { roulette = 1.5 }",
                                 all + "[step.goal]\nsays = 'a'\nreach = 'rays'",
                                 all + "[[step.claim]]\nsays = 'a'\nmeasure = 'rays'"};
    const SceneLoader loader = [&](const std::filesystem::path&) { return lesson.scene; };
    for (const std::string& text : texts) {
        CAPTURE(text);
        failing([&] { (void)parseLesson(text, "01-mine.toml", loader); });
    }
    failing([&] { (void)parseLesson(all, "mine.toml", loader); });
}

TEST_CASE("the words of a step are German in German, whatever it shows and whose run it is") {
    const auto expectGerman = [](AppState state) {
        setLanguage(state, "");
        Rig rig(std::move(state));
        rig.settle();
        const std::string english = stateText(rig.state());
        rig.apply(SetLanguage{"de"});
        const std::string german = stateText(rig.state());
        const std::set<std::string> before = [&] {
            std::set<std::string> lines;
            std::istringstream all(english);
            for (std::string line; std::getline(all, line);)
                if (hasWords(line)) lines.insert(line);
            return lines;
        }();
        // Names of walls and materials stay what the scene's file calls them.
        std::string known = german;
        for (const std::string& name : rig.state().scene->scene.segmentNames)
            for (std::string_view part :
                 {std::string_view(name), std::string_view(name).substr(0, name.rfind('.'))})
                for (std::size_t at = known.find(part); at != std::string::npos;
                     at = known.find(part, at + 1))
                    known.replace(at, part.size(), std::string(part.size(), '*'));
        std::istringstream lines(known);
        for (std::string line; std::getline(lines, line);) {
            CHECK_MESSAGE(englishIn(line).empty(), line);
            if (line.size() > 30) CHECK_MESSAGE(before.count(line) == 0, line);
        }
    };
    for (const LessonRef& ref : {LessonRef{"global-light", 1}, LessonRef{"seven-steps", 3},
                                 LessonRef{"sampling", 5}, LessonRef{"caustic", 2}, LessonRef{"both-ends", 2},
                                 LessonRef{"as-printed", 3}, LessonRef{"other-roads", 2}}) {
        CAPTURE(ref.lesson);
        expectGerman(openLesson(courseLessons(), ref));
    }
    for (const Named<Run>& run : kRuns) {
        CAPTURE(run.name);
        AppState state = openLesson(courseLessons(), LessonRef{"global-light", 1});
        for (const Named<View>& view : kViews) apply(state, SetView{view.value, true});
        apply(state, SetRun{run.value});
        apply(state, SetEvent{4});
        expectGerman(state);
    }
}
