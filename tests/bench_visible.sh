#!/bin/sh
# bench_visible.sh BUILD - measures the cost of finding the visible face of a solid, by
# stepping and by testing every crossing (rt/kernels/solids/visible_vector.s).
#
# The figures are thousands of clocks of the machine: in the region `visible` of the
# kernels, and in the whole frame. The scenes are the scenes of the tests, and solids of
# 1 to 32 spheres: a box minus spheres across the view, a box minus spheres in a row
# along the view, and an intersection of spheres.
set -eu
build=$1
. "$(dirname "$0")/measure.sh"
width=$(sized 160 16) height=$(sized 120 12)
ways="stepping every"

spheres() { # COUNT LENGTH RADIUS AXIS: a row centred at the origin
    awk -v n="$1" -v length_of="$2" -v r="$3" -v axis="$4" 'BEGIN {
        for (i = 0; i < n; i++)
            printf "sphere { %.6f*%s, %.6f }\n",
                length_of * ((i + .5) / n - .5), axis, r
    }'
}

solid() { # KIND COUNT: prints a solid of COUNT spheres
    case $1 in
    across)
        echo "difference { box { <-2, -.6, -.4>, <2, .6, .4> }"
        spheres $(($2 - 1)) 4 .35 x
        ;;
    along)
        echo "difference { box { <-1.2, -.9, -2>, <1.2, .9, 2> }"
        spheres $(($2 - 1)) 4 .7 z
        ;;
    common)
        echo "intersection {"
        spheres "$2" .6 1.2 x
        ;;
    esac
    echo "}"
}

write_solid() { # KIND COUNT: prints a scene with one solid
    echo "camera { location <1, 1.5, -5> look_at 0 angle 45 }"
    echo "light_source { <-4, 8, -9>, 1 }"
    if [ "$2" -eq 1 ]; then
        echo "sphere { 0, 1.2 pigment { color rgb .8 } }"
    else
        solid "$1" "$2" | sed '$ s/}/pigment { color rgb .8 } }/'
    fi
}

clocks() { # SCENE METHOD: prints clocks of `visible` and the frame, and the checksum
    run "$build/rt205" render "$1" --no-picture -W "$width" \
        -H "$height" --visible "$2" --accounts --format csv 2>>"$messages" | awk -F, '
        /^scene,/ { for (i = 1; i <= NF; i++) at[$i] = i; next }
        at["clocks"] && !frame { frame = $at["clocks"]; sum = $at["checksum"] }
        $1 == "visible" && $2 == "all" { visible = $3 }
        END { if (visible != "") print visible, frame, sum }'
}

compare() { # NAME SCENE: prints and records the clocks of all methods
    for way in $ways; do
        clocks "$2" "$way"
    done | awk -v name="$1" -v ways="$ways" -v file="$results" '
        { visible[NR] = $1 / 1000; frame[NR] = $2 / 1000; sum[NR] = $3 }
        END {
            printf "%-30s", name
            for (i = 1; i <= NR; i++) printf " %9.0f", visible[i]
            for (i = 1; i <= NR; i++) printf " %9.0f", frame[i]
            print ""
            count = split(ways, way, " ")
            for (i = 1; i <= count; i++)
                printf "visible,\"%s\",%s,%s\n", name, way[i],
                    i in visible ? sprintf("%.0f", 1000 * visible[i]) : "" >>file
            for (i = 2; i <= NR; i++)
                if (sum[i] != sum[1]) { print "frames differ"; exit 1 }
        }'
}

echo "thousands of clocks of a frame of $width x $height pixels"
printf '%-30s %19s %19s\n' "" visible frame
# The methods are the headings.
# shellcheck disable=SC2086
printf '%-30s %9s %9s %9s %9s\n' scene $ways $ways
[ "$(sized full small)" = small ] || for scene in scenes/bench.pov tests/scenes/csg_*.pov; do
    compare "$scene" "$scene"
done
for kind in across along common; do
    for count in $(sized "1 2 4 8 16 32" 2); do
        write_solid "$kind" "$count" >"$work/solid.pov"
        compare "$kind, $count" "$work/solid.pov"
    done
done
