#!/bin/sh
# bench.sh BUILD [PART ..] - runs the benchmarks and prints one report.
#
#   machine   host nanoseconds per element, instructions per second
#   hosts     nanoseconds per element by compiler and by vector unit
#   frames    the time of tracing a frame, compared with POV-Ray
#   jobs      two concurrent bands compared with one
#   ranks     two processes compared with one; the work of rank 0 per unit and its size
#   stages    clocks of the machine for each method of tracing a frame
#   visible   clocks of the methods of finding the visible surface of a solid
#   ray_query clocks of all-hits ray queries
#   growth    time, clocks and memory by number of objects
#   goals     target values for these figures
#
# All parts run if none is named. The fastest of TRIALS runs counts (5). SIZE=small runs
# each part once in its smallest size, which checks that it works. BUILD/bench.csv, or
# the file BENCH_CSV, also contains the figures, one per line.
#
# Exit status 1: a command of a part fails, or a row has no figure.
set -eu
build=$1
shift
BENCH_CSV=${BENCH_CSV:-$build/bench.csv}
export BENCH_CSV
cd "$(dirname "$0")/.."
all="machine hosts frames jobs ranks stages visible ray_query growth goals"
# The names are words.
# shellcheck disable=SC2086
[ $# -gt 0 ] || set -- $all
failed=
echo "part,what,quantity,value" >"$BENCH_CSV"

for part in "$@"; do
    case " $all " in
    *" $part "*) ;;
    *) echo "bench.sh: no part $part" >&2 && exit 2 ;;
    esac
    sh "tests/bench_$part.sh" "$build" || failed="$failed $part"
    echo
done
echo "as a table: $BENCH_CSV"
[ -z "$failed" ] || { echo "bench.sh: failed:$failed" >&2 && exit 1; }
