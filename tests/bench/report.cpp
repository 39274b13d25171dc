#include "report.h"

#include <unistd.h>

namespace halfdisk {

void Report::progress(std::string_view what) const {
    if (isatty(STDERR_FILENO)) fmt::print(stderr, "\r{:<70}\r{}", "", what);
}

std::string_view Report::judge(const std::string& what, double measured, std::optional<double> atLeast,
                               std::optional<double> atMost) {
    if (!judging_ || (!atLeast && !atMost)) return "";
    if ((!atLeast || measured >= *atLeast) && (!atMost || measured <= *atMost)) {
        ++met_;
        return "ok";
    }
    missed_.push_back(fmt::format("{}: {:.3g}, required {} {:g}", what, measured,
                                  atLeast ? ">=" : "<=", atLeast ? *atLeast : *atMost));
    return "MISSED";
}

void Report::finish() {
    if (json_) {
        results_["judged"] = judging_;
        results_["met"] = met_;
        results_["missed"] = missed_;
        fmt::print("{}\n", results_.dump(1));
        return;
    }
    if (judging_) fmt::print("{} requirements met, {} missed\n", met_, missed_.size());
    for (const std::string& line : missed_) fmt::print("  {}\n", line);
    fmt::print("done\n");
}

}  // namespace halfdisk
