#!/bin/sh
# browser.sh FILE[#PART] OPTION .. - opens a file in Chromium, without a window, and runs
# the actions of the options. The profile is removed afterwards.
set -eu
file=${1%%#*} part=${1#"${1%%#*}"}
shift
profile=$(mktemp -d)
trap 'rm -rf "$profile"' EXIT
chromium --headless --no-sandbox --disable-gpu --no-first-run \
    --disable-background-networking --disable-component-update --disable-sync \
    --user-data-dir="$profile/user" --window-size=1280,720 "$@" \
    "file://$(cd "$(dirname "$file")" && pwd)/${file##*/}$part" 2>"$profile/said" ||
    { cat "$profile/said" >&2; exit 1; }
