#!/usr/bin/env bash
# How are all tests run with one command? Installs and builds what is missing, then asks CTest, in parallel.
set -euo pipefail

usage() {
    cat <<EOF
usage: run.sh [--label LABEL] [--sanitize] [--fuzz-seconds S] [-- CTEST-ARGUMENTS...]
       run.sh --bench [--json] [--quick] [--only PART,...]

  --label LABEL     only tests whose label matches this regular expression, such as unit or 'unit|fuzz'
  --sanitize        under AddressSanitizer and UndefinedBehaviorSanitizer, built in build-sanitize/
  --fuzz-seconds S  how long each fuzz target runs (60)
  --bench           no tests, but the benchmarks, about ten minutes: rays beside Embree and Box2D, and what else is
                    required of speed. --json: for machines; --quick: only whether it runs; --only: these parts of
                    rays, build, estimators, threads, cancel, overhead, observer, splat, frame, first

Without --sanitize, and unless a label excludes them, the fuzz targets are built in build-fuzz/ and run as well.
EOF
}

refuse() {
    echo "run.sh: $1" >&2
    usage >&2
    exit 2
}

label='' sanitize=false bench=false fuzz_seconds=60 ctest_arguments=() bench_arguments=()
while [[ $# -gt 0 ]]; do
    case $1 in
        --label)
            [[ $# -ge 2 && -n $2 ]] || refuse "--label needs a value"
            label=$2
            shift 2
            ;;
        --sanitize) sanitize=true; shift ;;
        --bench) bench=true; shift ;;
        --json | --quick) bench_arguments+=("$1"); shift ;;
        --only)
            [[ $# -ge 2 && -n $2 ]] || refuse "--only needs a value"
            bench_arguments+=("$1" "$2")
            shift 2
            ;;
        --fuzz-seconds)
            [[ $# -ge 2 && $2 =~ ^[1-9][0-9]*$ ]] || refuse "--fuzz-seconds needs a whole number of seconds"
            fuzz_seconds=$2
            shift 2
            ;;
        --) shift; ctest_arguments=("$@"); break ;;
        -h | --help) usage; exit 0 ;;
        *) refuse "unknown option $1" ;;
    esac
done

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
readonly root

export LSAN_OPTIONS="suppressions='$root/tests/lsan.supp':print_suppressions=0"
export UBSAN_OPTIONS=print_stacktrace=1
# With it the leak sanitizer keeps a list of all threads' own memory, and crashes at the program's end where an entry of
# it is wrong, as is seen with libraries that are loaded late.
export ASAN_OPTIONS=intercept_tls_get_addr=0

failed=false
run_ctest() {
    ctest --test-dir "$1" --parallel "$(nproc)" --output-on-failure --no-tests=error "${@:2}" || failed=true
}

if $bench; then
    bash "$root/app/setup.sh" --bench >&2 # what is printed is the benchmark's alone
    exec "$root/build/tests/bench/halfdisk_bench" "${bench_arguments[@]}"
fi
[[ ${#bench_arguments[@]} -eq 0 ]] || refuse "${bench_arguments[0]} goes with --bench"

by_label=(--label-exclude long)
if [[ -n $label ]]; then by_label=(--label-regex "$label"); fi

folder=$root/build
setup=(--tests)
if [[ -n $label ]]; then setup+=(--label "$label"); fi
if $sanitize; then
    folder=$root/build-sanitize
    setup+=(--sanitize)
fi

bash "$root/app/setup.sh" "${setup[@]}"
run_ctest "$folder" "${by_label[@]}" "${ctest_arguments[@]}"

if ! $sanitize && [[ -z $label || fuzz =~ $label ]]; then
    bash "$root/app/setup.sh" --fuzz "$fuzz_seconds"
    run_ctest "$root/build-fuzz" --label-regex fuzz
fi

if $failed; then exit 1; fi
