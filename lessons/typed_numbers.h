// Which numbers of a lesson's texts are typed, so that nothing measures them? Those in **bold** are meant:
// what a student is to remember.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lessons/input_error.h"

namespace halfdisk {

struct TypedNumber {
    TextPosition where{};
    std::string words;  ///< between the stars
    bool operator==(const TypedNumber&) const = default;
};

/// Of a lesson's file, or of a translation's: in prose, questions and answers, in the order of the file.
/// Throws InputError if it is no TOML.
std::vector<TypedNumber> typedNumbers(const std::filesystem::path& file);

}  // namespace halfdisk
