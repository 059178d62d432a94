#!/bin/sh
# bench.sh BUILD [PART ..] - what is measured, in one report.
#
#   machine   host nanoseconds an element, instructions a second
#   hosts     nanoseconds an element by compiler and by vector unit
#   frames    the trace of a frame beside POV-Ray's
#   jobs      two bands at a time to one
#   ranks     two processes to one; what rank 0 does for a unit, of what size
#   stages    clocks of the machine in each way to trace a frame
#   visible   clocks of the ways to what is seen of a solid
#   lines     clocks to all that is seen along lines
#   growth    time, clocks and memory against the number of things
#   goals     what of that is to be reached
#
# All of them unless told.  TRIALS: of how many runs the least counts (5).  The
# figures are left in BUILD/bench.csv as well, a line each.
set -eu
build=$1
shift
BENCH_CSV=$build/bench.csv
export BENCH_CSV
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- machine hosts frames jobs ranks stages visible lines growth goals
echo "part,what,quantity,value" >"$BENCH_CSV"

for part in "$@"; do
    case $part in
    machine | hosts | frames | jobs | ranks | stages | visible | lines | growth | goals) ;;
    *) echo "bench.sh: no part $part" >&2 && exit 2 ;;
    esac
    sh "tests/bench_$part.sh" "$build"
    echo
done
echo "as a table: $BENCH_CSV"
