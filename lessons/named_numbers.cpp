#include "lessons/named_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "lessons/lesson.h"
#include "lessons/value_reader.h"

namespace halfdisk {
namespace {

constexpr std::size_t kLongestName = 40;
constexpr std::size_t kUngrouped = 4;  // digits

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

bool isNameLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || isDigit(c) || c == '-' || c == '_';
}

struct NumberFormat {
    std::optional<int> decimals{};  ///< digits after the point
    bool rest = false;              ///< 1 minus the number
    bool hundredths = false;
    bool sign = false;  ///< a percent sign behind them
};

/// `2`, `%`, `1%`, `100`, each also behind `1-`.
std::optional<NumberFormat> parseFormat(std::string_view text) {
    NumberFormat format;
    if (text.substr(0, 2) == "1-") {
        format.rest = true;
        text.remove_prefix(2);
    }
    if (!text.empty() && text.back() == '%') {
        format.hundredths = format.sign = true;
        format.decimals = 0;
        text.remove_suffix(1);
    } else if (text == "100") {
        format.hundredths = true;
        format.decimals = 0;
        text = {};
    }
    if (text.size() == 1 && isDigit(text[0])) {
        format.decimals = text[0] - '0';
        text = {};
    }
    if (!text.empty() || !format.decimals) return std::nullopt;
    return format;
}

/// 69904 as 69 904.
std::string grouped(std::string_view digits) {
    if (digits.size() <= kUngrouped) return std::string(digits);
    std::string result;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) result += ' ';
        result += digits[i];
    }
    return result;
}

std::string numberText(double value, const NumberFormat& format, std::string_view decimalPoint) {
    if (format.rest) value = 1.0 - value;
    if (format.hundredths) value *= 100.0;
    const double size = std::abs(value);
    const std::string digits =
        format.decimals ? fmt::format("{:.{}f}", size, *format.decimals) : fmt::format("{}", size);
    const std::size_t whole = std::min(digits.find_first_not_of("0123456789"), digits.size());
    const bool hasPoint = digits.substr(whole, 1) == ".";
    const bool isZero = digits.find_first_of("123456789") == std::string::npos;
    return fmt::format("{}{}{}{}{}", value < 0.0 && !isZero ? "\u2212" : "", grouped(digits.substr(0, whole)),
                       hasPoint ? decimalPoint : "", digits.substr(whole + (hasPoint ? 1 : 0)),
                       format.sign ? " %" : "");
}

/// Reads a text from its first brace on.
class ReferenceReader {
 public:
    ReferenceReader(std::string_view text, const NamedNumbers& numbers) : text_(text), numbers_(numbers) {}

    std::string read() {
        std::string result;
        for (std::size_t at = 0; at < text_.size();) {
            const char c = text_[at];
            const char next = at + 1 < text_.size() ? text_[at + 1] : '\0';
            if (c == '\\' && (next == '{' || next == '}')) {
                result += next;
                at += 2;
            } else if (c == '\\' && next == '\\') {
                result += "\\\\";
                at += 2;
            } else if (c == '}') {
                fail(at,
                     fmt::format(
                         "{} closes nothing, expected \\{} for the character itself, or \\\\{} between \"",
                         "}", "}", "}"));
            } else if (c == '{') {
                const std::size_t end = text_.find_first_of("{}\n", at + 1);
                if (end == std::string_view::npos || text_[end] != '}')
                    fail(at, fmt::format("{} is never closed, expected {} in the same line (write \\{} for "
                                         "the character itself, or \\\\{} between \")",
                                         "{", "}", "{", "{"));
                result += reference(at, text_.substr(at + 1, end - at - 1));
                at = end + 1;
            } else {
                result += c;
                ++at;
            }
        }
        return result;
    }

 private:
    [[noreturn]] void fail(std::size_t at, const std::string& message) const {
        const std::string_view rest = text_.substr(at);
        throw MarkupError(message, std::string(rest.substr(0, rest.find('\n'))));
    }

