// Does any text, taken for a lesson, do worse than being refused?
#include <cstddef>
#include <cstdint>

#include "loader_property.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    checkLessonText({reinterpret_cast<const char*>(data), size});
    return 0;
}
