#!/bin/sh
# bench_ray_query.sh BUILD - measures the clocks of the machine for all-hits ray
# queries, in both forms (tests/bench_ray_query.c).
set -eu
build=$1
. "$(dirname "$0")/measure.sh"

set -- scenes/flake.pov scenes/finned_tube.pov scenes/bracket.pov scenes/bearing.pov \
    scenes/pipe_flange.pov
[ "$(sized full small)" = full ] || set -- "$1"
run "$build/tests/bench_ray_query" "$@" >"$work/table"
cat "$work/table"
awk 'NR > 2 {
    what = $1
    for (i = 2; i <= NF - 4; i++)
        what = what " " $i
    gsub(/,/, "", what)
    printf "ray_query,%s,scalar clocks,%s\nray_query,%s,vector clocks,%s\n",
        what, $(NF - 2), what, $(NF - 1)
}' "$work/table" >>"$results"
