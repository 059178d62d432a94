#!/bin/sh
# bench_machine.sh BUILD - how fast the host emulates: what tests/bench_*.c
# print, for reading and, cell by cell, for other programs.
set -eu
build=$1
. "$(dirname "$0")/measure.sh"

# Cells end where the headings of their columns do.
cells() { # PROGRAM: of what it printed
    awk -v program="$1" '
        function ends_of(line,    at) {
            for (count = at = 0; match(line, /[^ ]+( [^ ]+)*/);
                 line = substr(line, RSTART + RLENGTH)) {
                heading[++count] = substr(line, RSTART, RLENGTH)
                end[count] = at += RSTART + RLENGTH - 1
            }
        }
        NR == 1 { ends_of($0); first = /^ / ? 1 : 2; next }
        {
            name = $0
            sub(/  .*/, "", name)
            for (i = first; i <= count; i++) {
                cell = substr($0, 1, end[i])
                sub(/.* /, "", cell)
                if (length($0) >= end[i] && cell ~ /^[0-9.]+$/)
                    printf "%s,\"%s\",%s,%s\n", program, name, heading[i],
                        cell
            }
        }'
}

for program in tests/bench_*.c; do
    name=$(basename "$program" .c)
    [ "$name" != bench_trace ] || continue
    "$build/tests/$name" >"$work/said"
    cat "$work/said"
    echo
    cells "${name#bench_}" <"$work/said" >>"$results"
done
