// How does a lesson file become a Lesson, and what is refused on the way?
#include <fmt/format.h>

#include <algorithm>

#include "lessons/claim_reader.h"
#include "lessons/instruments_reader.h"
#include "lessons/lesson_file.h"
#include "lessons/maker_reader.h"
#include "lessons/scene_file.h"
#include "lessons/step_values_reader.h"
#include "lessons/table_reader.h"
#include "lessons/text_file.h"
#include "lessons/text_rules.h"
#include "lessons/value_reader.h"

namespace halfdisk {
namespace {

constexpr std::size_t kMostTerms = 200;
constexpr std::size_t kMostSteps = 200;
constexpr std::size_t kMostClaims = 100;  // of a step
constexpr std::uint64_t kMostEvents = 1'000'000'000;

class LessonReader {
 public:
    LessonReader(std::string_view text, std::filesystem::path path, const SceneLoader& sceneLoader)
        : path_(std::move(path)), file_(path_.string()), text_{file_, text}, sceneLoader_(sceneLoader) {}

    Lesson read() {
        const TomlValue document = parseToml(text_.text, file_);
        TableReader table(file_, std::get<TomlTable>(document.data), document.where, "a lesson file");
        const TomlValue* title = table.required("title");
        const TomlValue* section = table.required("section");
        const TomlValue* scene = table.required("scene");
        const TomlValue* defaults = table.optional("defaults");
        const TomlValue* terms = table.optional("term");
        const TomlValue* steps = table.required("step");
        table.finish();

        readFileName();
        lesson_.title = readText(file_, "title", *title, kHeadingRule);
        lesson_.section = readText(file_, "section", *section, kHeadingRule);
        readScene(*scene);
        if (defaults != nullptr) readValues("[defaults]", "defaults", *defaults, defaults_);
        if (terms != nullptr)
            for (const TomlValue& term : listOfTables("term", *terms, kMostTerms)) readTerm(term);
        text_.numbers = readNamedNumbers(file_, *steps);
        for (const TomlValue& step : listOfTables("step", *steps, kMostSteps)) readStep(step);
        if (lesson_.steps.empty())
            failAt(file_, steps->where, "\"step\" has no elements, expected at least one [[step]]");
        return std::move(lesson_);
    }

 private:
    const TomlArray& listOfTables(std::string_view key, const TomlValue& value, std::size_t most) const {
        const TomlArray& tables = readArray(file_, key, value, fmt::format("tables [[{}]]", key));
        if (tables.size() > most)
            failAt(file_, tables[most].where,
                   fmt::format("the lesson has {} tables [[{}]], expected at most {}", tables.size(), key,
                               most));
        return tables;
    }

    void readFileName() {
        const auto name = parseLessonFileName(path_);
        if (!name) throw InputError(file_, "the file's name has no number and slug, expected NN-slug.toml");
        lesson_.number = name->number;
        lesson_.slug = name->slug;
        lesson_.file = path_;
    }

    void readScene(const TomlValue& value) {
        const std::string name = readText(file_, "scene", value, kHeadingRule);
        lesson_.scenePath = path_.parent_path() / name;
        try {
            lesson_.scene = sceneLoader_(lesson_.scenePath);
        } catch (const InputError& error) {
            if (error.line > 0) throw;
            failAt(file_, value.where, fmt::format("the scene cannot be used: {}", error.what()));
        }
        scene_ = expandScene(lesson_.scene);
        if (scene_.segments.empty())
            failAt(file_, value.where, "the scene has no walls, expected at least one: P stands on a wall");
    }

    /// The keys of [defaults] and of [step.set]; those that are there replace what `values` has.
    void readValues(std::string what, std::string_view key, const TomlValue& value, StepValues& values) {
        TableReader table(file_, readTable(file_, key, value), value.where, std::move(what));
        readSettings(table, scene_, {kMostLessonSamples, kMostLessonDepth}, values.settings, values.at);
        readMakers(table, values.makers);
        if (const TomlValue* scale = table.optional("scale"))
            values.scale = readNamed(file_, "scale", *scale, kFieldScales);
        readInstruments(table, values.instruments);
        if (const TomlValue* run = table.optional("run")) values.run = readNamed(file_, "run", *run, kRuns);
        if (const TomlValue* event = table.optional("event"))
            values.event = static_cast<std::uint32_t>(readWhole(file_, "event", *event, {0, kMostEvents}));
        pixelAt_.reset();
        if (const TomlValue* pixel = table.optional("pixel")) {
            values.pixel = readPixel(*pixel);
            pixelAt_ = pixel->where;
        }
        if (const TomlValue* whose = table.optional("pixelOf")) {
            values.pixelOf = readNamed(file_, "pixelOf", *whose, kSides);
            if (values.pixelOf == Side::second && !values.makers.second)
                failAt(file_, whose->where,
                       "\"pixelOf\" is the second of two, expected \"against\" beside it");
        }
        table.finish();
    }

