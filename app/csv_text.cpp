#include "app/csv_text.h"

#include <cmath>

#include "app/render_result.h"

namespace halfdisk {

CsvText::CsvText(std::initializer_list<std::string_view> header) {
    for (const std::string_view name : header) cell(name);
    endRow();
}

CsvText& CsvText::cell(std::string_view words) {
    if (!first_) text_ += ',';
    first_ = false;
    if (words.find_first_of(",\"\r\n") == std::string_view::npos) {
        text_ += words;
        return *this;
    }
    text_ += '"';
    for (const char c : words) {
        if (c == '"') text_ += '"';
        text_ += c;
    }
    text_ += '"';
    return *this;
}

CsvText& CsvText::cell(double number) {
    if (!std::isfinite(number)) return empty();
    const std::string text = numberText(number);
    return cell(std::string_view(text));
}

CsvText& CsvText::cell(const Rgb& color) {
    return cell(color.x).cell(color.y).cell(color.z);
}

CsvText& CsvText::empty(int cells) {
    for (int i = 0; i < cells; ++i) cell(std::string_view());
    return *this;
}

void CsvText::endRow() {
    text_ += '\n';
    first_ = true;
}

}  // namespace halfdisk
