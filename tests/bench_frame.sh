#!/bin/sh
# bench_frame.sh BUILD - the trace of a frame of each scene, in vector form,
# beside POV-Ray's own trace time of the same file; one thread each, in turn.
#
# Processor seconds, the least of three runs.  Neither counts the reading of
# the scene, nor is a picture written.  The scene that was made for this
# comparison is first; POV-Ray shows Steiner patches as meshes.
set -eu
build=$1
trials=3

povray_trace() { # SCENE WIDTH HEIGHT: of one run
    povray "+I$1" "+W$2" "+H$3" +WT1 -F -D -A +Lscenes 2>&1 |
        awk '/Trace Time:/ { trace = 1; next }
            trace && /CPU-seconds/ { print $(NF - 2); exit }'
}

povray_best() { # SCENE WIDTH HEIGHT
    for _ in $(seq $trials); do
        povray_trace "$@"
    done | sort -n | head -n 1
}

compare() { # SCENE WIDTH HEIGHT
    ours=$("$build/tests/bench_trace" "$@" $trials)
    theirs=$(povray_best "$@")
    echo "$1 $2 $3 $ours $theirs" | awk '{
        printf "%-24s %4d x %4d %8.2f %9.2f", $1, $2, $3, $4, $5
        if ($5 > 0)
            printf " %6.2f", $4 / $5
        print ""
    }'
}

printf '%-24s %11s %8s %9s %6s\n' "trace of a frame" "" "rt205, s" \
    "povray, s" ratio
command -v povray >/dev/null || { echo "(POV-Ray is not installed)"; exit 0; }
compare scenes/bench.pov 1024 768
compare scenes/bracket.pov 1024 1024
for scene in scenes/*.pov; do
    case $scene in scenes/bench.pov | scenes/bracket.pov) continue ;; esac
    compare "$scene" 640 480
done
