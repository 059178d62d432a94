#!/bin/sh
# check_language.sh - what tests/language/*.txt says that POV-Ray prints is what
# it prints.  That ours is the same is a unit test's.
set -u
root=$(dirname "$0")/..
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0

command -v povray >/dev/null || { echo "(POV-Ray is not installed)"; exit 0; }
for list in "$root"/tests/language/*.pov; do
    name=$(basename "$list" .pov)
    cp "$list" "$work/$name.pov"
    (cd "$work" && povray "+I$name.pov" +W1 +H1 -D -F "+GD$name.txt" \
        >/dev/null 2>&1)
    if cmp "$work/$name.txt" "${list%.pov}.txt"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAIL $list: POV-Ray prints something else"
    fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
