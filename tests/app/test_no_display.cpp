// Does a machine without a display get an answer instead of a crash?
#include <doctest/doctest.h>

#include <cstdlib>

#include "app/window_host.h"

using namespace halfdisk;

TEST_CASE("without a display no window opens, and it says why") {
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    CHECK_FALSE(hasDisplay());
    std::string whyNot;
    CHECK(WindowHost::open({}, whyNot) == nullptr);
    CHECK_FALSE(whyNot.empty());
}
