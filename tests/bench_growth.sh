#!/bin/sh
# bench_growth.sh BUILD - measures the cost of a frame by the number of its objects:
# spheres of a flake, small solids in a field, holes and knobs of a plate, or mesh.
#
# The figures are the processor seconds of this tracer and of POV-Ray, the clocks of the
# machine, and the maximum memory of the process. The exponent belongs to a power law in
# the number of objects. It is fitted by least squares in logarithms for 90 to 10,000
# objects. A row is skipped if its time would exceed LIMIT seconds (100), by
# extrapolation in proportion to the number of objects.
set -eu
build=$1
. "$(dirname "$0")/measure.sh"
trials=${TRIALS:-$(sized 2 1)} # a row takes long
width=$(sized 200 80) height=$(sized 150 60)
limit=${LIMIT:-100}

flake() { # DEPTH: prints the scene of a flake
    sed "s/^#declare Depth = .*/#declare Depth = $1;/" scenes/flake.pov
}

# The head of a scene: a camera above a square of $1 places.
above() { # COUNT
    cat <<END
#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Side = int(sqrt($1 - 1)) + 1;
#macro Place(I)
    <mod(I, Side) - Side/2, 0, div(I, Side) - Side/2>
#end
camera {
    location Side*<-0.3, 0.8, -0.9>
    right x * image_width / image_height
    angle 40
    look_at 0
}
light_source { Side*<-1, 2, -1.5>, 0.8 }
light_source { Side*<2, 1, -0.5>, rgb 0.3 }
END
}

# A field of bored boxes and lenses, in turn, so neighbours differ.
field() { # COUNT
    above "$1"
    cat <<END
#for (I, 0, $1 - 1)
    #if (mod(I, 2))
        intersection { sphere { -0.2*y, 0.4 } sphere { 0.2*y, 0.4 }
    #else
        difference { box { -0.28, 0.28 } cylinder { -y, y, 0.2 }
    #end
        pigment { color rgb <0.8, 0.6, 0.3> }
        rotate <13*I, 29*I, 0>
        translate Place(I) + mod(7*I, 5)/5*y
    }
#end
END
}

# A single solid: a plate with $1 holes and knobs, in turn.
plate() { # COUNT
    above "$1"
    cat <<END
difference {
    merge {
        box { Side*<-0.5, 0, -0.5> - <0.5, 0.2, 0.5>, Side*<0.5, 0, 0.5> }
        #for (I, 0, $1 - 1, 2)
            sphere { Place(I), 0.3 }
        #end
    }
    #for (I, 1, $1 - 1, 2)
        cylinder { Place(I) - y, Place(I) + y, 0.3 }
    #end
    pigment { color rgb <0.8, 0.6, 0.3> }
}
END
}

# A ball with bumps: $1 rows of $1 pairs of triangles.
mesh() { # ROWS
    cat <<END
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera {
    location <0, 1, -3.4>
    right x * image_width / image_height
    angle 44
    look_at 0
}
light_source { <-6, 4.5, -3>, 1 }
#declare Bumps = function(u, v) {
    1 + 0.12*sin(7*u)*sin(5*v) + 0.03*sin(31*u + 3*v)*sin(23*v)
}
#macro Point(I, J)
    #local U = 2*pi*I/$1;
    #local V = pi*J/$1;
    Bumps(U, V)*<cos(U)*sin(V), cos(V), sin(U)*sin(V)>
#end
mesh {
    #for (I, 0, $1 - 1)
        #for (J, 0, $1 - 1)
            triangle { Point(I, J), Point(I + 1, J), Point(I + 1, J + 1) }
            triangle { Point(I, J), Point(I + 1, J + 1), Point(I, J + 1) }
        #end
    #end
    pigment { color rgb <0.8, 0.6, 0.3> }
}
END
}

exponent() { # COLUMN: fits a power law to lines of a number and a measurement
    awk -v column="$1" '$1 >= 90 && $1 <= 10000 && $column > 0 {
            x = log($1); y = log($column)
            n++; sx += x; sy += y; sxx += x*x; sxy += x*y
        }
        END { if (n > 1)
                  printf "%.2f", (n*sxy - sx*sy) / (n*sxx - sx*sx) }'
}

measure() { # SCENE: prints the figures of this tracer and then of POV-Ray
    for _ in $(seq "$trials"); do
        echo "$(ours "$1" "$width" "$height" | cut -d ' ' -f 1,3,4)" \
            "$(theirs "$1" "$width" "$height")"
    done | least
}

is_too_long() { # COUNT: succeeds if a frame would exceed the limit of time
    tail -n 1 "$work/rows" | awk -v n="$1" -v limit="$limit" -v t="$trials" \
        'END { exit !(NR && $2 * t * n / $1 > limit) }'
}

show_exponents() { # NAME: prints and records the exponents of the rows
    seconds=$(exponent 2 <"$work/rows")
    clocks=$(exponent 3 <"$work/rows")
    memory=$(exponent 4 <"$work/rows")
    printf '%-18s %8s %9s %6s %9s %9s\n' "  exponent" "$seconds" "" "" \
        "$clocks" "$memory"
    keep growth "$1, exponent" seconds "$seconds" clocks "$clocks" \
        kilobytes "$memory"
}

grow() { # NAME SCENE PARAMETER:COUNT ..: SCENE prints the scene
    name=$1 scene=$2
    shift 2
    : >"$work/rows"
    for size in "$@"; do
        count=${size#*:}
        if is_too_long "$count"; then
            printf '%-8s %9d  (would take too long: LIMIT)\n' "$name" "$count"
            break
        fi
        $scene "${size%:*}" >"$work/scene.pov"
        measure "$work/scene.pov" >"$work/least"
        read -r seconds clocks memory povray <"$work/least"
        echo "$count $seconds $clocks $memory" >>"$work/rows"
        ratio=$(quotient "$seconds" "$povray")
        printf '%-8s %9d %8.3f %9.3f %6s %9.1f %9.1f\n' "$name" "$count" \
            "$seconds" "$povray" "$ratio" \
            "$(quotient "$clocks" 1000000)" "$(quotient "$memory" 1024)"
        keep growth "$name, $count" seconds "$seconds" povray "$povray" \
            ratio "$ratio" clocks "$clocks" kilobytes "$memory"
    done
    show_exponents "$name"
}

echo "a frame of $width x $height pixels"
printf '%-8s %9s %8s %9s %6s %9s %9s\n' of things "rt205, s" "povray, s" \
    ratio "M clocks" "memory, MB"
if [ "$(sized full small)" = full ]; then
    grow flake flake 1:10 2:91 3:820 4:7381 5:66430
    grow solids field 10:10 100:100 1000:1000 10000:10000
    grow plate plate 10:10 100:100 1000:1000
    grow mesh mesh 7:98 22:968 71:10082 224:100352
else
    grow flake flake 2:91 3:820
    grow solids field 100:100 144:144
    grow plate plate 100:100 144:144
    grow mesh mesh 7:98 10:200
fi
