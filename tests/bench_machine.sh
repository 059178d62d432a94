#!/bin/sh
# bench_machine.sh BUILD - measures the speed of the emulation. It prints the tables of
# tests/bench_*.c that no other script runs, and adds them to the CSV file.
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
