#!/bin/sh
# fresh.sh - checks that each fault of bugs.list still has its place in the sources,
# whatever names have changed. make check-planted checks that it is found.
set -u
cd "$(dirname "$0")/../.." || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
awk -f tests/mutants/masked.awk -f tests/planted/plant.awk tests/planted/bugs.list \
    >"$work/places" 2>"$work/lost"
cat "$work/lost"
echo "$(wc -l <"$work/places") passed, $(wc -l <"$work/lost") failed"
[ ! -s "$work/lost" ]
