#!/bin/sh
# run_bugs.sh BUILD - the inputs that fuzzing begins with, those that once
# broke something among them (tests/bugs/TARGET/*), each through its fuzz
# target (tests/fuzz/) once more.
set -u
build=$1
corpus=$build/seeds
passed=0 failed=0
rm -rf "$corpus"
sh tests/fuzz/seed.sh "$build/c205" "$corpus"
for folder in "$corpus"/*; do
    replay=$build/tests/fuzz/replay_$(basename "$folder")
    for file in "$folder"/*; do
        if "$replay" "$file" 2>"$build/replay.err"; then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
            echo "FAIL $replay $file"
            tail -n 12 "$build/replay.err"
        fi
    done
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
