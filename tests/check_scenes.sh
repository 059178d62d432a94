#!/bin/sh
# check_scenes.sh BUILD - every scene, small.
#
# Both forms, and the vector form with queues of any length, give the same
# frame, bit for bit; the frame is the plain C tracer's, and that one is
# POV-Ray's picture of the same file, within the tolerances that check_scene
# states.  The way of 1984 to patches gives the plain tracer's frame, too.
set -u
build=$1
width=120 height=90
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0

# Scenes with Steiner patches, which POV-Ray does not know.
without_povray="scenes/car.pov scenes/steiner.pov tests/scenes/patches.pov"

is_listed() { # SCENE LIST
    case " $(echo $2) " in *" $1 "*) return 0 ;; esac
    return 1
}

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
    "$build/rt205" render "$scene_file" -o "$work/frame.exr" -W $width \
        -H $height "$@" | sed -n 's/^frame checksum //p'
}

same_frames() { # SCENE: of all forms and queues; leaves frame.exr
    frame=$(checksum "$1" --mode scalar)
    [ -n "$frame" ]
    verdict $? "$1: no frame"
    for queue in 1 77 2000 65535; do
        [ "$(checksum "$1" --mode vector --queue $queue)" = "$frame" ]
        verdict $? "$1: a queue of $queue gives another frame"
    done
}

# Equal in both forms, but not to the other way's frame in the last bits.
same_historical() { # SCENE; leaves frame.exr
    frame=$(checksum "$1" --historical --mode scalar)
    [ -n "$frame" ] &&
        [ "$(checksum "$1" --historical --mode vector)" = "$frame" ]
    verdict $? "$1: the forms of the way of 1984 give different frames"
}

for scene in scenes/*.pov tests/scenes/*.pov; do
    [ -e "$scene" ] || continue
    povray=--povray
    is_listed "$scene" "$without_povray" && povray=
    same_frames "$scene"
    "$build/tests/oracle/check_scene" "$scene" $width $height \
        "$work/frame.exr" $povray
    verdict $? "$scene: not what the other tracers see"
    [ -z "$povray" ] || continue
    same_historical "$scene"
    "$build/tests/oracle/check_scene" "$scene" $width $height \
        "$work/frame.exr"
    verdict $? "$scene: the way of 1984 sees something else"
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
