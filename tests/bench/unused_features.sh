#!/bin/bash
# What do glass, mirrors, lobes, round walls and the environment cost in a scene that has none of them?
# Instructions of `path` in a matt room, by callgrind: the program as it is, and with all these taken out of its source.
# Usage: unused_features.sh BUILD. Needs valgrind and a finished build of halfdisk_core. Exits 1 above 1 %.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "${1:-$root/build}" && pwd)
command -v valgrind >/dev/null || { echo "valgrind is missing: apt install valgrind" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/with" "$work/without"
cp -r "$root/core" "$work/with/core"
cp -r "$root/core" "$work/without/core"
cp "$root/tests/bench/matt_surface.cpp" "$work/without/core/surface.cpp"

# take FILE FROM TO: one piece of source by another; fails if it is not there.
take() {
    local file=$work/without/core/$1 text
    text=$(cat "$file")
    [[ $text == *"$2"* ]] || { echo "unused_features.sh: $1 no longer has: $2" >&2; exit 1; }
    printf '%s\n' "${text/"$2"/"$3"}" > "$file"
}
take materials/material.h 'return std::holds_alternative<Mirror>(material) || std::holds_alternative<Dielectric>(material);' \
    'return static_cast<void>(material), false;'
take materials/scattering.h 'return pdfAngle == 0.0;' 'return false;'
take surface.h 'return medium == kNoMedium ? Rgb(1.0) : transmittanceOf(index.scene().materials[medium], distance);' \
    'return static_cast<void>(index), static_cast<void>(medium), static_cast<void>(distance), Rgb(1.0);'
take surface.h 'const bool smooth = isSmooth(index.scene().segments[hit.segment]);' ''
take surface.h 'smooth ? roundNormalAt(index, hit, from, N) : N,' 'N,'
take surface.h 'return at.front || index.scene().segments[at.segment].twoSided || actsOnBothSides(*at.material);' \
    'return at.front || index.scene().segments[at.segment].twoSided;'
take light_ways.h 'wall ? wall->emission : index.environment(ray.direction)' 'wall ? wall->emission : Rgb(0.0)'
take light_table.cpp 'if (light != environmentLight()) return sampleLight(*index_, light, P, u);' \
    'if (true) return sampleLight(*index_, light, P, u);'
take light_table.cpp 'if (!hit) return probability(environmentLight()) * pdfEnvironment(ray.direction);' \
    'if (!hit) return 0.0;'

files="surface light_table light sensor estimators/path"
for way in with without; do
    for file in $files; do
        ${CXX:-g++} -std=c++20 -O3 -DNDEBUG -ffp-contract=off -I"$work/$way" -c "$work/$way/core/$file.cpp" \
            -o "$work/$way/$(basename "$file").o"
    done
    ${CXX:-g++} -std=c++20 -O3 -DNDEBUG -I"$work/$way" "$root/tests/bench/unused_features.cpp" "$work/$way"/*.o \
        "$build/core/libhalfdisk_core.a" -lpthread -o "$work/$way/run"
done
# The difference of a long and a short run is that of the paths alone.
instructions() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$work/$1/run" "$2" 2>&1 >"$work/$1/said" |
        sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}
for way in with without; do
    declare "$way=$(($(instructions $way 900) - $(instructions $way 300)))"
    cat "$work/$way/said" >&2
done
cmp -s "$work/with/said" "$work/without/said" || { echo "both must find the same light" >&2; exit 1; }
awk -v a="$with" -v b="$without" 'BEGIN {
    printf "instructions of 600 passes: %d as it is, %d without glass, mirrors, lobes, round walls and environment: %+.2f %%\n", a, b, 100 * (a / b - 1)
    exit a > 1.01 * b }'
