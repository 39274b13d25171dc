// What is in the files that a rendering wrote? Read back without the program's own code, but for the
// pictures.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/math.h"

namespace halfdisk_test {

using Json = nlohmann::ordered_json;

struct CsvRow {
    std::vector<double> place;  ///< angle; or s; or x and y
    halfdisk::Rgb mean{0.0}, error{0.0};
};

struct CsvFile {
    std::map<std::string, std::string> facts;  ///< of the comments, values as JSON
    std::vector<std::string> columns;
    std::vector<CsvRow> rows;
};

/// Fails the test if a line is not of the form.
CsvFile readCsv(const std::filesystem::path& path);

Json readJson(const std::filesystem::path& path);

/// The bytes without the value of `seconds`, which must be there once.
std::string withoutSeconds(const std::filesystem::path& path);

}  // namespace halfdisk_test
