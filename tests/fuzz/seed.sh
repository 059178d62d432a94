#!/bin/sh
# seed.sh C205 CORPUS - what the fuzz targets begin with, CORPUS/TARGET/*:
# programs, object files and saved machines made of them, scenes, and inputs
# that once broke something (tests/bugs/TARGET/*).
set -u
c205=$1 corpus=$2
root=$(dirname "$0")/../..

seed() { # TARGET FILE ..: files of one corpus, by names that do not clash
    folder=$corpus/$1
    mkdir -p "$folder"
    shift
    for file in "$@"; do
        [ -f "$file" ] &&
            cp "$file" "$folder/$(printf '%s' "${file#"$root"/}" | tr / _)"
    done
}

seed asm "$root"/tests/programs/*.s "$root"/tests/programs/traps/*.s \
    "$root"/asm/examples/*.s "$root"/tests/bugs/asm/*
seed scene "$root"/scenes/*.pov "$root"/tests/scenes/*.pov \
    "$root"/tests/language/*.pov \
    "$root"/tests/bugs/scene/*
seed object "$root"/tests/bugs/object/*
seed machine "$root"/tests/programs/*.s "$root"/tests/bugs/machine/*
seed save "$root"/tests/bugs/save/*
seed debugger "$root"/tests/bugs/debugger/*
seed dap "$root"/tests/bugs/dap/*
seed engine "$root"/tests/bugs/engine/*

for source in "$root"/tests/programs/*.s "$root"/asm/examples/*.s; do
    "$c205" asm "$source" -o "$corpus/object/$(basename "$source" .s).o"
done
# Page faults take the first thousand clocks and more.
for source in "$root"/asm/examples/*.s; do
    for limit in 100 1100 1250 2500; do
        "$c205" run "$source" --limit $limit --save \
            "$corpus/save/$(basename "$source" .s).$limit" >/dev/null 2>&1
    done
done
exit 0
