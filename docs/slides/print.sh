#!/bin/sh
# print.sh HTML PDF - a deck as a browser prints it, without a network; HTML may end
# with #notes.
set -eu
profile=$(mktemp -d)
trap 'rm -rf "$profile"' EXIT
file=${1%%#*}
chromium --headless --no-sandbox --disable-gpu --no-first-run \
    --disable-background-networking --disable-component-update --disable-sync \
    --user-data-dir="$profile" --no-pdf-header-footer --print-to-pdf="$2" \
    "file://$(cd "$(dirname "$file")" && pwd)/$(basename "$1")" >"$profile/said" 2>&1 ||
    { cat "$profile/said" >&2; exit 1; }
[ -s "$2" ]
