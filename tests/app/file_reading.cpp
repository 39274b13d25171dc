#include "file_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "lessons/utf8.h"

namespace halfdisk {
namespace {

struct Reader {
    std::string_view left;

    bool takes(std::string_view word) {
        if (left.substr(0, word.size()) != word) return false;
        left.remove_prefix(word.size());
        return true;
    }
    void need(std::string_view word) {
        if (!takes(word))
            throw std::runtime_error(fmt::format("'{}' was expected before '{}'", word, left.substr(0, 40)));
    }
    void spaces() { left.remove_prefix(std::min(left.find_first_not_of(" \n"), left.size())); }
    std::string name() {
        std::size_t end = 0;
        const auto isName = [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == ':';
        };
        while (end < left.size() && isName(left[end])) ++end;
        if (end == 0)
            throw std::runtime_error(fmt::format("a name was expected before '{}'", left.substr(0, 40)));
        const std::string found(left.substr(0, end));
        left.remove_prefix(end);
        return found;
    }
    /// Up to one of `ends`, with references replaced.
    std::string data(std::string_view ends) {
        std::string text;
        while (!left.empty() && ends.find(left.front()) == ends.npos) {
            if (left.front() == '<') throw std::runtime_error("a < in a value");
            if (left.front() != '&') {
                text += left.front();
                left.remove_prefix(1);
            } else if (takes("&amp;")) {
                text += '&';
            } else if (takes("&lt;")) {
                text += '<';
            } else if (takes("&gt;")) {
                text += '>';
            } else if (takes("&quot;")) {
                text += '"';
            } else {
                throw std::runtime_error("an unknown reference");
            }
        }
        return text;
    }
};

void readElement(Reader& in, XmlFile& file, int depth) {
    in.need("<");
    const std::string name = in.name();
    file.elements.push_back(name);
    std::map<std::string, std::string> attributes;
    for (in.spaces(); in.left.substr(0, 1) != ">" && in.left.substr(0, 2) != "/>"; in.spaces()) {
        const std::string key = in.name();
        in.need("=\"");
        if (!attributes.emplace(key, in.data("\"")).second) throw std::runtime_error("twice: " + key);
        in.need("\"");
    }
    if (attributes.count("id") > 0) file.ids.push_back(attributes["id"]);
    if (const std::string& clip = attributes["clip-path"]; !clip.empty())
        file.uses.push_back(clip.substr(5, clip.size() - 6));
    if (in.takes("/>")) return;
    in.need(">");
    std::string content;
    while (!in.takes("</")) {
        if (in.left.empty()) throw std::runtime_error("no end of " + name);
        if (in.left.front() == '<')
            readElement(in, file, depth + 1);
        else
            content += in.data("<");
    }
    in.need(name);
    in.need(">");
    if (name == "text") file.texts.push_back(content);
    if (name == "title" && depth == 1) file.title = content;
    if (name == "desc" && depth == 1) file.description = content;
}

}  // namespace

XmlFile readXml(std::string_view bytes) {
    XmlFile file;
    try {
        if (firstInvalidUtf8(bytes)) throw std::runtime_error("not UTF-8");
        for (const char c : bytes)
            if (static_cast<unsigned char>(c) < 0x20 && c != '\n')
                throw std::runtime_error("a control character");
        Reader in{bytes};
        in.need("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        readElement(in, file, 0);
        in.spaces();
        if (!in.left.empty()) throw std::runtime_error("more than one root");
    } catch (const std::runtime_error& error) {
        file.fault = error.what();
    }
    return file;
}

std::vector<std::vector<std::string>> readCsv(std::string_view bytes) {
    std::vector<std::vector<std::string>> rows;
    while (!bytes.empty()) {
        std::vector<std::string> row(1);
        for (bool ended = false; !ended;) {
            std::string& cell = row.back();
            if (!bytes.empty() && bytes.front() == '"') {
                for (bytes.remove_prefix(1);; bytes.remove_prefix(1)) {
                    if (bytes.empty()) throw std::runtime_error("a quote that does not end");
                    if (bytes.front() == '"') {
                        bytes.remove_prefix(1);
                        if (bytes.empty() || bytes.front() != '"') break;
                    }
                    cell += bytes.front();
                }
            } else {
                const std::size_t end = std::min(bytes.find_first_of(",\n"), bytes.size());
                cell = bytes.substr(0, end);
                if (cell.find('"') != cell.npos) throw std::runtime_error("a quote within a cell");
                bytes.remove_prefix(end);
            }
            if (bytes.empty() || (bytes.front() != ',' && bytes.front() != '\n'))
                throw std::runtime_error("a cell that does not end");
            ended = bytes.front() == '\n';
            bytes.remove_prefix(1);
            if (!ended) row.emplace_back();
        }
        rows.push_back(row);
    }
    return rows;
}

}  // namespace halfdisk
