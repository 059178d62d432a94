#!/bin/sh
# bench_machine.sh BUILD - how fast the host emulates: what those of tests/bench_*.c print
# that no other script calls, for reading and, cell by cell, for other programs.
set -eu
build=$1
. "$(dirname "$0")/measure.sh"

for program in tests/bench_*.c; do
    name=$(basename "$program" .c)
    case $name in bench_trace | bench_ranks | bench_lines) continue ;; esac
    run "$build/tests/$name" "$trials" >"$work/table"
    cat "$work/table"
    echo
    cells "${name#bench_}" <"$work/table" >>"$results"
    check_rows >&2
done
