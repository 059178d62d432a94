#!/bin/sh
# seed.sh C205 CORPUS - writes the seeds of the fuzz targets, CORPUS/TARGET/*: programs,
# object files and saved machines made from them, scenes, and inputs that caused earlier
# failures (tests/bugs/TARGET/*), with sessions divided into pieces.
set -u
c205=$1 corpus=$2
root=$(dirname "$0")/../..

seed() { # TARGET FILE ..: copies files to a corpus, by unique names
    folder=$corpus/$1
    mkdir -p "$folder"
    shift
    for file in "$@"; do
        [ -f "$file" ] &&
            cp "$file" "$folder/$(printf '%s' "${file#"$root"/}" | tr / _)"
    done
}

pieces() { # TARGET HEAD LINES: divides the session of a target into short sessions
    # Each short session has the first HEAD lines and up to LINES others, to reach its
    # end.
    mkdir -p "$corpus/$1"
    awk -v head="$2" -v lines="$3" -v name="$corpus/$1/session." '
        NR <= head { first = first $0 "\n"; next }
        (NR - head - 1) % lines == 0 { close(file); file = name NR; printf "%s", first >file }
        { print >file }' "$root/tests/bugs/$1/session"
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
pieces debugger 0 6
pieces dap 9 5
pieces engine 1 3

for source in "$root"/tests/programs/*.s "$root"/asm/examples/*.s; do
    "$c205" asm "$source" -o "$corpus/object/$(basename "$source" .s).o"
done
# The limits stop each program before, in and after its page faults, which take more
# than the first thousand clocks.
for source in "$root"/asm/examples/*.s; do
    for limit in 100 1100 1250 2500; do
        "$c205" run "$source" --limit $limit --save \
            "$corpus/save/$(basename "$source" .s).$limit" >/dev/null 2>&1
    done
done
exit 0
