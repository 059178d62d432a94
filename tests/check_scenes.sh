#!/bin/sh
# check_scenes.sh BUILD all|some SCENE .. - each of these scenes, small.
#
# The three stages, with queues of any length, by tiles and by rows, with and
# without bounding volumes, with and without a hierarchy of them, give the same
# frame, bit for bit; the frame is the plain C tracer's, and that one is
# POV-Ray's picture of the same file, within the tolerances that check_scene
# states.  The way of 1984 to patches and cylinders gives the plain tracer's
# frame, too.
#
# some: not in all of these ways but in a third of them, some scenes in these and some in
# those, as their names have it; all three stages are in each third.
#
# Frames are small; smaller, stage against stage, of the scenes that are to be looked
# at, which have many parts.
set -u
. "$(dirname "$0")/count.sh"
build=$1 ways=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Scenes with Steiner patches, which POV-Ray does not know.
without_povray="scenes/car.pov scenes/steiner.pov tests/scenes/patches.pov
    tests/scenes/csg_patches.pov"
# What POV-Ray leaves to the rounding of its numbers, as rays to the edges of a
# mesh; of characters it keeps them in 32 bits; normals that it interpolates
# over the cells of a height_field, not over triangles; an orthographic camera with
# a lens, with which its picture is of one colour; rays through a lens, which are
# random; it sees nothing of a blob from nearer than .01, as a mirrored ray may; it
# loses one of two coincident faces of a clear body and of another one.
not_for_povray="tests/scenes/lens_orthographic.pov
    tests/scenes/coincident.pov tests/scenes/csg_coincident.pov
    tests/scenes/standing.pov tests/scenes/touching.pov
    tests/scenes/text.pov tests/scenes/mesh_closed.pov scenes/terrain.pov
    scenes/stage.pov scenes/mist.pov scenes/marbles.pov scenes/drops.pov"
# Through a lens, where POV-Ray's rays are random.
roughly_povray="tests/scenes/lens.pov"
# Of thousands of triangles, each of which the plain tracer asks, or of many
# components, or that send many rays: fewer pixels.
of_triangles="scenes/shell.pov scenes/terrain.pov scenes/sails.pov
    scenes/vase.pov scenes/mist.pov scenes/drops.pov scenes/marbles.pov
    scenes/stage.pov"
# A face of a cylinder in that of a box: rounding says which is met; cylinders
# that are parts of blobs alone.
not_historical="scenes/bearing.pov scenes/drops.pov tests/scenes/blobs.pov"

# Whether ways of this number, 0 to 2, are this scene's.
turn() { # NUMBER
    [ "$ways" = all ] || [ $((($1 + key) % 3)) -eq 0 ]
}

is_listed() { # SCENE LIST
    printf "%s" "$2" | tr -s " \n" "\n" | grep -qxF "$1"
}

# The size of a small frame is four words.
# shellcheck disable=SC2086
checksum() { # SCENE OPTIONS ..: of a small frame
    scene_file=$1
    shift
    "$build/rt205" render "$scene_file" --no-picture $small "$@" |
        sed -n 's/^frame checksum //p'
}

render() { # SCENE NAME OPTION ..: a frame for the other tracers, and its file
    scene_file=$1 frame_file=$work/$2.exr
    shift 2
    rm -f "$frame_file"
    "$build/rt205" render "$scene_file" -o "$frame_file" -W $width -H $height \
        "$@" >/dev/null
    echo "$frame_file"
}

# The other tracers are asked once, for both ways.
# An option or a file that is not there is no word.
# shellcheck disable=SC2086
same_as_others() { # SCENE OPTION OPTION: of check_scene; of the other way, or none
    frame_file=$(render "$1" frame)
    other_file=
    [ -z "$3" ] || other_file=$(render "$1" other "$3")
    "$build/tests/oracle/check_scene" "$1" $width $height "$frame_file" $2 \
        $other_file
}

same_stages() { # WHAT SCENE OPTION ..
    what=$1
    shift
    serial=$(checksum "$@" --mode scalar)
    [ -n "$serial" ] && [ "$(checksum "$@")" = "$serial" ] &&
        [ "$(checksum "$@" --mode kernels)" = "$serial" ]
    verdict $? "$1: $what the stages give different frames"
}

same_as_frame() { # TURN WHAT SCENE OPTION ..
    turn "$1" || return 0
    what=$2
    shift 2
    [ "$(checksum "$@")" = "$frame" ]
    verdict $? "$1: $what gives another frame"
}

# A ray at a time takes long: of fewer pixels.
same_queue_of_1() { # SCENE
    serial=$(checksum "$1" -W 18 -H 14 --mode scalar)
    [ -n "$serial" ] && [ "$(checksum "$1" -W 18 -H 14 --queue 1)" = "$serial" ]
    verdict $? "$1: a queue of 1 gives another frame"
}

same_frames() { # SCENE: of all stages and queues
    frame=$(checksum "$1" --mode scalar)
    [ -n "$frame" ]
    verdict $? "$1: no frame"
    turn 0 && same_queue_of_1 "$1"
    same_as_frame 1 "a queue of 77" "$1" --queue 77
    same_as_frame 2 "a queue of 2000" "$1" --queue 2000
    same_as_frame 2 "a queue of 65535" "$1" --queue 65535
    same_as_frame 0 "the paper's stage" "$1" --mode kernels --queue 333
    same_as_frame 0 "by rows the vector form" "$1" --order rows --queue 77
    same_as_frame 2 "the paper's stage by tiles" "$1" --mode kernels \
        --order tiles --queue 50
    turn 1 &&
        same_stages "of four rays a pixel" "$1" -W 20 -H 15 --samples 2
    turn 2 && ! grep -q aperture "$1" &&
        same_stages "of more rays where pixels differ" "$1" -W 34 -H 5 \
            --samples 2 --threshold .2
    same_as_frame 0 "every crossing of solids" "$1" --visible every
    same_as_frame 0 "without bounding volumes scalar" "$1" --mode scalar \
        --no-bounds
    same_as_frame 2 "without bounding volumes vector" "$1" --no-bounds
    same_as_frame 1 "without a hierarchy the vector form" "$1" --flat
}

# Equal in both forms, but not to the other way's frame in the last bits.
same_historical() { # SCENE
    frame=$(checksum "$1" --historical --mode scalar)
    [ -n "$frame" ] &&
        [ "$(checksum "$1" --historical --mode vector)" = "$frame" ]
    verdict $? "$1: the forms of the way of 1984 give different frames"
}

for scene in "$@"; do
    key=$(printf '%s' "$scene" | cksum | cut -d ' ' -f 1)
    small="-W 50 -H 38" width=120 height=90
    case $scene in scenes/*) small="-W 36 -H 27" ;; esac
    is_listed "$scene" "$of_triangles" && width=60 height=45
    povray=--povray
    is_listed "$scene" "$without_povray $not_for_povray" && povray=
    is_listed "$scene" "$roughly_povray" && povray=--roughly
    same_frames "$scene"
    historical=
    is_listed "$scene" "$without_povray" || grep -q cylinder "$scene" &&
        historical=--historical
    is_listed "$scene" "$not_historical" && historical=
    same_as_others "$scene" "$povray" "$historical"
    verdict $? "$scene: not what the other tracers see"
    [ -z "$historical" ] || same_historical "$scene"
done
echo "$*"
counted
