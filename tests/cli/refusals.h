// Is what cannot be done refused with exit code 2 and one clear line, and nothing else?
#pragma once

#include <string>
#include <vector>

namespace halfdisk_test {

/// Checks that the program prints nothing but one line on stderr that holds `message`.
void checkRefused(const std::vector<std::string>& arguments, const std::string& message);

}  // namespace halfdisk_test
