// What do all files of a trade share? How numbers and pictures are written, and the question that they
// answer.
#pragma once

#include <filesystem>

#include "app/cli_output.h"
#include "core/trade/trade_statistics.h"
#include "lessons/input_error.h"

namespace halfdisk {

/// Null is NaN.
double numberOrNan(const Json& json);
Json uncertainJson(const Uncertain& number);
Uncertain uncertainFrom(const Json& json);
Json pictureJson(const Picture& picture);
Picture pictureFrom(const Json& json);

/// Throws InputError, with the file's name.
[[noreturn]] void failDamaged(const std::filesystem::path& file);

/// What a file holds, if its fingerprint is right. Throws InputError with its name, and Json::exception.
Json unchangedFrom(const std::filesystem::path& file);

/// Adds a fingerprint of its text, and writes it. Throws as writeFileAtomically does.
void writeTradeFile(const std::filesystem::path& file, Json json, int indent = -1);

/// `read` of a file that writeTradeFile wrote and nobody has changed since. Throws InputError with the file's
/// name if it is another one, or lacks what `read` asks for.
template <class Read>
auto readTradeFile(const std::filesystem::path& file, const Read& read) {
    try {
        return read(unchangedFrom(file));
    } catch (const Json::exception&) {
        failDamaged(file);
    }
}

/// What two questions differ in, in words.
std::string differenceOf(const Json& here, const Json& asked);

/// Throws InputError with the file's name if its question is not the one that is asked.
void requireQuestion(const std::filesystem::path& file, const Json& here, const Json& asked);

}  // namespace halfdisk
