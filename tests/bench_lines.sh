#!/bin/sh
# bench_lines.sh BUILD - the machine's clocks to find all that is seen along lines, in
# both forms (tests/bench_lines.c).
set -eu
"$1/tests/bench_lines" scenes/finned_tube.pov scenes/flake.pov scenes/bracket.pov \
    scenes/bearing.pov scenes/pipe_flange.pov | tee "$1/bench_lines.txt"
awk 'NR > 2 {
    what = $1
    for (i = 2; i <= NF - 4; i++)
        what = what " " $i
    gsub(/,/, "", what)
    printf "lines,%s,scalar clocks,%s\nlines,%s,vector clocks,%s\n",
        what, $(NF - 2), what, $(NF - 1)
}' "$1/bench_lines.txt" >>"${BENCH_CSV:-/dev/null}"
