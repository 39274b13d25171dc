// How is one faulty file, its place and its message written down in one row of a table?
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

/// A text with a '^' right before the character that the message must point at, and what the message must
/// say.
struct ErrorCase {
    std::string_view text;
    std::initializer_list<std::string_view> said;
};

/// Parses every text without its '^' and checks file name, line, column and message of the InputError.
void checkErrors(std::initializer_list<ErrorCase> cases, std::string_view file,
                 const std::function<void(const std::string& text)>& parse);
