#!/bin/sh
# run_bugs.sh BUILD - runs inputs through their fuzz targets (tests/fuzz/): the inputs
# with which fuzzing begins, including inputs that caused earlier failures
# (tests/bugs/TARGET/*). At least one input of each target must pass its first check.
set -u
. "$(dirname "$0")/count.sh"
build=$1
corpus=$build/seeds
said=$build/replay.err
rm -rf "$corpus"
sh tests/fuzz/seed.sh "$build/c205" "$corpus"
refused=3 # exit status of a replay without accepted inputs
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
