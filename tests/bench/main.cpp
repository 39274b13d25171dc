// How fast is the program? usage: halfdisk_bench [--quick]
#include <fmt/format.h>

#include <cstring>
#include <exception>

#include "benches.h"

using namespace halfdisk;

int main(int argc, char** argv) {
    Effort effort = Effort::full;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--quick") == 0) {
            effort = Effort::quick;
            continue;
        }
        fmt::print(stderr, "usage: halfdisk_bench [--quick]\n");
        return 2;
    }
    try {
        benchFrame(effort);
        benchRays(effort);
    } catch (const std::exception& error) {
        fmt::print(stderr, "halfdisk_bench: {}\n", error.what());
        return 1;
    }
    fmt::print("done\n");
    return 0;
}
