#!/usr/bin/env bash
# How is the program started? Installs and builds what is missing, then passes the arguments on.
# Without arguments and without a display it draws every step of every lesson into build/tour/ instead.
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)

# Standard output belongs to the program, so that `run.sh probe ... --json` can be piped.
bash "$root/app/setup.sh" >&2

program=$root/build/halfdisk
if [[ $# -eq 0 ]] && ! "$program" has-display; then
    tour=$root/build/tour
    echo "There is no display: drawing every step of every lesson instead." >&2
    "$program" tour -o "$tour"
    echo "The pictures are in $tour"
    exit 0
fi
exec "$program" "$@"
