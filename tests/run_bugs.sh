#!/bin/sh
# run_bugs.sh BUILD - inputs that once broke something, tests/bugs/TARGET/*,
# each through its fuzz target (tests/fuzz/) once more.
set -u
build=$1
passed=0 failed=0
for file in tests/bugs/*/*; do
    [ -f "$file" ] || continue
    if "$build/tests/fuzz/replay_$(basename "$(dirname "$file")")" "$file"
    then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAIL $file"
    fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
