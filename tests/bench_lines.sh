#!/bin/sh
# bench_lines.sh BUILD - the machine's clocks of all-hits ray queries, in both forms
# (tests/bench_lines.c).
set -eu
build=$1
. "$(dirname "$0")/measure.sh"

set -- scenes/flake.pov scenes/finned_tube.pov scenes/bracket.pov scenes/bearing.pov \
    scenes/pipe_flange.pov
[ "$(sized full small)" = full ] || set -- "$1"
run "$build/tests/bench_lines" "$@" >"$work/table"
cat "$work/table"
awk 'NR > 2 {
    what = $1
    for (i = 2; i <= NF - 4; i++)
        what = what " " $i
    gsub(/,/, "", what)
    printf "lines,%s,scalar clocks,%s\nlines,%s,vector clocks,%s\n",
        what, $(NF - 2), what, $(NF - 1)
}' "$work/table" >>"$results"