    std::uint32_t readPixel(const TomlValue& value) const {
        if (!scene_.eye)
            failAt(file_, value.where, "\"pixel\" is one of the eye's strip, expected a scene with an [eye]");
        return static_cast<std::uint32_t>(readWhole(file_, "pixel", value, {0, kEyeStripPixels - 1}));
    }

    void readTerm(const TomlValue& value) {
        TableReader table(file_, readTable(file_, "term", value), value.where, "[[term]]");
        const TomlValue* name = table.required("name");
        const TomlValue* meaning = table.required("meaning");
        table.finish();
        Term term{readName(file_, "name", *name), readText(file_, "meaning", *meaning, kMeaningRule)};
        term.topic = topicOf(term.name);
        if (term.name.find_first_of("[]|\\*`") != std::string::npos)
            failAt(file_, name->where, "\"name\" holds one of [ ] | \\ * `, expected a term without markup");
        if (findTerm(lesson_.terms, term.name) != lesson_.terms.size())
            failAt(file_, name->where,
                   fmt::format("the term \"{}\" is explained twice, expected once", excerpt(term.name)));
        lesson_.terms.push_back(std::move(term));
    }

    void readStep(const TomlValue& value) {
        TableReader table(file_, readTable(file_, "step", value), value.where, "[[step]]");
        const TomlValue* title = table.required("title");
        const TomlValue* prose = table.required("prose");
        const TomlValue* listing = table.optional("listing");
        const TomlValue* show = table.optional("show");
        const TomlValue* unlock = table.optional("unlock");
        const TomlValue* set = table.optional("set");
        const TomlValue* goal = table.optional("goal");
        const TomlValue* question = table.optional("question");
        const TomlValue* claims = table.optional("claim");
        table.finish();

        Step step;
        step.title = readText(file_, "title", *title, kHeadingRule);
        step.prose = readProse("prose", *prose);
        if (listing != nullptr) step.listing = readListing(*listing);
        if (show != nullptr) readSet(file_, "show", *show, "an array of views", kViews, step.show);
        if (unlock != nullptr) step.unlock = readUnlock(*unlock);
        step.values = defaults_;
        pixelAt_.reset();
        if (set != nullptr) readValues("[step.set]", "set", *set, step.values);
        if (step.values.pixel && !step.show.has(View::eye))
            failAt(file_, pixelAt_.value_or(show != nullptr ? show->where : value.where),
                   "\"pixel\" is one of the eye's strip, expected \"eye\" in \"show\"");
        if (goal != nullptr) step.goal = readGoal(*goal);
        if (step.goal && step.goal->quantity == GoalQuantity::drawn && !step.show.has(View::integrand))
            failAt(file_, goal->where,
                   "a curve is \"drawn\" in the integrand, expected \"integrand\" in \"show\"");
        if (step.goal && step.goal->quantity == GoalQuantity::line && !step.show.has(View::code))
            failAt(file_, goal->where, "a \"line\" is one of the code, expected \"code\" in \"show\"");
        if (question != nullptr) step.question = readQuestion(*question);
        if (claims != nullptr)
            for (const TomlValue& claim : listOfTables("claim", *claims, kMostClaims))
                step.claims.push_back(readClaim(text_, claim, scene_, step.values));
        lesson_.steps.push_back(std::move(step));
    }

    std::vector<int> readListing(const TomlValue& value) const {
        std::vector<int> lines;
        for (const TomlValue& element : readArray(file_, "listing", value, "an array of line numbers")) {
            const int line = static_cast<int>(readWhole(file_, "listing", element, {1, kListingLines}));
            if (std::find(lines.begin(), lines.end(), line) != lines.end())
                failAt(file_, element.where,
                       fmt::format("\"listing\" has line {} twice, expected it once", line));
            lines.push_back(line);
        }
        return lines;
    }

    Control readUnlock(const TomlValue& value) const {
        if (std::holds_alternative<TomlArray>(value.data))
            failAt(file_, value.where,
                   "\"unlock\" is an array, expected one control: a step unlocks at most one");
        return readNamed(file_, "unlock", value, kControls);
    }

