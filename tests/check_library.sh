#!/bin/sh
# check_library.sh BUILD [FILE ..] - compares the declarations in the files of
# rt/scene/library with POV-Ray's files of the same names, by pictures and by reports.
# It compares all names of POV-Ray's files, and calls of macros (tests/library.txt).
#
# A scene shows up to 192 declarations. A material or a number has one pixel, which must
# be the same to the last bit. A shape, which may be constructed differently, has 16
# pixels, which must be the same in an 8-bit picture. If two scenes differ, each
# declaration gets a separate scene.
set -u
. "$(dirname "$0")/count.sh"
root=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
ours=$root/rt/scene/library
shift
list=$root/tests/library.txt
# Macros that are not supported, derivatives of functions, use this name.
left_out=__Gradient_Fn_Accuracy_
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

# Our files must include only our files.
for file in "$ours"/*.inc; do
    sed -n 's/^#include "\(.*\)"$/\1/p' "$file" >"$work/included"
    while read -r name; do
        expect "$file: $name is not there" [ -f "$ours/$name" ]
    done <"$work/included"
done

theirs=
for folder in /usr/share /usr/local/share; do
    [ ! -f $folder/povray-3.7/include/colors.inc ] ||
        theirs=$folder/povray-3.7/include
done

# Prints the kind and the name of each declaration of a file outside of macros.
declared() { # FILE
    sed 's|//.*||' "$1" | tr '\n\t\r' '   ' | awk '
    {
        while ((from = index($0, "/*")) > 0) {
            rest = substr($0, from + 2)
            $0 = substr($0, 1, from - 1) " " \
                substr(rest, index(rest, "*/") + 2)
        }
        count = split($0, parts, "#")
        for (i = 2; i <= count; i++) {
            part = parts[i]
            if (part ~ /^(if|ifdef|ifndef|while|for|switch|macro)[ (]/) {
                depth++
                if (part ~ /^macro/ && !macro)
                    macro = depth
            } else if (part ~ /^end/) {
                if (depth-- == macro)
                    macro = 0
            } else if (part ~ /^declare / && !macro && part ~ /=/) {
                name = value = part
                sub(/ *=.*/, "", name)
                sub(/.* /, "", name)
                sub(/[^=]*= */, "", value)
                sub(/[^a-z_].*/, "", value)
                if (name ~ /\]$/ || value == "function")
                    continue
                if (value ~ /^(pigment|texture|finish|material|interior)$/)
                    print value, name
                else if (value ~ /^colou?r_map$/)
                    print "color_map", name
                else if (value ~ \
                    /^(sphere|box|plane|cone|cylinder|quadric|intersection)$/)
                    print "object", name
                else
                    print "number", name
            }
        }
    }' | sort -u
}

# Reads lines "KIND TEXT" and prints a scene, with the declarations of FILE.
scene() { # FILE
    cat <<END
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "$1"
#default { finish { ambient .1 diffuse .6 } }
camera { location -16*z direction 16*z right 16*x up 12*y }
light_source { <4, 5, -6>, 1 }
plane { -z, -2 pigment { rgb <.7, .8, .9> } }
END
    awk '
    {
        kind = $1
        sub(/^[^ ]* /, "")
        at = sprintf("<%.1f, %.1f, 0>", (NR - 1)%16 - 7.3,
            int((NR - 1)/16) - 5.3)
        ball = "sphere { " at ", .45 "
        if (kind == "pigment")
            print ball "pigment { " $0 " } }"
        else if (kind == "texture" || kind == "material")
            print ball kind " { " $0 " } }"
        else if (kind == "finish")
            print ball "pigment { rgb <.5, .6, .4> } finish { " $0 " } }"
        else if (kind == "interior")
            print ball "pigment { rgbf .8 } interior { " $0 " } }"
        else if (kind == "color_map")
            print ball "pigment { bozo color_map { " $0 " } } }"
        else if (kind == "number")
            print ball "pigment { rgbft .1*(" $0 ") } finish { ambient 1 } }"
        else if (kind == "object")
            print "intersection { object { " $0 " scale .3 rotate 20 }",
                "box { -.45, .45 } translate " at \
                " pigment { rgb <.5, .6, .4> } }"
        else if (kind == "mesh")
            print "union { " $0 " scale .3 rotate 20 translate " at \
                " pigment { rgb <.5, .6, .4> } }"
    }'
}

# Prints the picture and the reports of a scene. Reports about bounds are omitted,
# because bounds do not change a picture.
shown() { # SCENE FOLDER SIZE
    picture=--no-picture
    [ "$3" -eq 1 ] || picture="-o $work/picture.png"
    # The option and its file are two words.
    # shellcheck disable=SC2086
    "$build/rt205" render "$1" -W $((16 * $3)) -H $((12 * $3)) --jobs 1 \
        -I "$2" $picture >"$work/out" 2>"$work/err"
    if [ "$3" -eq 1 ]; then
        sed -n 's/^frame checksum //p' "$work/out"
    else
        # Pixels begin at the first IDAT. The texts before it differ.
        at=$(grep -abo IDAT "$work/picture.png" | sed 's/:.*//; q')
        tail -c "+$at" "$work/picture.png" | cksum
    fi
    sed -n '/: error: /p; s/.*: report: //p' "$work/err" |
        sed '/bounded_by/d; s/ ([0-9]* places.*//' | sort -u
}

same() { # SCENE SIZE: succeeds if both libraries give the same result
    shown "$1" "$theirs" "$2" >"$work/theirs"
    shown "$1" "$ours" "$2" >"$work/ours"
    cmp -s "$work/theirs" "$work/ours" && ! grep -q ': error: ' "$work/ours"
}

compare() { # FILE LINES SIZE: each line is "KIND TEXT"
    split -l 192 "$2" "$work/part."
    for part in "$work"/part.??; do
        [ -f "$part" ] || continue
        scene "$1" <"$part" >"$work/all.pov"
        if same "$work/all.pov" "$3"; then
            passed=$((passed + $(wc -l <"$part")))
        else
            while read -r line; do
                echo "$line" | scene "$1" >"$work/one.pov"
                same "$work/one.pov" "$3"
                verdict $? "$1: $line: $(diff "$work/theirs" "$work/ours")"
            done <"$part"
        fi
        rm "$part"
    done
}

[ $# -ne 0 ] || set -- "$ours"/*.inc
for file in "$@"; do
    name=$(basename "$file")
    sed -n "s/^$name //p" "$list" >"$work/calls"
    if [ -n "$theirs" ]; then
        declared "$theirs/$name" | grep -vw "$left_out" |
            cat - "$work/calls" >"$work/lines"
        grep -E '^(object|mesh) ' "$work/lines" >"$work/shapes"
        grep -Ev '^(object|mesh) ' "$work/lines" >"$work/looks"
        compare "$name" "$work/looks" 1
        compare "$name" "$work/shapes" 4
    else
        scene "$name" <"$work/calls" >"$work/all.pov"
        ! shown "$work/all.pov" "$ours" 1 | grep ': error: '
        verdict $? "$name cannot be read"
    fi
done
[ -n "$theirs" ] || echo "(POV-Ray's files are not installed)"
counted
