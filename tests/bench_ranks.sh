#!/bin/sh
# bench_ranks.sh BUILD - compares two ranks with one process, in wall seconds of
# complete commands. The rows also contain two separate processes with half of the units
# each, which is the limit on a machine with two processors; the number and size of the
# units; and the work of rank 0 per unit of another rank. docs/cluster.md derives a
# model from them. RANKS lists the rows; empty: none.
#
# The speed of a shared processor changes by a tenth within a minute, and the minimum of
# several runs would compare the best moments of different runs. Each trial therefore
# times the three commands in sequence. The trial with the median ratio counts. The
# lowest and the highest ratio are printed next to it.
set -eu
build=$1
. "$(dirname "$0")/measure.sh"
trials=${TRIALS:-$(sized 3 1)} # a row takes long
OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_ALLOW_RUN_AS_ROOT OMPI_ALLOW_RUN_AS_ROOT_CONFIRM

scene=$(sized scenes/bracket.pov scenes/first.pov)
command_of() { # KIND: prints the command and its options
    case $1 in
    frame) echo "render $scene" \
        "$(sized "-W 1360 -H 1020 --samples 2" "-W 32 -H 24")" ;;
    mass) echo "mass scenes/bracket.pov --density default=1" \
        "--rays $(sized 1048576 16)" ;;
    rays) echo "heat scenes/burner.pov --by part --rays $(sized 2048 "1 --repeats 2")" ;;
    lines) echo "heat scenes/burner.pov --by part --lines $(sized 4194304 256)" ;;
    tiny) echo "render $scene -W 8 -H 8" ;;
    esac
}

tracer() { # OPTION ..: runs the command of the kind
    # A command is several words.
    # shellcheck disable=SC2046
    run "$build/rt205" $(command_of "$kind") "$@" 2>>"$messages"
}

seconds() { # OPTION ..: prints the seconds of the command of the kind
    case $kind in frame | tiny) set -- "$@" -o "$work/frame.png" ;; esac
    before=$(date +%s%N)
    tracer "$@" >/dev/null
    echo "$before $(date +%s%N)" | awk '{ printf "%.3f\n", ($2 - $1) / 1e9 }'
}

# Prints the wall seconds of two concurrent processes, each with half of the units.
seconds_apart() {
    rm -f "$work/half1" "$work/half2"
    before=$(date +%s%N)
    for half in 1 2; do
        tracer --jobs 1 --part $half/2 --resume "$work/half$half" >/dev/null &
    done
    wait
    echo "$before $(date +%s%N)" | awk '{ printf "%.3f\n", ($2 - $1) / 1e9 }'
}

# Prints the number of units and their size in a file, in bytes.
units_of() {
    rm -f "$work/units"
    tracer --part 1/1 --resume "$work/units" >/dev/null
    sed -n 's/.* of \([0-9]*\) units$/\1/p' "$messages" | tail -n 1
    wc -c <"$work/units"
}

# Reads lines with the seconds of one process, of two ranks and of two separate
# processes. Prints the median ratio, its line, and the lowest and highest ratio.
middle() {
    awk '{ printf "%.2f %s\n", $1 / $2, $0 }' | sort -n |
        awk '{ line[NR] = $0; ratio[NR] = $1 }
            END { print line[int((NR + 1) / 2)], ratio[1], ratio[NR] }'
}

printf '%-8s %7s %11s %9s %8s %9s %6s %13s %9s\n' ranks units bytes/unit ms/unit \
    "one, s" "two, s" times "of all trials" "apart, s"
for kind in ${RANKS-frame mass rays lines}; do
    units_of | paste -s -d ' ' >"$work/units.of"
    read -r units bytes <"$work/units.of"
    for _ in $(seq "$trials"); do
        echo "$(seconds --jobs 1) $(seconds --ranks 2) $(seconds_apart)"
    done | middle >"$work/times"
    read -r times one two apart low high <"$work/times"
    each=$((bytes / units))
    unit=$(awk -v s="$one" -v n="$units" 'BEGIN { printf "%.1f", 1000 * s / n }')
    printf '%-8s %7d %11d %9s %8s %9s %6s %13s %9s\n' "$kind" "$units" "$each" \
        "$unit" "$one" "$two" "$times" "$low to $high" "$apart"
    keep ranks "$kind" units "$units" bytes/unit "$each" ms/unit "$unit" \
        one "$one" two "$two" times "$times" apart "$apart" low "$low" high "$high"
done

kind=tiny
for _ in $(seq "$trials"); do
    echo "$(seconds --jobs 1) $(seconds --ranks 2)"
done | least >"$work/times"
read -r one two <"$work/times"
printf '%-8s %7s %11s %9s %8s %9s\n' "8 x 8" "" "" "" "$one" "$two"
keep ranks "8 x 8" one "$one" two "$two"

printf '\n%-28s %10s\n' "rank 0, bytes of a unit" us/unit
for words in 16 $(sized "512 8192 65536" ""); do
    for _ in $(seq "$trials"); do
        run mpirun --oversubscribe --bind-to none -n "$(sized 8 2)" \
            "$build/tests/bench_ranks" "$(sized 2000 50)" "$words" | cut -d ' ' -f 2
    done | least >"$work/times"
    load=$(awk '{ printf "%.1f", 1e6 * $1 }' "$work/times")
    printf '%-28d %10s\n' $((8 * words)) "$load"
    keep ranks "rank 0, $((8 * words))" us/unit "$load"
done
