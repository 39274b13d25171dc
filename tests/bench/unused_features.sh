#!/bin/bash
# What do glass, mirrors, lobes, round walls and the environment cost in a scene that has none of them?
# Instructions of `path` in a matt room, by callgrind: the program as it is, with each of these taken out of its source,
# and with all of them. Usage: unused_features.sh BUILD. Needs valgrind and a finished build of halfdisk_core. Exits 1 if
# one of them costs more than 1 %.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "${1:-$root/build}" && pwd)
command -v valgrind >/dev/null || { echo "valgrind is missing: apt install valgrind" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# take FILE FROM TO: one piece of the variant's source by another; fails if it is not there.
take() {
    local file=$work/$variant/core/$1 text
    text=$(cat "$file")
    [[ $text == *"$2"* ]] || { echo "unused_features.sh: $1 no longer has: $2" >&2; exit 1; }
    printf '%s\n' "${text/"$2"/"$3"}" > "$file"
}
without_environment() {
    take light_ways.h 'wall ? wall->emission : index.environment(ray.direction)' 'wall ? wall->emission : Rgb(0.0)'
    take light_table.cpp 'if (light < count_) return' 'return'
    take light_table.cpp 'if (!hit) return probability(environmentLight()) * pdfEnvironment(ray.direction);' \
        'if (!hit) return 0.0;'
}
without_glass() {
    take surface.h 'return medium == kNoMedium ? Rgb(1.0) : transmittanceOf(index.scene().materials[medium], distance);' \
        'return static_cast<void>(index), static_cast<void>(medium), static_cast<void>(distance), Rgb(1.0);'
    take walk.h 'if (ray.medium != kNoMedium) throughput' 'if (false) throughput'
    take direct_light.h 'if (ray.medium != kNoMedium) drawn.L_i' 'if (false) drawn.L_i'
    take surface.cpp 'return std::holds_alternative<Dielectric>(*at.material) && glm::dot(direction, at.N) < 0.0;' \
        'return static_cast<void>(at), static_cast<void>(direction), false;'
    take surface.cpp 'if (!index.hasGlass()) return kNoMedium;' 'if (true) return kNoMedium;'
}
without_round() {
    take surface.h 'const bool isRound = index.isRound(hit.segment);' ''
    take surface.h 'isRound ? roundNormalAt(index, hit, from, N) : N,' 'N,'
    take surface.h '            isRound,' ''
    take surface.h '    bool isRound;          ///< a facet of a round thing' ''
    take surface.cpp 'return wall && !at.isRound ? wall : nullptr;' 'return wall;'
}
# All scattering but that of matt walls.
without_lobes() {
    take surface.cpp 'const auto* wall = std::get_if<Diffuse>(at.material);' 'const auto* wall = &std::get<Diffuse>(*at.material);'
    take surface.cpp 'return wall && !at.isRound ? wall : nullptr;' 'return !at.isRound ? wall : nullptr;'
}
without_mirrors() {
    take materials/material.h 'return std::holds_alternative<Mirror>(material) || std::holds_alternative<Dielectric>(material);' \
        'return static_cast<void>(material), false;'
    take materials/scattering.h 'return pdfAngle == 0.0;' 'return false;'
}
without_all() {
    without_environment
    without_glass
    without_mirrors
    take surface.h 'const bool isRound = index.isRound(hit.segment);' ''
    take surface.h 'isRound ? roundNormalAt(index, hit, from, N) : N,' 'N,'
    take surface.h '            isRound,' ''
    take surface.h '    bool isRound;          ///< a facet of a round thing' ''
    cp "$root/tests/bench/matt_surface.cpp" "$work/all/core/surface.cpp"
}

flags="-std=c++20 -O3 -DNDEBUG -ffp-contract=off"
instructions() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$work/$1/run" "$2" 2>&1 >"$work/$1/said" |
        sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}
failed=0
for variant in nothing environment glass round lobes mirrors all; do
    mkdir "$work/$variant"
    cp -r "$root/core" "$work/$variant/core"
    [ $variant = nothing ] || without_$variant
    for file in surface light_table light sensor estimators/path; do
        ${CXX:-g++} $flags -I"$work/$variant" -c "$work/$variant/core/$file.cpp" -o "$work/$variant/$(basename $file).o"
    done
    ${CXX:-g++} $flags -I"$work/$variant" "$root/tests/bench/unused_features.cpp" "$work/$variant"/*.o \
        "$build/core/libhalfdisk_core.a" -lpthread -o "$work/$variant/run"
    # The difference of a long and a short run is that of the paths alone.
    count=$(($(instructions $variant 900) - $(instructions $variant 300)))
    [ $variant = nothing ] && whole=$count
    cmp -s "$work/nothing/said" "$work/$variant/said" || { echo "all must find the same light" >&2; exit 1; }
    awk -v name=$variant -v a="$whole" -v b="$count" 'BEGIN {
        printf "without %-12s %12d instructions: it costs %+.2f %%\n", name, b, 100 * (a / b - 1)
        exit name != "all" && a > 1.01 * b }' || failed=1
done
exit $failed
