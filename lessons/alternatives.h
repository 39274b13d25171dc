// Which alternative of a variant has this index?
#pragma once

#include <cassert>
#include <cstddef>
#include <variant>

namespace halfdisk {

/// Alternative `index` of the variant, with its initial value.
template <class Variant, std::size_t I = 0>
Variant alternative(std::size_t index) {
    assert(index < std::variant_size_v<Variant>);
    if constexpr (I + 1 < std::variant_size_v<Variant>)
        if (index > I) return alternative<Variant, I + 1>(index);
    return Variant(std::in_place_index<I>);
}

}  // namespace halfdisk
