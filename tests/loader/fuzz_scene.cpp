// Does any text, taken for a scene, do worse than being refused?
#include <cstddef>
#include <cstdint>

#include "loader_property.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    checkSceneText({reinterpret_cast<const char*>(data), size});
    return 0;
}
