// How does a text show a number that is measured, instead of one that is typed?
//
//   A claim with name = "kept" lends its number to all texts of its lesson, in every language:
//     {kept}      as the claim has it          0.8612
//     {kept:2}    digits after the point       0.86
//     {kept:%}    in percent                   86 %
//     {kept:1%}   digits and percent           86.1 %
//     {kept:100}  in hundredths            86 (of 100)
//     {kept:1-%}  what it lacks to 1           14 %       also 1-2, 1-100
//   From five digits on they stand in groups: 69 904. \{ and \} are the braces themselves.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/toml_document.h"

namespace halfdisk {

struct Lesson;

struct NamedNumber {
    std::string name;
    double value = 0.0;
};

/// The numbers of a lesson's claims that have a name.
struct NamedNumbers {
    std::vector<NamedNumber> all{};
    std::string decimalPoint = ".";
};

/// The name of a claim: 1 ... 40 letters, digits, - and _. Throws InputError.
std::string readClaimName(const std::string& file, const TomlValue& value);

/// Of all claims of the steps, before these are read: a text may name a number of a later step. Throws
/// InputError for a name that is given twice. What else may be wrong with a claim is told when it is read.
NamedNumbers readNamedNumbers(const std::string& file, const TomlValue& steps);

/// Of a lesson that was read.
NamedNumbers namedNumbers(const Lesson& lesson);

/// The text with its {references} written out. Throws MarkupError.
std::string withNumbers(std::string_view text, const NamedNumbers& numbers);

}  // namespace halfdisk
