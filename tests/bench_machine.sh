#!/bin/sh
# bench_machine.sh BUILD - the speed of the emulation: prints the tables of those
# tests/bench_*.c that no other script runs, and adds them, cell by cell, to the CSV
# file.
set -eu
build=$1
. "$(dirname "$0")/measure.sh"

for program in tests/bench_*.c; do
    name=$(basename "$program" .c)
    case $name in bench_trace | bench_ranks | bench_ray_query) continue ;; esac
    run "$build/tests/$name" "$trials" >"$work/table"
    cat "$work/table"
    echo
    cells "${name#bench_}" <"$work/table" >>"$results"
    check_rows >&2
done
