#!/bin/sh
# run_bugs.sh BUILD - the inputs that fuzzing begins with, those that once
# broke something among them (tests/bugs/TARGET/*), each through its fuzz
# target (tests/fuzz/) once more.  Of those of a target, one at least gets past
# its first check.
set -u
. "$(dirname "$0")/count.sh"
build=$1
corpus=$build/seeds
said=$build/replay.err
rm -rf "$corpus"
sh tests/fuzz/seed.sh "$build/c205" "$corpus"
refused=3 # the exit status of a replay
for folder in "$corpus"/*; do
    replay=$build/tests/fuzz/replay_$(basename "$folder")
    accepted=0
    for file in "$folder"/*; do
        "$replay" "$file" >"$said" 2>&1
        status=$?
        [ $status -eq 0 ] && accepted=$((accepted + 1))
        [ $status -eq 0 ] || [ $status -eq $refused ]
        verdict $? "$replay $file"
    done
    expect "$replay refuses every file of $folder" [ $accepted -gt 0 ]
done
counted