    std::string reference(std::size_t at, std::string_view inner) const {
        const std::size_t colon = inner.find(':');
        const std::string_view name = inner.substr(0, colon);
        const auto found = std::find_if(numbers_.all.begin(), numbers_.all.end(),
                                        [&](const NamedNumber& number) { return number.name == name; });
        if (found == numbers_.all.end()) {
            std::vector<std::string_view> names;
            for (const NamedNumber& number : numbers_.all) names.push_back(number.name);
            const std::string written = fmt::format("{{{}}}", excerpt(name));
            fail(at,
                 names.empty()
                     ? fmt::format(
                           "{} names no claim, expected a [[step.claim]] with that \"name\" in the lesson",
                           written)
                     : fmt::format("{} names no claim, {}", written, expectedOneOf(name, names)));
        }
        NumberFormat format;
        if (colon != std::string_view::npos) {
            const auto parsed = parseFormat(inner.substr(colon + 1));
            if (!parsed)
                fail(at,
                     fmt::format(
                         "{} has no format that is known, expected one of {}",
                         fmt::format("{{{}}}", excerpt(inner)),
                         fmt::format("{{{0}}}, {{{0}:2}}, {{{0}:%}}, {{{0}:1%}}, {{{0}:100}}, {{{0}:1-%}}",
                                     name)));
            format = *parsed;
        }
        return numberText(found->value, format, numbers_.decimalPoint);
    }

    std::string_view text_;
    const NamedNumbers& numbers_;
};

template <class Value>
const Value* childOf(const TomlTable& table, std::string_view key) {
    const TomlEntry* entry = table.find(key);
    return entry != nullptr ? std::get_if<Value>(&entry->value.data) : nullptr;
}

/// What is no number is told when the claim is read.
double numberOf(const TomlTable& claim) {
    for (const auto& relation : kRelations) {
        if (const auto* number = childOf<double>(claim, relation.name)) return *number;
        if (const auto* whole = childOf<std::int64_t>(claim, relation.name))
            return static_cast<double>(*whole);
    }
    return 0.0;
}

}  // namespace

std::string readClaimName(const std::string& file, const TomlValue& value) {
    std::string name = readText(file, "name", value, {kLongestName, false, false});
    if (!std::all_of(name.begin(), name.end(), isNameLetter))
        failAt(file, value.where,
               fmt::format("\"name\" is \"{}\", expected letters (a to z), digits, - and _", excerpt(name)));
    return name;
}

NamedNumbers readNamedNumbers(const std::string& file, const TomlValue& steps) {
    NamedNumbers numbers;
    const auto* stepTables = std::get_if<TomlArray>(&steps.data);
    if (stepTables == nullptr) return numbers;
    for (const TomlValue& step : *stepTables) {
        const auto* stepTable = std::get_if<TomlTable>(&step.data);
        const auto* claims = stepTable != nullptr ? childOf<TomlArray>(*stepTable, "claim") : nullptr;
        if (claims == nullptr) continue;
        for (const TomlValue& claim : *claims) {
            const auto* table = std::get_if<TomlTable>(&claim.data);
            const TomlEntry* entry = table != nullptr ? table->find("name") : nullptr;
            if (entry == nullptr) continue;
            const std::string name = readClaimName(file, entry->value);
            for (const NamedNumber& other : numbers.all)
                if (other.name == name)
                    failAt(file, entry->value.where,
                           fmt::format("two claims have the name \"{}\", expected a name of its own for each",
                                       name));
            numbers.all.push_back({name, numberOf(*table)});
        }
    }
    return numbers;
}

NamedNumbers namedNumbers(const Lesson& lesson) {
    NamedNumbers numbers;
    for (const Step& step : lesson.steps)
        for (const Claim& claim : step.claims)
            if (!claim.name.empty()) numbers.all.push_back({claim.name, claim.number});
    return numbers;
}

std::string withNumbers(std::string_view text, const NamedNumbers& numbers) {
    return ReferenceReader(text, numbers).read();
}

}  // namespace halfdisk
