#!/bin/sh
# cover.sh PLACE MAKE JOBS PART .. - measures which lines each part of make check
# executes. JOBS parts run concurrently.
#
# A part is GOAL or GOAL:VARIABLE=VALUE. PLACE/whole has the sources. They are built
# with the counters of gcov in PLACE/whole/cover. For each part, PLACE/covered contains
#
#   PART.lines    FILE:LINE of each executed line, FILE of each file with such a line
#                 and of each text that is assembled
#   PART.seconds  the processor time of the part
#
# and `code`, all lines that have code. A part that was measured is not run again. A
# part that fails is reported and has no lines.
set -u
make=$2 jobs=$3
covered=$1/covered
cd "$1/whole" || exit 1
shift 3
mkdir -p "$covered"
job=0 # number of this process
unset MAKEFLAGS MFLAGS MAKELEVEL

# Programs without the assembler have no source_find.
in_cover() { # GOAL ..
    timeout 3600 "$make" -s BUILD=cover OPT=-O1 CFLAGS=--coverage CXXFLAGS=--coverage JOBS=1 \
        LDFLAGS="--coverage -Wl,--wrap=source_find,--unresolved-symbols=ignore-all -no-pie \
            $covered/texts_read.o" "$@" </dev/null
}

# Appends the lines with code to $covered/code.JOB.
executed() {
    find "$GCOV_PREFIX" -name '*.gcda' -exec gcov -t {} + 2>/dev/null |
        awk -v all="$covered/code.$job" '
        / 0:Source:/ {
            file = $0
            sub(/.*:Source:/, "", file)
            ours = file !~ /^(\/|tests\/|cover\/)/
        }
        ours && $0 !~ /^ *-:/ {
            split($0, part, ":")
            line = file ":" part[2] + 0
            print line >>all
            if (part[1] ~ /[0-9]/)
                print line "\n" file
        }'
}

texts() {
    sort -u "$TEXTS_READ" | while read -r name; do
        for folder in rt/kernels asm/lib; do
            [ ! -f "$folder/$name" ] || echo "$folder/$name"
        done
    done
}

measure() { # PART: writes the lines that a part executes
    here=$covered/$(echo "$1" | tr / +)
    [ ! -e "$here.lines" ] && mkdir "$here.claim" 2>/dev/null || return
    find "$GCOV_PREFIX" -name '*.gcda' -delete
    : >"$TEXTS_READ"
    # The words are a goal and its variable. The last line of "times" counts ended
    # processes.
    # shellcheck disable=SC2046
    if ! (in_cover $(echo "$1" | tr : ' ') && times >"$here.times") >"$here.log" 2>&1; then
        echo "fails without a fault: $1"
        return
    fi
    tr 'ms' '  ' <"$here.times" | awk 'END { print 60 * ($1 + $3) + $2 + $4 }' >"$here.seconds"
    { executed && texts; } | sort -u >"$here.new"
    sort -u -o "$covered/code.$job" "$covered/code.$job"
    mv "$here.new" "$here.lines"
}

# The counters of each job are in a separate folder, with the notes that gcov needs.
work() { # JOB PART ..: measures all parts that no other job measures
    job=$1 GCOV_PREFIX=$covered/counters.$1 TEXTS_READ=$covered/texts.$1
    GCOV_PREFIX_STRIP=$(pwd | tr -cd / | wc -c)
    export GCOV_PREFIX GCOV_PREFIX_STRIP TEXTS_READ
    shift
    mkdir -p "$GCOV_PREFIX"
    find cover -name '*.gcno' -exec cp -p --parents {} "$GCOV_PREFIX" \;
    for part; do
        measure "$part"
    done
}

${CC:-cc} -std=c99 -I. -c -o "$covered/texts_read.o" tests/mutants/texts_read.c || exit 1
# Files without counters are not built again.
for folder in unit oracle fuzz; do
    mkdir -p "cover/tests/$folder"
    cp -p "build/tests/$folder"/*.o "cover/tests/$folder"
done
in_cover -j "$jobs" mutants-whole || exit 1
rm -rf "$covered"/*.claim
for job in $(seq "$jobs"); do
    work "$job" "$@" &
done
wait
sort -u -o "$covered/code" "$covered"/code.*
[ -d "$covered/sources" ] || { mkdir "$covered/sources" && cp -Rp vm base asm rt web "$covered/sources"; }
