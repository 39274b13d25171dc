#!/usr/bin/env bash
# How do tests that need a window run on a machine without a display? Usage: with_xvfb.sh COMMAND [ARGS...]
# Exit code 77 (skipped, for CTest) if Xvfb is missing.
set -euo pipefail

if ! command -v xvfb-run >/dev/null; then
    echo "skipped: xvfb-run is missing (apt install xvfb)"
    exit 77
fi
# Without -noreset the server starts over whenever its last window closes, and refuses the next one meanwhile.
exec xvfb-run --auto-servernum --server-args="-screen 0 1400x1000x24 -noreset" "$@"