    Goal readGoal(const TomlValue& value) const {
        TableReader table(file_, readTable(file_, "goal", value), value.where, "[step.goal]");
        const TomlValue* says = table.required("says");
        const TomlValue* reach = table.required("reach");
        const TomlValue* atLeast = table.optional("atLeast");
        const TomlValue* atMost = table.optional("atMost");
        const TomlValue* lines = table.optional("lines");
        table.finish();
        const GoalQuantity quantity = readNamed(file_, "reach", *reach, kGoalQuantities);
        const std::string says_ = readWords(text_, "says", *says, kMeaningRule);
        if (quantity == GoalQuantity::line) return lineGoal(says_, value, lines, atLeast, atMost);
        if (lines != nullptr)
            failAt(file_, lines->where, "\"lines\" belong to a goal that reaches a \"line\"");
        if (atLeast != nullptr && atMost != nullptr)
            failAt(file_, atMost->where,
                   "the goal has two numbers, expected one of \"atLeast\" and \"atMost\"");
        if (atLeast == nullptr && atMost == nullptr)
            failAt(file_, value.where, "the goal has no number, expected \"atLeast\" or \"atMost\"");
        constexpr NumberRule kNumberRule{-1e300, 1e300, "a finite number"};
        constexpr NumberRule kShareRule{0.0, 1.0, "a number from 0 to 1: how well the curves agree"};
        if (quantity == GoalQuantity::drawn && atMost != nullptr)
            failAt(file_, atMost->where, "a curve is to agree well, expected \"atLeast\"");
        if (quantity == GoalQuantity::drawn) readNumber(file_, "atLeast", *atLeast, kShareRule);
        const Relation relation = atLeast != nullptr ? Relation::atLeast : Relation::atMost;
        return {says_,
                quantity,
                relation,
                readNumber(file_, nameOf(kRelations, relation), atLeast != nullptr ? *atLeast : *atMost,
                           kNumberRule),
                {}};
    }

    Goal lineGoal(const std::string& says, const TomlValue& goal, const TomlValue* lines,
                  const TomlValue* atLeast, const TomlValue* atMost) const {
        if (atLeast != nullptr || atMost != nullptr)
            failAt(file_, (atLeast ? atLeast : atMost)->where,
                   "a \"line\" has no number, expected \"lines\": those that are right");
        if (lines == nullptr)
            failAt(file_, goal.where,
                   "the goal has no \"lines\", expected those of the listing that are right");
        std::vector<int> right = readListing(*lines);
        if (right.empty()) failAt(file_, lines->where, "\"lines\" is empty, expected at least one line");
        return {says, GoalQuantity::line, Relation::atLeast, 1.0, std::move(right)};
    }

    Question readQuestion(const TomlValue& value) const {
        TableReader table(file_, readTable(file_, "question", value), value.where, "[step.question]");
        const TomlValue* ask = table.required("ask");
        const TomlValue* answer = table.required("answer");
        table.finish();
        return {readProse("ask", *ask), readProse("answer", *answer)};
    }

    Prose readProse(std::string_view key, const TomlValue& value) const {
        return halfdisk::readProse(text_, key, value, lesson_.terms);
    }

    std::filesystem::path path_;
    std::string file_;
    LessonText text_;
    const SceneLoader& sceneLoader_;
    Lesson lesson_;
    Scene scene_;
    StepValues defaults_;
    std::optional<TextPosition> pixelAt_;  // in the table of values that was read last
};

}  // namespace

std::optional<LessonFileName> parseLessonFileName(const std::filesystem::path& file) {
    constexpr std::string_view kDigits = "0123456789";
    const std::string stem = file.stem().string();
    const std::size_t digits = std::min(stem.find_first_not_of(kDigits), stem.size());
    if (file.extension() != ".toml" || digits < 1 || digits > 4 || stem.substr(digits, 1) != "-")
        return std::nullopt;
    const std::string slug = stem.substr(digits + 1);
    const bool isNumber = slug.find_first_not_of(kDigits) == std::string::npos;  // also if it is empty
    if (isNumber || slug.find_first_of(": \t") != std::string::npos) return std::nullopt;
    return LessonFileName{std::stoi(stem.substr(0, digits)), slug};
}

Lesson parseLesson(std::string_view text, const std::filesystem::path& file, const SceneLoader& sceneLoader) {
    return LessonReader(text, file, sceneLoader).read();
}

Lesson loadLesson(const std::filesystem::path& file) {
    return parseLesson(readTextFile(file), file, loadScene);
}

}  // namespace halfdisk
