// How is the one message of an InputError composed?
#include "lessons/input_error.h"

#include <fmt/format.h>

#include <utility>

namespace halfdisk {
namespace {

std::string message(const std::string& file, TextPosition at, const std::string& text) {
    if (file.empty()) return text;
    if (at.line <= 0) return fmt::format("{}: {}", file, text);
    return fmt::format("{}:{}:{}: {}", file, at.line, at.column, text);
}

}  // namespace

InputError::InputError(std::string inFile, TextPosition at, std::string whatIsWrong)
    : std::runtime_error(message(inFile, at, whatIsWrong)),
      file(std::move(inFile)),
      line(at.line),
      column(at.column),
      text(std::move(whatIsWrong)) {}

}  // namespace halfdisk
