// How does a file or an argument that cannot be used say so? One message with file, line and column.
#pragma once

#include <stdexcept>
#include <string>

namespace halfdisk {

/// A place in a text file; both count from 1, columns in characters (code points). Line 0: no place is known.
struct TextPosition {
    int line = 0;
    int column = 0;
    bool operator==(const TextPosition&) const = default;
};

/// Bad input. what() is `file:line:column: text`, or `file: text` without a place, or `text` without a file.
struct InputError : std::runtime_error {
    InputError(std::string inFile, TextPosition at, std::string whatIsWrong);
    InputError(std::string inFile, std::string whatIsWrong)
        : InputError(std::move(inFile), {}, std::move(whatIsWrong)) {}
    /// For something typed rather than read, e.g. a lesson's name on the command line.
    explicit InputError(std::string whatIsWrong) : InputError({}, {}, std::move(whatIsWrong)) {}

    std::string file;
    int line = 0;
    int column = 0;
    std::string text;  ///< what is wrong, what was expected
};

}  // namespace halfdisk
