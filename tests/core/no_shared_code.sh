#!/usr/bin/env bash
# May an old processor be handed a new one's code? The linker keeps one copy of what several files share (weak symbols):
# the files that are compiled for an instruction set of their own must have none.
set -euo pipefail

found=$(nm -A "$1" 2>/dev/null | grep -E 'kernels?_[a-z0-9]+\.cpp' || true)
if [[ -z $found ]]; then
    echo "no file kernels_*.cpp in $1: what was to be looked at has another name now"
    exit 1
fi
if shared=$(grep -E ' [WVu] ' <<<"$found"); then
    echo "$shared"
    echo "These are shared with other files: give them internal linkage (an unnamed namespace)."
    exit 1
fi
