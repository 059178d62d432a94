#!/bin/sh
# run.sh - plant each fault of bugs.list in a copy of the tree and see whether
# the part of make check that the list names finds it.
#
#   sh tests/planted/run.sh BUILD MAKE JOBS [TEXT]
#
# With TEXT only the faults whose entry holds it.  The tree is built once, in
# BUILD/planted/whole, and every part must pass there; each fault gets a copy
# with all that is built, so that only what it changes is compiled again.
# What the parts said stays in BUILD/planted/said.  A fault that lets a part run on
# and on is found when that takes several times as long as it did without.
set -u
. "$(dirname "$0")/../count.sh"
list=$(dirname "$0")/bugs.list
place=$1/planted make=$2 jobs=$3 text=${4:-}
whole=$place/whole
limit=infinity # seconds for a part

# A copy compiles what another one has compiled before.
compiler=${CC:-cc}
if command -v ccache >/dev/null; then
    CCACHE_NOHASHDIR=1 CCACHE_BASEDIR=$(pwd)
    export CCACHE_NOHASHDIR CCACHE_BASEDIR
    compiler="ccache ${compiler#ccache }"
fi
unset MAKEFLAGS MFLAGS MAKELEVEL

in_copy() { # FOLDER GOAL ..
    copy=$1
    shift
    timeout "$limit" "$make" -s -C "$copy" BUILD=build OPT=-O1 CFLAGS= JOBS=1 \
        CC="$compiler" "$@"
}

# faults/NUMBER/ for each entry: what, part, file, old, new.
unpack() {
    awk -v folder="$place/faults" -v text="$text" '
        BEGIN {
            RS = ""
            FS = "\n"
            name["# "] = "what"; name["! "] = "part"; name["= "] = "file"
            name["- "] = "old"; name["+ "] = "new"
        }
        $NF !~ /^\+/ || !index($0, text) { next }
        {
            here = folder "/" ++number
            system("mkdir -p " here)
            printf "" > (here "/part")
            for (i = 1; i <= NF; i++)
                print substr($i, 3) > (here "/" name[substr($i, 1, 2)])
            for (mark in name)
                close(here "/" name[mark])
        }' "$list"
}

# The file with the old text replaced; fails unless it stands there once.
plant() { # FAULT FROM TO
    old=$(cat "$1/old") new=$(cat "$1/new") awk '
        {
            at = index($0, ENVIRON["old"])
            if (at) {
                count++
                $0 = substr($0, 1, at - 1) ENVIRON["new"] \
                     substr($0, at + length(ENVIRON["old"]))
            }
            print
        }
        END { exit count != 1 }' "$2" >"$3"
}

# Each of the parts must fail.
find_fault() { # FAULT COPY SAID
    while read -r part; do
        # A goal and its variables.
        # shellcheck disable=SC2086
        limit=$(awk -F '\t' -v part="$part" \
            '$2 == part { print 60 + 3 * $1 }' "$place"/seconds.*) \
            in_copy "$2" $part >>"$3" 2>&1 </dev/null && return 1
    done <"$1/part"
    return 0
}

try() { # FAULT COPY
    file=$(cat "$1/file")
    said=$place/said/$(basename "$1").txt
    rm -rf "$2"
    cp -Rp "$whole" "$2"
    if ! plant "$1" "$whole/$file" "$2/$file"; then
        verdict="stale: other text now"
    elif ! find_fault "$1" "$2" "$said"; then
        verdict="missed by $part"
    elif grep -q '^make.* \[.*build/.*\] Error' "$said"; then
        verdict="stale: not built"
    else
        verdict=found
    fi
    printf '%s: %s (%s)\n' "$verdict" "$(cat "$1/what")" "$file"
}

# Every part of the whole passes, of which this job takes its share.
pass_whole() { # JOB
    awk -v jobs="$jobs" -v job="$1" 'NR % jobs == job % jobs' "$place/parts" |
        while read -r part; do
            begin=$(date +%s)
            # shellcheck disable=SC2086
            in_copy "$whole" $part >"$place/said/whole$1.txt" 2>&1 </dev/null ||
                echo "fails without a fault: $part"
            printf '%d\t%s\n' $(($(date +%s) - begin)) "$part" \
                >>"$place/seconds.$1"
        done
}

# Takes the next fault that nobody has taken, until there is none.
work() { # JOB
    # Their names are numbers.
    for number in $(find "$place/faults" -mindepth 1 -maxdepth 1 -printf "%f\n" | sort -n); do
        fault=$place/faults/$number
        mkdir "$fault/taken" 2>/dev/null && try "$fault" "$place/$1"
    done
}

in_jobs() { # WORK
    for job in $(seq "$jobs"); do
        "$1" "$job" &
    done
    wait
}

sources="vm base asm rt tests scenes docs .ci Makefile README.md"
rm -rf "$place/faults" "$place/said"
mkdir -p "$place/said" "$whole"
unpack
for fault in "$place"/faults/*; do
    [ -s "$fault/part" ] ||
        echo "check-random PROGRAMS=20000 FIRST=1" >"$fault/part"
done

# The sources anew, their times kept, for what is built of them.
for name in $sources; do
    rm -rf "${whole:?}/$name"
    cp -Rp "$name" "$whole"
done
in_copy "$whole" -j "$jobs" all tests build/fit205 || exit 1
sort -u "$place"/faults/*/part >"$place/parts"
rm -f "$place"/seconds.*
in_jobs pass_whole | tee "$place/verdicts"
[ ! -s "$place/verdicts" ] || exit 1
rm -rf "$whole/build/hosts" # more than all the rest, and of one fault alone
in_jobs work | tee "$place/verdicts"
passed=$(grep -c '^found: ' "$place/verdicts")
failed=$(grep -vc '^found: ' "$place/verdicts")
counted
