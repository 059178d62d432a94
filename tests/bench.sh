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
# Without names, all of them.  TRIALS: the number of runs of which the least counts (5).
# SIZE=small: each part once, as small as it can be, to see that it runs.  The figures are
# also in BUILD/bench.csv, a line each; BENCH_CSV names another file.
#
# The status is 1 if a part fails: a command of it failed, or a row has no figure.
set -eu
build=$1
shift
BENCH_CSV=${BENCH_CSV:-$build/bench.csv}
export BENCH_CSV
cd "$(dirname "$0")/.."
all="machine hosts frames jobs ranks stages visible lines growth goals"
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
