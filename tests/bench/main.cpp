// How fast is the program? usage: halfdisk_bench [--quick] [--json] [--only PART,...]
#include <algorithm>
#include <array>
#include <exception>
#include <vector>

#include "benches.h"

using namespace halfdisk;

namespace {

struct Part {
    std::string_view name;
    void (*run)(Report&, Effort);
};

constexpr std::array kParts{
    Part{"rays", benchIndex},        Part{"build", benchBuild},   Part{"estimators", benchEstimators},
    Part{"threads", benchThreads},   Part{"cancel", benchCancel}, Part{"overhead", benchOverhead},
    Part{"observer", benchObserver}, Part{"splat", benchSplat},   Part{"frame", benchFrame},
    Part{"first", benchFirst},
};

int refuse(const std::string& why) {
    std::string names;
    for (const Part& part : kParts) names += fmt::format(" {}", part.name);
    fmt::print(stderr,
               "halfdisk_bench: {}\nusage: halfdisk_bench [--quick] [--json] [--only PART,...]\nparts:{}\n",
               why, names);
    return 2;
}

/// Adds the parts that are named between commas; the one that does not exist, if there is one.
std::string choose(std::string_view names, std::vector<Part>& chosen) {
    while (!names.empty()) {
        const std::size_t comma = std::min(names.find(','), names.size());
        const std::string_view name = names.substr(0, comma);
        const auto part =
            std::find_if(kParts.begin(), kParts.end(), [&](const Part& p) { return p.name == name; });
        if (part == kParts.end()) return std::string(name);
        chosen.push_back(*part);
        names.remove_prefix(std::min(comma + 1, names.size()));
    }
    return "";
}

}  // namespace

int main(int argc, char** argv) {
    Effort effort = Effort::full;
    bool json = false;
    std::vector<Part> chosen;
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument == "--quick") {
            effort = Effort::quick;
        } else if (argument == "--json") {
            json = true;
        } else if (argument == "--only" && i + 1 < argc) {
            const std::string unknown = choose(argv[++i], chosen);
            if (!unknown.empty()) return refuse(fmt::format("there is no part \"{}\"", unknown));
        } else {
            return refuse(fmt::format("can't use {}", argument));
        }
    }
    if (chosen.empty()) chosen.assign(kParts.begin(), kParts.end());
    Report report(json, effort == Effort::full);
    try {
        for (const Part& part : chosen) {
            part.run(report, effort);
            report.print("\n");
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "halfdisk_bench: {}\n", error.what());
        return 1;
    }
    report.finish();
    return 0;
}
