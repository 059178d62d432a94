#!/bin/sh
# run_all.sh MAKE PART ... - make every part, whatever fails before it, and
# sum what the parts have counted: their lines "N passed, N failed", and those
# of cmocka.  A part that fails and has counted nothing counts as one failure.
set -u
make=$1
shift
log=$(mktemp)
trap 'rm -f "$log"' EXIT

for part in "$@"; do
    begin=$(date +%s)
    code=0
    "$make" --no-print-directory "$part" 2>&1 || code=1
    echo "$part: exit $code, $(($(date +%s) - begin)) s"
done | tee "$log"

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
    }' "$log"
