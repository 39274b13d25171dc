#include "app/message_words.h"

#include <optional>
#include <vector>

#include "app/language.h"

namespace halfdisk {
namespace {

constexpr std::string_view kValue = "{}";
constexpr int kDeepest = 6;  // of messages within messages

/// What stands in `text` where `form` has {}; nothing if it is not of this form.
std::optional<std::vector<std::string_view>> valuesIn(std::string_view text, std::string_view form) {
    std::vector<std::string_view> values;
    std::size_t end = form.find(kValue);
    if (end == std::string_view::npos) return text == form ? std::optional(values) : std::nullopt;
    if (!text.starts_with(form.substr(0, end))) return std::nullopt;
    text.remove_prefix(end);
    while (true) {
        form.remove_prefix(end + kValue.size());
        end = form.find(kValue);
        const std::string_view literal = form.substr(0, end);
        if (end == std::string_view::npos) {
            if (!text.ends_with(literal)) return std::nullopt;
            values.push_back(text.substr(0, text.size() - literal.size()));
            return values;
        }
        const std::size_t at = text.find(literal);
        if (at == std::string_view::npos) return std::nullopt;
        values.push_back(text.substr(0, at));
        text.remove_prefix(at + literal.size());
    }
}

std::size_t lettersOf(std::string_view form) {
    std::size_t letters = form.size();
    for (std::size_t at = form.find(kValue); at != std::string_view::npos; at = form.find(kValue, at + 2))
        letters -= kValue.size();
    return letters;
}

std::optional<std::string> told(std::string_view message, int depth);

/// Names stay what they are.
std::string toldValue(std::string_view value, int depth) {
    if (value.find(' ') == std::string_view::npos) return std::string(value);
    return told(value, depth).value_or(std::string(value));
}

/// By the form of which most stands in the message.
std::optional<std::string> toldWhole(std::string_view message, int depth) {
    const Language& language = *spoken();
    if (const auto found = language.words.find(message); found != language.words.end()) return found->second;
    std::size_t most = 0;
    std::string_view form;
    std::vector<std::string_view> values;
    for (const auto& [english, translation] : language.messages) {
        const std::size_t letters = lettersOf(english);
        if (letters <= most) continue;
        auto found = valuesIn(message, english);
        if (!found) continue;
        most = letters;
        form = translation;
        values = std::move(*found);
    }
    if (most == 0) return std::nullopt;
    std::string words;
    for (const std::string_view value : values) {
        const std::size_t at = form.find(kValue);
        words += form.substr(0, at);
        words += toldValue(value, depth + 1);
        form.remove_prefix(at + kValue.size());
    }
    return words.append(form);
}

/// Length of `file:line:column: ` before a message; 0: there is none.
std::size_t placeOf(std::string_view message) {
    constexpr std::string_view kDigits = "0123456789";
    for (std::size_t at = message.find(": "); at != std::string_view::npos; at = message.find(": ", at + 1)) {
        std::string_view place = message.substr(0, at);
        int numbers = 0;
        while (numbers < 2 && !place.empty() && kDigits.find(place.back()) != std::string_view::npos) {
            place = place.substr(0, place.find_last_not_of(kDigits) + 1);
            if (!place.ends_with(':')) break;
            place.remove_suffix(1);
            ++numbers;
        }
        if (numbers == 2) return at + 2;
    }
    return 0;
}

std::optional<std::string> told(std::string_view message, int depth) {
    if (depth > kDeepest) return std::nullopt;
    if (const std::size_t place = placeOf(message); place > 0) {
        const auto rest = told(message.substr(place), depth + 1);
        return rest ? std::optional(std::string(message.substr(0, place)) + *rest) : std::nullopt;
    }
    if (auto whole = toldWhole(message, depth)) return whole;
    constexpr std::string_view kColon = ": ";
    for (std::size_t at = message.find(kColon); at != std::string_view::npos;
         at = message.find(kColon, at + 1)) {
        const std::size_t rest = at + kColon.size();
        if (const auto whole = toldWhole(message.substr(rest), depth))
            return std::string(message.substr(0, rest)) + *whole;
    }
    return std::nullopt;
}

}  // namespace

std::string trMessage(std::string_view message) {
    if (!spoken()) return std::string(message);
    return told(message, 0).value_or(std::string(message));
}

}  // namespace halfdisk
