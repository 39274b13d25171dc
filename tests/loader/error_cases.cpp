// How is one faulty file, its place and its message written down in one row of a table?
#include "error_cases.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>

#include "lessons/input_error.h"

void checkErrors(std::initializer_list<ErrorCase> cases, std::string_view file,
                 const std::function<void(const std::string& text)>& parse) {
    for (const ErrorCase& row : cases) {
        std::string text(row.text);
        CAPTURE(text);
        const std::size_t mark = text.find('^');
        REQUIRE(mark != std::string::npos);
        text.erase(mark, 1);
        const std::string before = text.substr(0, mark);
        const auto line = std::count(before.begin(), before.end(), '\n') + 1;
        // npos + 1 is 0: on the first line the column counts from the start. Continuation bytes are no
        // columns.
        const std::string onLine = before.substr(before.rfind('\n') + 1);
        const auto column = 1 + std::count_if(onLine.begin(), onLine.end(), [](char c) {
                                return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
                            });
        bool thrown = false;
        try {
            parse(text);
        } catch (const halfdisk::InputError& error) {
            thrown = true;
            CHECK(error.file == file);
            CHECK(error.line == line);
            CHECK(error.column == column);
            CHECK(std::string(error.what()) == fmt::format("{}:{}:{}: {}", file, line, column, error.text));
            CHECK(error.text.find('\n') == std::string::npos);
            for (const std::string_view words : row.said) {
                CAPTURE(words);
                CAPTURE(error.text);
                CHECK(error.text.find(words) != std::string::npos);
            }
        }
        CHECK(thrown);
    }
}
