// Where do the results go? Tables for people as they come, or one JSON object for machines at the end.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace halfdisk {

class Report {
 public:
    /// `judging`: whether the measurement is long enough to tell what is met.
    Report(bool json, bool judging) : json_(json), judging_(judging) {}

    /// A piece of a table; nothing if JSON is asked for.
    template <class... Values>
    void print(fmt::format_string<Values...> format, Values&&... values) const {
        if (json_) return;
        fmt::print(format, std::forward<Values>(values)...);
        std::fflush(stdout);
    }

    /// What is being measured, on a terminal only; overwritten by what comes next. Empty: nothing more.
    void progress(std::string_view what) const;

    /// One result, into the list `part` of the JSON object.
    void add(const std::string& part, nlohmann::ordered_json row) {
        results_[part].push_back(std::move(row));
    }

    /// A requirement that was measured: one of the bounds, or none. Returns the mark for the table.
    std::string_view judge(const std::string& what, double measured, std::optional<double> atLeast,
                           std::optional<double> atMost = std::nullopt);

    /// Prints the JSON object, or how many requirements were met.
    void finish();

 private:
    bool json_, judging_;
    int met_ = 0;
    nlohmann::ordered_json results_ = nlohmann::ordered_json::object();
    std::vector<std::string> missed_;
};

}  // namespace halfdisk
