#!/bin/sh
# run_bugs.sh BUILD - the inputs that fuzzing begins with, those that once
# broke something among them (tests/bugs/TARGET/*), each through its fuzz
# target (tests/fuzz/) once more.
set -u
. "$(dirname "$0")/count.sh"
build=$1
corpus=$build/seeds
said=$build/replay.err
rm -rf "$corpus"
sh tests/fuzz/seed.sh "$build/c205" "$corpus"
for folder in "$corpus"/*; do
    replay=$build/tests/fuzz/replay_$(basename "$folder")
    for file in "$folder"/*; do
        "$replay" "$file" >"$said" 2>&1
        verdict $? "$replay $file"
    done
done
counted
