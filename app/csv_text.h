// How is a table written for spreadsheets and scripts? Commas, quotes as in RFC 4180, `.` in numbers, one
// line a row.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "core/math.h"

namespace halfdisk {

class CsvText {
 public:
    CsvText() = default;  ///< its header is the first row
    explicit CsvText(std::initializer_list<std::string_view> header);

    CsvText& cell(std::string_view words);
    CsvText& cell(double number);     ///< the shortest text that keeps every bit; empty if it is not finite
    CsvText& cell(const Rgb& color);  ///< three cells
    CsvText& empty(int cells = 1);
    void endRow();

    const std::string& text() const { return text_; }

 private:
    std::string text_;
    bool first_ = true;  // in its row
};

}  // namespace halfdisk
