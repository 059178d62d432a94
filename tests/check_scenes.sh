#!/bin/sh
# check_scenes.sh BUILD - every scene, small.
#
# Both forms, and the vector form with queues of any length, give the same
# frame, bit for bit; the frame is the plain C tracer's, and that one is
# POV-Ray's picture of the same file, within the tolerances that check_scene
# states.
set -u
build=$1
width=120 height=90
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0

verdict() { # STATUS TEXT
    if [ "$1" -eq 0 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAIL $2"
    fi
}

checksum() { # SCENE OPTIONS ..: render into frame.exr, print the checksum
    scene_file=$1
    shift
    "$build/rt205" render "$scene_file" -o "$work/frame.exr" -W $width -H $height \
        "$@" | sed -n 's/^frame checksum //p'
}

for scene in scenes/*.pov tests/scenes/*.pov; do
    [ -e "$scene" ] || continue
    frame=$(checksum "$scene" --mode scalar)
    [ -n "$frame" ]
    verdict $? "$scene: no frame"
    for queue in 1 77 2000 65535; do
        [ "$(checksum "$scene" --mode vector --queue $queue)" = "$frame" ]
        verdict $? "$scene: a queue of $queue gives another frame"
    done
    "$build/tests/oracle/check_scene" "$scene" $width $height \
        "$work/frame.exr" --povray
    verdict $? "$scene: not what the other tracers see"
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
