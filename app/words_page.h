// How are words set that are read as plain text? Headings, paragraphs and lists, broken at 100 columns.
#pragma once

#include <string>
#include <string_view>

namespace halfdisk {

class WordsPage {
 public:
    static constexpr std::size_t kColumns = 100;

    void title(std::string_view words);
    void heading(std::string_view words);
    void paragraph(std::string_view words);  ///< line ends in it begin new ones
    void prose(std::string_view words);      ///< the same, with an empty line between them
    void item(std::string_view words);       ///< of a list
    void fact(std::string_view name, std::string_view value);

    const std::string& text() const { return text_; }

 private:
    void lines(std::string_view words, std::string_view first, std::string_view later);
    void underlined(std::string_view words, char with);

    std::string text_;
};

}  // namespace halfdisk
