// What can a wall be made of? A closed set: a forgotten case does not compile.
#pragma once

#include "core/materials/dielectric.h"
#include "core/materials/diffuse.h"
#include "core/materials/glossy.h"
#include "core/materials/mirror.h"
#include "core/materials/mix.h"

namespace halfdisk {

using Material = std::variant<Diffuse, Mirror, Glossy, Dielectric, Mix>;

/// Whether light leaves the wall in one direction only, however it arrives.
inline bool isSpecular(const Material& material) {
    return std::holds_alternative<Mirror>(material) || std::holds_alternative<Dielectric>(material);
}

/// Whether both sides of the wall act, even if it is not declared two-sided.
inline bool actsOnBothSides(const Material& material) {
    return isSpecular(material);
}

}  // namespace halfdisk
