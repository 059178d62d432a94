#!/bin/sh
# bench_ranks.sh BUILD - two ranks to one process, seconds on the wall of whole commands;
# beside them two processes that know nothing of each other and do half of the units each,
# which is what the machine can do with both of its processors; what their units are; and
# what rank 0 does for a unit of another rank.  docs/cluster.md reads a model from it.
# RANKS: of these rows.
#
# What one processor does in a minute changes by a tenth on a machine that others use, too,
# and the least of several runs compares the best moment of one with that of two.  So the three
# are timed at once, one after the other, and of several such trials the one counts whose
# ratio is in the middle; the lowest and the highest ratio stand beside it.
set -eu
build=$1
. "$(dirname "$0")/measure.sh"
RT205_LIBDIR=$build
OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export RT205_LIBDIR OMPI_ALLOW_RUN_AS_ROOT OMPI_ALLOW_RUN_AS_ROOT_CONFIRM

frame="render scenes/bracket.pov -W 1360 -H 1020 --samples 3"
mass="mass scenes/bracket.pov --density default=1 --rays 2097152"
rays="heat scenes/burner.pov --by part --rays 4096"
lines="heat scenes/burner.pov --by part --lines 8388608"

seconds() { # OPTION ..: of the command in $run
    [ $kind != frame ] || set -- "$@" -o "$work/frame.png"
    before=$(date +%s%N)
    "$build/rt205" $run "$@" >/dev/null 2>&1
    echo "$before $(date +%s%N)" | awk '{ printf "%.3f\n", ($2 - $1) / 1e9 }'
}

# .. of two of them at a time, each with half of the units.
seconds_apart() {
    rm -f "$work/half1" "$work/half2"
    before=$(date +%s%N)
    for half in 1 2; do
        "$build/rt205" $run --jobs 1 --part $half/2 --resume "$work/half$half" \
            >/dev/null 2>&1 &
    done
    wait
    echo "$before $(date +%s%N)" | awk '{ printf "%.3f\n", ($2 - $1) / 1e9 }'
}

# Their number and their bytes in a file.
units_of() { # OPTION ..
    rm -f "$work/units"
    "$build/rt205" $run --part 1/1 --resume "$work/units" 2>&1 |
        sed -n 's/.* of \([0-9]*\) units$/\1/p'
    wc -c <"$work/units"
}

# Of lines with the seconds of one, of two and of two apart: the ratio in the middle, the
# line that has it, the lowest ratio, the highest.
middle() {
    awk '{ printf "%.2f %s\n", $1 / $2, $0 }' | sort -n |
        awk '{ line[NR] = $0; ratio[NR] = $1 }
            END { print line[int((NR + 1) / 2)], ratio[1], ratio[NR] }'
}

printf '%-8s %7s %11s %9s %8s %9s %6s %13s %9s\n' ranks units bytes/unit ms/unit \
    "one, s" "two, s" times "of all trials" "apart, s"
for kind in ${RANKS:-frame mass rays lines}; do
    eval "run=\$$kind"
    units_of | paste -s -d ' ' >"$work/units.of"
    read -r units bytes <"$work/units.of"
    for _ in $(seq "$trials"); do
        echo "$(seconds --jobs 1) $(seconds --ranks 2) $(seconds_apart)"
    done | middle >"$work/times"
    read -r times one two apart low high <"$work/times"
    each=$((bytes / units))
    unit=$(awk -v s="$one" -v n="$units" 'BEGIN { printf "%.1f", 1000 * s / n }')
    printf '%-8s %7d %11d %9s %8s %9s %6s %13s %9s\n' $kind "$units" "$each" \
        "$unit" "$one" "$two" "$times" "$low to $high" "$apart"
    keep ranks $kind units "$units" bytes/unit "$each" ms/unit "$unit" \
        one "$one" two "$two" times "$times" apart "$apart" low "$low" high "$high"
done

run="render scenes/bracket.pov -W 8 -H 8" kind=frame
for _ in $(seq "$trials"); do
    echo "$(seconds --jobs 1) $(seconds --ranks 2)"
done | least >"$work/times"
read -r one two <"$work/times"
printf '%-8s %7s %11s %9s %8s %9s\n' "8 x 8" "" "" "" "$one" "$two"
keep ranks "8 x 8" one "$one" two "$two"

printf '\n%-28s %10s\n' "rank 0, bytes of a unit" us/unit
for words in 16 512 8192 65536; do
    for _ in $(seq "$trials"); do
        mpirun --oversubscribe --bind-to none -n 8 \
            "$build/tests/bench_ranks" 2000 $words | cut -d ' ' -f 2
    done | least >"$work/times"
    load=$(awk '{ printf "%.1f", 1e6 * $1 }' "$work/times")
    printf '%-28d %10s\n' $((8 * words)) "$load"
    keep ranks "rank 0, $((8 * words))" us/unit "$load"
done
