#!/bin/sh
# bench_jobs.sh BUILD - compares two concurrent bands with a single band in wall
# seconds, the minimum of several runs. The runs alternate.
set -eu
build=$1
. "$(dirname "$0")/measure.sh"
width=$(sized 640 64) height=$(sized 480 48)

printf '%-24s %11s %8s %9s %6s\n' "bands at a time" "" "one, s" "two, s" times
for scene in scenes/bench.pov scenes/bracket.pov; do
    for _ in $(seq "$trials"); do
        for jobs in 1 2; do
            ours $scene "$width" "$height" $jobs | cut -d ' ' -f 2
        done | paste -s -d ' '
    done | least >"$work/times"
    read -r one two <"$work/times"
    times=$(quotient "$one" "$two")
    printf '%-24s %4d x %4d %8.2f %9.2f %6s\n' $scene "$width" "$height" "$one" "$two" \
        "$times"
    keep jobs $scene one "$one" two "$two" times "$times"
done
