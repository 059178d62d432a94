#!/bin/sh
# bench_frame.sh BUILD - a frame of each scene, whole commands: rt205 in vector
# form beside POV-Ray with one thread, in turn; the best of three each.
set -eu
build=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

best() { # COMMAND ..: the shortest of three runs, in milliseconds
    least=
    for _ in 1 2 3; do
        begin=$(date +%s%N)
        "$@" >/dev/null 2>&1
        now=$((($(date +%s%N) - begin) / 1000000))
        [ -n "$least" ] && [ "$least" -le "$now" ] || least=$now
    done
    echo "$least"
}

printf '%-26s %10s %10s %7s\n' "frame, 640 x 480" "rt205, ms" "povray, ms" \
    ratio
command -v povray >/dev/null || { echo "(POV-Ray is not installed)"; exit 0; }
for scene in scenes/*.pov; do
    ours=$(best "$build/rt205" render "$scene" -o "$work/a.png")
    theirs=$(best povray "+I$scene" "+O$work/b.png" +W640 +H480 -D -A +WT1 \
        +Lscenes)
    printf '%-26s %10d %10d %7s\n' "$scene" "$ours" "$theirs" \
        "$((ours / theirs)).$((ours * 10 / theirs % 10))"
done
