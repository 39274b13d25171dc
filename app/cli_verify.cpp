// halfdisk verify: is what the lessons claim true?
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "app/claim_check.h"
#include "app/cli_actions.h"
#include "app/cli_arguments.h"
#include "app/cli_commands.h"
#include "app/cli_output.h"
#include "lessons/lesson_file.h"
#include "lessons/lesson_list.h"
#include "lessons/scene_file.h"
#include "lessons/translation.h"
#include "lessons/typed_numbers.h"

namespace halfdisk {
namespace {

struct VerifyTexts {
    std::vector<std::string> lessons;  ///< slugs, numbers or files; none: all
    std::optional<std::string> threads;
    bool json = false;
    bool prose = false;
};

struct Tally {
    std::size_t held = 0, failed = 0;
    Json claims = Json::array();
    Json typed = Json::array();  ///< numbers of texts that no claim measures
};

struct Wanted {
    std::filesystem::path file;
    std::optional<LessonRef> step{};  ///< none: all of them
};

std::vector<Wanted> wantedOf(const VerifyTexts& texts, const std::filesystem::path& folder) {
    std::vector<Wanted> wanted;
    if (texts.lessons.empty()) {
        for (const LessonEntry& entry : listLessons(folder)) wanted.push_back({entry.path});
        return wanted;
    }
    for (const std::string& name : texts.lessons) {
        const bool isFile = std::filesystem::path(name).extension() == ".toml";
        if (isFile) {
            wanted.push_back({name});
            continue;
        }
        const LessonRef ref = parseLessonRef(name);
        const bool oneStep = name.find(':') != std::string::npos;
        wanted.push_back(
            {findLesson(listLessons(folder), ref).path, oneStep ? std::optional(ref) : std::nullopt});
    }
    return wanted;
}

Json claimJson(const Lesson& lesson, std::size_t step, const Claim& claim, const ClaimResult& result) {
    Json object;
    object["lesson"] = lesson.slug;
    object["step"] = step + 1;
    if (!claim.name.empty()) object["name"] = claim.name;
    object["says"] = claim.says;
    object["measure"] = std::string(nameOf(kQuantities, claim.quantity));
    object["measured"] = jsonOf(result.value);
    object["of"] = jsonOf(result.of);
    object["over"] = result.over ? jsonOf(*result.over) : Json(nullptr);
    object["relation"] = std::string(nameOf(kRelations, claim.relation));
    object["number"] = claim.number;
    object["tolerance"] = claim.tolerance;
    object["holds"] = result.holds;
    object["seconds"] = result.seconds;
    object["file"] = lesson.file.string();
    object["line"] = claim.where.line;
    return object;
}

std::string measuredText(const Claim& claim, const ClaimResult& result) {
    const std::string_view quantity = nameOf(kQuantities, claim.quantity);
    if (!result.over) return fmt::format("{} is {:.6g}", quantity, result.value);
    return fmt::format("{} is {:.6g} / {:.6g} = {:.6g}", quantity, result.of, *result.over, result.value);
}

void verifyLesson(const Lesson& lesson, const std::optional<LessonRef>& only, unsigned threads, bool asJson,
                  Tally& tally) {
    const auto scene = std::make_shared<const PreparedScene>(lesson.scene);
    const std::size_t first = only ? stepIndex(lesson, *only) : 0;
    const std::size_t end = only ? first + 1 : lesson.steps.size();
    for (std::size_t step = first; step < end; ++step)
        for (const Claim& claim : lesson.steps[step].claims) {
            const ClaimResult result = checkClaim(lesson.file.string(), scene, claim, threads);
            ++(result.holds ? tally.held : tally.failed);
            tally.claims.push_back(claimJson(lesson, step, claim, result));
            const std::string measured = measuredText(claim, result), expected = expectationOf(claim);
            if (!result.holds)
                writeError(InputError(lesson.file.string(), claim.where,
                                      fmt::format("not true: \"{}\": {}, expected {}", claim.says, measured,
                                                  expected))
                               .what(),
                           true);
            if (!asJson && result.holds)
                writeOutput(fmt::format("true  {}:{}  {}\n      {}, claimed {}\n", lesson.slug, step + 1,
                                        claim.says, measured, expected));
        }
}

/// The files with a lesson's words in other languages.
std::vector<std::filesystem::path> translationsOf(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::filesystem::path words = entry.path() / file.filename();
        std::error_code ignored;
        if (std::filesystem::is_regular_file(words, ignored)) files.push_back(words);
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// Throws InputError if a lesson's words in another language are not its own.
void checkTranslations(const std::filesystem::path& file) {
    for (const std::filesystem::path& words : translationsOf(file)) {
        Lesson lesson = loadLesson(file);
        translateLesson(lesson, words);
    }
}

/// Not wrong, but nobody would notice if they were: numbers that stand in a text as they were typed.
void noteTypedNumbers(const std::filesystem::path& file, bool asJson, Tally& tally) {
    std::vector<std::filesystem::path> files = translationsOf(file);
    files.insert(files.begin(), file);
    for (const std::filesystem::path& words : files)
        for (const TypedNumber& number : typedNumbers(words)) {
            tally.typed.push_back(
                {{"file", words.string()}, {"line", number.where.line}, {"words", number.words}});
            if (!asJson)
                writeOutput(fmt::format("typed {}:{}:{}: {}\n", words.string(), number.where.line,
                                        number.where.column, number.words));
        }
}

int runVerify(const VerifyTexts& texts, const std::filesystem::path& folder) {
    const unsigned threads = threadsArgument(texts.threads);
    Tally tally;
    for (const auto& [file, step] : wantedOf(texts, folder)) {
        checkTranslations(file);
        verifyLesson(loadLesson(file), step, threads, texts.json, tally);
        if (texts.prose) noteTypedNumbers(file, texts.json, tally);
    }
    if (texts.json) {
        Json report{{"claims", tally.claims}, {"held", tally.held}, {"failed", tally.failed}};
        if (texts.prose) report["typed"] = tally.typed;
        writeJson(report);
    } else {
        const std::size_t claims = tally.held + tally.failed;
        writeOutput(fmt::format("{} claim{}, {} of them true\n", claims, claims == 1 ? "" : "s", tally.held));
        if (texts.prose)
            writeOutput(fmt::format("{} in bold as typed: no claim measures them\n",
                                    tally.typed.size() == 1
                                        ? "1 number stands"
                                        : fmt::format("{} numbers stand", tally.typed.size())));
    }
    return tally.failed == 0 ? kExitSuccess : kExitFailure;
}

}  // namespace

void addVerifyCommand(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder) {
    const auto texts = std::make_shared<VerifyTexts>();
    CLI::App* command =
        app.add_subcommand("verify", "measure what the lessons claim, and tell whether it is true");
    command
        ->add_option("lessons", texts->lessons,
                     "lessons by slug or number, one step of them (4:2), or lesson files; none: all")
        ->type_name("LESSON[:STEP]|FILE ...");
    command->add_option("--threads", texts->threads, "threads; the answer does not depend on it")
        ->type_name("T");
    command->add_flag("--json", texts->json, "print one JSON object");
    command->add_flag(
        "--prose", texts->prose,
        "also list numbers in **bold** that are typed and not a claim's: nothing measures them");
    addLessonsFolder(*command, lessonsFolder);
    command->footer(
        "A claim stands in a lesson's file: [[step.claim]] with a sentence, what is measured, and a number. "
        "Each that is "
        "not true is told with file, line and what was measured; the exit code is then 1.\n\nExamples:\n"
        "  halfdisk verify\n"
        "  halfdisk verify caustic 4 --json\n"
        "  halfdisk verify as-printed:3\n"
        "  halfdisk verify --prose\n"
        "  halfdisk verify ~/my-course/01-light.toml");
    command->callback([&chosen, texts, &lessonsFolder] {
        chosen = [texts, &lessonsFolder] { return runVerify(*texts, lessonsFolder); };
    });
}

}  // namespace halfdisk
