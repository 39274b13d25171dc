// Is a file what its kind promises? Small readers of XML and CSV that refuse what other programs would.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace halfdisk {

struct XmlFile {
    std::string fault;  ///< empty: well-formed
    std::vector<std::string> elements;
    std::vector<std::string> texts;      ///< contents of `text` elements, as read
    std::string title, description;      ///< of the root
    std::vector<std::string> ids, uses;  ///< id="..." and url(#...)
};

/// Elements, attributes in double quotes, character data, the five named references; no DTD, no comments.
XmlFile readXml(std::string_view bytes);

/// Rows of cells; throws std::runtime_error for quotes that RFC 4180 does not allow.
std::vector<std::vector<std::string>> readCsv(std::string_view bytes);

}  // namespace halfdisk
