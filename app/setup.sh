#!/usr/bin/env bash
# What has to be installed and built before the program or its tests can run? Does both, and nothing else.
# Quick, and without network, when nothing is missing and nothing changed.
set -euo pipefail

# The one list of Debian packages: what the program needs, and what only the tests need.
readonly packages=(
    cmake g++ ninja-build pkg-config
    doctest-dev libcli11-dev libeigen3-dev libfmt-dev libfreetype-dev libgl-dev libglfw3-dev libglm-dev libimgui-dev
    libosmesa6 libosmesa6-dev libpng-dev zlib1g-dev librandom123-dev libtomlplusplus-dev nlohmann-json3-dev
    fonts-dejavu-core fonts-inter
)
readonly test_packages=(
    clang-14 clang-format-14 libclang-rt-14-dev libfuzzer-14-dev xauth xdotool xvfb
)

# What the benchmark compares with: it does without those that are missing.
readonly bench_packages=(libbenchmark-dev libbox2d-dev libembree-dev)

usage() {
    cat <<EOF
usage: setup.sh [--tests] [--label LABEL] [--sanitize] [--fuzz SECONDS] [--bench] [--quiet]

Installs the missing Debian packages and builds Halfdisk into build/.
  --tests         also what the tests need, and the tests themselves
  --label LABEL   of the tests only those whose label matches this regular expression
  --sanitize      all with AddressSanitizer and UndefinedBehaviorSanitizer, into build-sanitize/
  --fuzz SECONDS  only the fuzz targets, with clang, into build-fuzz/; their tests run that long
  --bench         only the benchmark, with the programs that it compares with, as far as they can be installed
  --quiet         print only what goes wrong
EOF
}

refuse() {
    echo "setup.sh: $1" >&2
    usage >&2
    exit 2
}

with_tests=false label='' sanitize=false fuzz_seconds='' bench=false quiet=false
while [[ $# -gt 0 ]]; do
    case $1 in
        --tests) with_tests=true ;;
        --label)
            [[ $# -ge 2 && -n $2 ]] || refuse "--label needs a value"
            label=$2
            shift
            ;;
        --sanitize) sanitize=true ;;
        --fuzz)
            [[ $# -ge 2 && $2 =~ ^[1-9][0-9]*$ ]] || refuse "--fuzz needs a whole number of seconds"
            fuzz_seconds=$2
            with_tests=true
            shift
            ;;
        --bench) bench=true ;;
        --quiet) quiet=true ;;
        -h | --help) usage; exit 0 ;;
        *) refuse "unknown option $1" ;;
    esac
    shift
done

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
readonly root

say() { if ! $quiet; then echo "$@"; fi; }

needed=("${packages[@]}")
if $with_tests; then needed+=("${test_packages[@]}"); fi

# missing_packages PACKAGES...
missing_packages() {
    local installed package
    # dpkg-query fails if it does not know one of the names; what it does know is printed all the same.
    installed=$(dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)
    for package in "$@"; do
        grep -qxF "installed $package" <<<"$installed" || echo "$package"
    done
}

install_packages() {
    local missing=("$@") as_root=()
    if [[ $(id -u) -ne 0 ]]; then
        if ! command -v sudo >/dev/null; then
            echo "These Debian packages are missing, and only root can install them. As root, run:" >&2
            echo "  apt-get install ${missing[*]}" >&2
            exit 1
        fi
        as_root=(sudo)
        echo "sudo may ask for your password: apt installs ${missing[*]}" >&2
    fi
    say "Installing ${missing[*]}"
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300)
    local -a verbosity=()
    if $quiet; then verbosity=(-qq); fi
    "${apt[@]}" "${verbosity[@]}" update </dev/null
    "${apt[@]}" "${verbosity[@]}" install --yes --no-install-recommends "${missing[@]}" </dev/null
}

if command -v dpkg-query >/dev/null && command -v apt-get >/dev/null; then
    mapfile -t missing < <(missing_packages "${needed[@]}")
    if [[ ${#missing[@]} -gt 0 ]]; then install_packages "${missing[@]}"; fi
    if $bench; then
        mapfile -t missing < <(missing_packages "${bench_packages[@]}")
        for package in "${missing[@]}"; do
            (install_packages "$package") || echo "$package can't be installed: the benchmark does without it" >&2
        done
    fi
else
    echo "This is no Debian system: nothing is installed. Halfdisk needs what Debian calls" >&2
    printf '  %s\n' "${needed[*]}" >&2
fi

quietly() {
    if ! $quiet; then "$@"; return; fi
    local output
    output=$("$@" 2>&1) || { local code=$?; echo "$output" >&2; return "$code"; }
}

# Whether the folder still belongs to this place; then the build itself notices whatever else changed.
configured() {
    [[ -f $1/build.ninja ]] && grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$1/CMakeCache.txt"
}

# configure FOLDER [CMAKE-OPTIONS...]
configure() {
    local folder=$1 cache=$1/CMakeCache.txt
    # A folder that was configured elsewhere (the project was moved) or half (it was interrupted) starts afresh.
    configured "$folder" || rm -rf "$cache" "$folder/CMakeFiles"
    say "Configuring $folder"
    quietly cmake -S "$root" -B "$folder" -G Ninja "${@:2}"
}

# build FOLDER TARGETS...
build() { quietly cmake --build "$1" --parallel "$(nproc)" --target "${@:2}"; }

# build_tests FOLDER: all, or those of the label.
build_tests() {
    local targets=(all)
    if [[ -n $label ]]; then
        quietly ninja -C "$1" build.ninja # as CMakeLists.txt is now
        mapfile -t targets < <(ninja -C "$1" -t targets all | sed -n 's/^tests_\(.*\): phony$/\1/p' | grep -E "$label" |
            sed 's/^/tests_/')
        [[ ${#targets[@]} -gt 0 ]] || refuse "no test has the label $label"
    fi
    build "$1" "${targets[@]}"
}

if [[ -n $fuzz_seconds ]]; then
    folder=$root/build-fuzz
    configure "$folder" -DCMAKE_BUILD_TYPE=Release -DHALFDISK_FUZZ=ON -DHALFDISK_FUZZ_SECONDS="$fuzz_seconds" \
        -DCMAKE_CXX_COMPILER=clang++-14
    build "$folder" tests_fuzz
elif $sanitize; then
    folder=$root/build-sanitize
    configured "$folder" || configure "$folder" -DCMAKE_BUILD_TYPE=Release -DHALFDISK_SANITIZE=ON
    build_tests "$folder"
elif $bench; then
    folder=$root/build
    configure "$folder" -DCMAKE_BUILD_TYPE=Release # afresh: it looks for the programs to compare with
    build "$folder" benchmarks
else
    folder=$root/build
    configured "$folder" || configure "$folder" -DCMAKE_BUILD_TYPE=Release
    if $with_tests; then build_tests "$folder"; else build "$folder" halfdisk; fi
fi
