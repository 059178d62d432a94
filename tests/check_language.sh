#!/bin/sh
# check_language.sh - compares the files tests/language/*.txt with the output of
# POV-Ray. A unit test compares them with the output of this project's reader.
set -u
. "$(dirname "$0")/count.sh"
root=$(dirname "$0")/..
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

command -v povray >/dev/null || { echo "(POV-Ray is not installed)"; exit 0; }
cp "$root"/tests/language/*.csv "$work"
for list in "$root"/tests/language/*.pov; do
    name=$(basename "$list" .pov)
    cp "$list" "$work/$name.pov"
    (cd "$work" && povray "+I$name.pov" +W1 +H1 -D -F "+GD$name.txt" \
        >/dev/null 2>&1)
    expect "$list: POV-Ray prints something else" cmp "$work/$name.txt" "${list%.pov}.txt"
done
counted
