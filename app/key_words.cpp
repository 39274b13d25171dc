#include "app/key_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/language.h"

namespace halfdisk {
namespace {

bool isLetter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

std::string nameOfKey(std::string_view key) {
    const std::string english = fmt::format("key {}", key);
    const std::string_view name = tr(english);
    return std::string(name == english ? key : name);
}

}  // namespace

std::string keyWords(std::string_view keys) {
    std::string words;
    for (bool wordBegins = true; !keys.empty();) {
        const auto isHere = [&](std::string_view name) {
            return keys.starts_with(name) && (keys.size() == name.size() || !isLetter(keys[name.size()]));
        };
        const auto name = std::find_if(kKeyNames.begin(), kKeyNames.end(), isHere);
        const bool named = wordBegins && name != kKeyNames.end();
        words += named ? nameOfKey(*name) : std::string(keys.substr(0, 1));
        wordBegins = !named && !isLetter(keys.front());
        keys.remove_prefix(named ? name->size() : 1);
    }
    return words;
}

std::string withKey(std::string_view meaning, std::string_view key) {
    return fmt::format("{} ({})", tr(meaning), keyWords(key));
}

}  // namespace halfdisk
