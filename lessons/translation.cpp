#include "lessons/translation.h"

#include <fmt/format.h>

#include "lessons/input_error.h"
#include "lessons/table_reader.h"
#include "lessons/text_file.h"
#include "lessons/text_rules.h"
#include "lessons/value_reader.h"

namespace halfdisk {
namespace {

class TranslationReader {
 public:
    TranslationReader(Lesson& lesson, const std::filesystem::path& path)
        : lesson_(lesson),
          content_(readTextFile(path)),
          file_(path.string()),
          text_{file_, content_, namedNumbers(lesson)} {}

    void read() {
        const TomlValue document = parseToml(content_, file_);
        TableReader table(file_, std::get<TomlTable>(document.data), document.where, "a translation");
        const TomlValue* title = table.required("title");
        const TomlValue* section = table.required("section");
        const TomlValue* decimalPoint = table.optional("decimalPoint");
        const TomlValue* terms = table.optional("term");
        const TomlValue* steps = table.required("step");
        table.finish();
        lesson_.title = readText(file_, "title", *title, kHeadingRule);
        lesson_.section = readText(file_, "section", *section, kHeadingRule);
        if (decimalPoint != nullptr) text_.numbers.decimalPoint = readDecimalPoint(file_, *decimalPoint);
        readTerms(terms, document.where);
        const TomlArray& tables = readArray(file_, "step", *steps, "tables [[step]]");
        expectCount("[[step]]", tables.size(), lesson_.steps.size(), steps->where);
        for (std::size_t i = 0; i < tables.size(); ++i) readStep(tables[i], lesson_.steps[i]);
    }

 private:
    void expectCount(std::string_view what, std::size_t found, std::size_t expected,
                     TextPosition where) const {
        if (found != expected)
            failAt(file_, where,
                   fmt::format("the number of {} in the translation is {}, expected {} as in {}", what, found,
                               expected, lesson_.file.filename().string()));
    }

    void readTerms(const TomlValue* terms, TextPosition where) {
        static const TomlArray kNone;
        const TomlArray& tables = terms ? readArray(file_, "term", *terms, "tables [[term]]") : kNone;
        expectCount("[[term]]", tables.size(), lesson_.terms.size(), terms ? terms->where : where);
        for (std::size_t i = 0; i < tables.size(); ++i) {
            TableReader table(file_, readTable(file_, "term", tables[i]), tables[i].where, "[[term]]");
            const TomlValue* name = table.required("name");
            const TomlValue* meaning = table.required("meaning");
            table.finish();
            Term& term = lesson_.terms[i];
            term.name = readName(file_, "name", *name);
            term.meaning = readText(file_, "meaning", *meaning, kMeaningRule);
        }
    }

    void readStep(const TomlValue& value, Step& step) {
        TableReader table(file_, readTable(file_, "step", value), value.where, "[[step]]");
        const TomlValue* title = table.required("title");
        const TomlValue* prose = table.required("prose");
        const TomlValue* ask = step.question ? table.required("ask") : nullptr;
        const TomlValue* answer = step.question ? table.required("answer") : nullptr;
        const TomlValue* goal = step.goal ? table.required("goal") : nullptr;
        table.finish();
        step.title = readText(file_, "title", *title, kHeadingRule);
        step.prose = readProse(text_, "prose", *prose, lesson_.terms);
        if (goal) step.goal->says = readWords(text_, "goal", *goal, kMeaningRule);
        if (ask)
            step.question = Question{readProse(text_, "ask", *ask, lesson_.terms),
                                     readProse(text_, "answer", *answer, lesson_.terms)};
    }

    Lesson& lesson_;
    std::string content_, file_;
    LessonText text_;
};

std::filesystem::path translationOf(const std::filesystem::path& lessonFile, const std::string& language) {
    return lessonFile.parent_path() / language / lessonFile.filename();
}

bool isThere(const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored);
}

}  // namespace

std::string readDecimalPoint(const std::string& file, const TomlValue& value) {
    std::string point = readText(file, "decimalPoint", value, {1, false, false});
    if (point != "." && point != ",")
        failAt(file, value.where,
               fmt::format("\"decimalPoint\" is \"{}\", expected \".\" or \",\"", excerpt(point)));
    return point;
}

void translateLesson(Lesson& lesson, const std::filesystem::path& file) {
    TranslationReader(lesson, file).read();
}

void translateLesson(Lesson& lesson, const std::string& language) {
    if (language.empty()) return;
    const std::filesystem::path file = translationOf(lesson.file, language);
    if (isThere(file)) translateLesson(lesson, file);
}

std::optional<Titles> translatedTitles(const std::filesystem::path& lessonFile, const std::string& language) {
    const std::filesystem::path file = translationOf(lessonFile, language);
    if (language.empty() || !isThere(file)) return std::nullopt;
    try {
        const std::string name = file.string();
        const TomlValue document = parseToml(readTextFile(file), name);
        const auto titleOf = [&](const TomlValue& value) {
            const TomlEntry* title = readTable(name, "step", value).find("title");
            return title ? readText(name, "title", title->value, kHeadingRule) : std::string();
        };
        Titles titles{titleOf(document), {}};
        if (const TomlEntry* steps = std::get<TomlTable>(document.data).find("step"))
            for (const TomlValue& step : readArray(name, "step", steps->value, "tables [[step]]"))
                titles.steps.push_back(titleOf(step));
        return titles;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}  // namespace halfdisk
