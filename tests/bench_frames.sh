#!/bin/sh
# bench_frames.sh BUILD - measures the time of tracing a frame of each scene in vector
# form, and compares it with POV-Ray's for the same file. Both use one thread, in turn.
#
# The figures are processor seconds, the minimum of several runs. They exclude reading
# the scene and writing a picture. The first scene was made for this comparison. Its
# Steiner patches are meshes in POV-Ray.
set -eu
build=$1
. "$(dirname "$0")/measure.sh"

compare() { # SCENE WIDTH HEIGHT: prints a row of the table
    for _ in $(seq "$trials"); do
        echo "$(ours "$@" | cut -d ' ' -f 1) $(theirs "$@")"
    done | least >"$work/times"
    read -r seconds povray <"$work/times"
    ratio=$(quotient "$seconds" "$povray")
    printf '%-24s %4d x %4d %8.2f %9.2f %6s\n' "$@" "$seconds" "$povray" \
        "$ratio"
    keep frames "$1" seconds "$seconds" povray "$povray" ratio "$ratio"
}

printf '%-24s %11s %8s %9s %6s\n' "trace of a frame" "" "rt205, s" \
    "povray, s" ratio
compare scenes/bench.pov "$(sized 1024 120)" "$(sized 768 90)"
compare scenes/bracket.pov "$(sized 1024 40)" "$(sized 1024 40)"
for scene in $(sized "$(echo scenes/*.pov)" "$(echo scenes/s*.pov)"); do
    case $scene in scenes/bench.pov | scenes/bracket.pov) continue ;; esac
    # POV-Ray draws a random number of rays through a lens.
    grep -q focal_point "$scene" && continue
    compare "$scene" "$(sized 640 80)" "$(sized 480 60)"
done
