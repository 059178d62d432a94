#!/bin/sh
# run_all.sh MAKE JOBS PART .. [-- PART ..] - makes every part, even after failures, and
# sums the counts of the parts: lines "N passed, N failed", and the counts of cmocka. A
# part that fails without counts is one failure.
#
# JOBS + 1 parts run concurrently, with one job each, because some of them wait for
# signals, POV-Ray or MPI; they print their output when they end. Parts after -- run one
# after another, with all jobs.
set -u
make=$1 jobs=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

# Prints the output of a part at its end, so outputs are not mixed.
cat >"$work/part" <<'END'
begin=$(date +%s)
code=0
"$2" --no-print-directory JOBS="$3" "$4" >"$1/$4" 2>&1 || code=1
echo "$4: exit $code, $(($(date +%s) - begin)) s" >>"$1/$4"
flock "$1" cat "$1/$4"
END

run_parts() { # LANES JOBS PART ..: runs parts, LANES at a time
    lanes=$1 each=$2
    shift 2
    printf '%s\n' "$@" | xargs -n 1 -P "$lanes" \
        sh "$work/part" "$work" "$make" "$each"
}

together=
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    together="$together $1"
    shift
done
[ $# -eq 0 ] || shift
# shellcheck disable=SC2086
{
    run_parts $((jobs + 1)) 1 $together
    [ $# -eq 0 ] || run_parts 1 "$jobs" "$@"
} | tee "$work/log"

awk '
    /^[0-9]+ passed, [0-9]+ failed$/ { passed += $1; failed += $3 }
    /^\[  PASSED  \] [0-9]+ test/    { passed += $4 }
    /^\[  FAILED  \] [0-9]+ test/    { failed += $4 }
    /^[a-z-]+: exit [01], [0-9]+ s$/ {
        if ($3 == "1," && failed == before)
            failed++
        before = failed
    }
    END {
        printf "%d passed, %d failed\n", passed, failed
        exit failed > 0
    }' "$work/log"
