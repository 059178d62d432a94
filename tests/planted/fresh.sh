#!/bin/sh
# fresh.sh - each fault of bugs.list still has its place in the sources, whichever word is
# renamed.  Whether a part of make check finds it is for make check-planted.
set -u
cd "$(dirname "$0")/../.." || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
awk -f tests/mutants/masked.awk -f tests/planted/plant.awk tests/planted/bugs.list \
    >"$work/places" 2>"$work/lost"
cat "$work/lost"
echo "$(wc -l <"$work/places") passed, $(wc -l <"$work/lost") failed"
[ ! -s "$work/lost" ]
