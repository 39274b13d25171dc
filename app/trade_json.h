// What do all files of a trade share? How numbers and pictures are written, and the question that they
// answer.
#pragma once

#include <filesystem>

#include "app/cli_output.h"
#include "core/trade/trade_statistics.h"
#include "lessons/input_error.h"

namespace halfdisk {

/// Thrown by what follows where a file holds what halfdisk trade does not write.
struct DamagedTradeFile {};

/// A number, finite, whose square is a number too.
double numberFrom(const Json& json);
/// Not below zero.
double amountFrom(const Json& json);
/// From 0 to 2^53.
std::uint64_t countFrom(const Json& json);
/// The same, or null, which is NaN.
double numberOrNan(const Json& json);
Json uncertainJson(const Uncertain& number);
Uncertain uncertainFrom(const Json& json);
Json pictureJson(const Picture& picture);
Picture pictureFrom(const Json& json);

/// Throws InputError, with the file's name, if `file` can't be read.
std::string textOfTradeFile(const std::filesystem::path& file);

/// Throws InputError, with the file's name.
[[noreturn]] void failDamaged(const std::filesystem::path& file);

/// `read` of a file that holds JSON. Throws InputError with the file's name if it does not, or lacks what
/// `read` asks for.
template <class Read>
auto readTradeFile(const std::filesystem::path& file, const Read& read) {
    const std::string text = textOfTradeFile(file);
    try {
        return read(Json::parse(text));
    } catch (const Json::exception&) {
        failDamaged(file);
    } catch (const DamagedTradeFile&) {
        failDamaged(file);
    }
}

/// What two questions differ in, in words.
std::string differenceOf(const Json& here, const Json& asked);

/// Throws InputError with the file's name if its question is not the one that is asked.
void requireQuestion(const std::filesystem::path& file, const Json& here, const Json& asked);

}  // namespace halfdisk
