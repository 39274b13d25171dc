#include "result_files.h"

#include <doctest/doctest.h>

#include <regex>
#include <sstream>

#include "run_program.h"

namespace halfdisk_test {
namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> parts;
    std::istringstream stream(line + ",");
    for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
    return parts;
}

}  // namespace

CsvFile readCsv(const std::filesystem::path& path) {
    CsvFile file;
    std::istringstream stream(readFile(path));
    for (std::string line; std::getline(stream, line);) {
        if (line.rfind("# ", 0) == 0) {
            const std::size_t equals = line.find(" = ");
            REQUIRE(equals != std::string::npos);
            file.facts[line.substr(2, equals - 2)] = line.substr(equals + 3);
            continue;
        }
        const std::vector<std::string> parts = split(line);
        if (file.columns.empty()) {
            file.columns = parts;
            continue;
        }
        REQUIRE(parts.size() == file.columns.size());
        CHECK(parts[0] == std::to_string(file.rows.size()));
        CsvRow row;
        const std::size_t first = parts.size() - 6;
        for (std::size_t i = 1; i < first; ++i) row.place.push_back(std::stod(parts[i]));
        for (int c = 0; c < 3; ++c) {
            const auto at = first + static_cast<std::size_t>(c);
            row.mean[c] = std::stod(parts[at]);
            row.error[c] = parts[at + 3].empty() ? -1.0 : std::stod(parts[at + 3]);
        }
        file.rows.push_back(row);
    }
    return file;
}

Json readJson(const std::filesystem::path& path) {
    const std::string text = readFile(path);
    REQUIRE_MESSAGE(Json::accept(text), text.substr(0, 200));
    return Json::parse(text);
}

std::string withoutSeconds(const std::filesystem::path& path) {
    const std::string text = readFile(path);
    const std::regex seconds(R"re((# seconds = |"seconds":)[0-9.e+-]+)re");
    const auto found = std::distance(std::sregex_iterator(text.begin(), text.end(), seconds), {});
    CHECK(found == 1);
    return std::regex_replace(text, seconds, "$1");
}

}  // namespace halfdisk_test
