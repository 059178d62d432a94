#!/bin/sh
# check_language.sh - what tests/language/*.txt says that POV-Ray prints is what
# it prints.  That ours is the same is a unit test's.
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
