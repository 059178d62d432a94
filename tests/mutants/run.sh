#!/bin/sh
# run.sh - makes faults in a copy of the tree, one at a time, and reports which of them
# the parts of make check find.
#
#   sh tests/mutants/run.sh BUILD MAKE JOBS N SEED ONLY SECONDS PART ..
#
# N random faults are tried, the same number in each room. ONLY restricts them to a
# room, or to files whose path contains ONLY. With N = planted, the faults of
# tests/planted/bugs.list are tried by the parts that they name. All files are in
# BUILD/mutants:
#
#   whole     the sources, and their build without a fault
#   covered   the lines that each part executes (cover.sh), measured once
#   tree.JOB  a copy of whole in which a fault is made, built and removed again
#   results   a line for each fault that was tried; after an interruption, or with a
#             larger N, it is not tried again
#
# A fault that does not build, or changes no object file, is discarded. For every other
# fault, the parts that execute its line run until a part fails or hangs, the fastest
# first. If SECONDS is not 0, a fault survives after six parts and this processor time.
# A later run with more SECONDS tries such a fault again.
set -u
build=$1 make=$2 jobs=$3 total=$4 seed=$5 only=$6 seconds=$7
shift 7
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$build/mutants/diffs"
place=$(cd "$build/mutants" && pwd)
mutate="awk -f $here/masked.awk -f $here/mutate.awk"
plant="awk -f $here/masked.awk -f $here/../planted/plant.awk"
list=$here/../planted/bugs.list
whole=$place/whole results=$place/results covered=$place/covered
compiler=${CC:-cc}
if command -v ccache >/dev/null; then
    export CCACHE_NOHASHDIR=1
    compiler="ccache ${compiler#ccache }"
fi
unset MAKEFLAGS MFLAGS MAKELEVEL
job=0 # number of this process; 0 makes no faults
export LSAN_OPTIONS=hard_rss_limit_mb=8000 # ends a process above 8 GB
touch "$results"

# Runs a goal. It is stopped after SECONDS of processor time, or after 20 times as many
# seconds on the wall clock.
in_tree() { # TREE SECONDS GOAL ..
    within=$1 limit=$2
    shift 2
    # shellcheck disable=SC3045
    (ulimit -t "$limit" &&
        exec sh -c 'echo $$ >"$0" && exec timeout -k 5 "$@"' "$place/pid.$job" \
            $((20 * limit)) "$make" -s -C "$within" BUILD=build OPT=-O1 CFLAGS= CXXFLAGS= \
            JOBS=1 FIRST=1 CC="$compiler" "$@" </dev/null)
    set -- $?
    rm -f "$place/pid.$job"
    return "$1"
}

# Prints the files of a room that may have faults.
room_files() { # ROOM
    case $1 in
    asm) find asm -name '*.[ch]' -o -name '*.def' -o -path 'asm/lib/*.s' ;;
    kernels) find rt/kernels -name '*.s' ;;
    fit) find rt/study/fit rt/command/fit205.c -name '*.[ch]' -o -name '*.cc' ;;
    rt) find rt \( -path rt/study/fit -o -name fit205.c \) -prune -o \
        \( -name '*.[ch]' -o -name '*.def' \) -print ;;
    web) find web/engine -name '*.[ch]' ! -name wasm.c ;;
    *) find "$1" -name '*.[ch]' -o -name '*.def' ;;
    esac | LC_ALL=C sort | grep -F -e "$only"
}

# ---- One fault ------------------------------------------------------------

make_fault() { # FILE NUMBER: prints the file with a fault
    if [ "$total" = planted ]; then
        $plant -v number="$2" "$list"
    else
        $mutate -v number="$2" "$1"
    fi
}

# Prints the goals that build the objects of a file.
objects_of() { # FILE
    case $1 in
    asm/lib/*) echo build/asm/library_texts.o ;;
    rt/kernels/*) echo build/rt/kernel_texts.o ;;
    vm/*.c | base/*.c | asm/*.c | rt/*.c | web/engine/*.c) echo "build/${1%.c}.o" ;;
    *.cc) echo "build/${1%.cc}.o" ;;
    rt/study/fit/*) echo build/fit205 ;;
    vm/* | base/* | asm/* | rt/* | web/engine/*) echo build/c205 build/rt205 build/libengine.a ;;
    esac
}

remove_fault() { # TREE FILE: restores the file and the objects built from it
    { (cd "$1" && find build -type f -newer stamp) && echo "$2"; } | while read -r file; do
        cp -p "$whole/$file" "$1/$file" 2>/dev/null || rm -f "$1/$file"
    done
}

is_changed() { # TREE: succeeds if the fault has changed an object
    (cd "$1" && find build -name '*.o' -newer stamp) | while read -r object; do
        cmp -s "$1/$object" "$whole/$object" || echo "$object"
    done | grep -q .
}

# Prints "SECONDS PART" for each part that executes the line, or the line at which its
# statement begins. A line outside of functions has all parts that execute a line of its
# file. For a header or table, these are the parts that execute a line of a file that
# includes it.
covering() { # FILE LINE
    at=$1
    if cmp -s "$1" "$covered/sources/$1"; then
        at=$(awk -v file="$1" -v line="$2" '
            NR == FNR && index($0, file ":") == 1 { code[substr($0, length(file) + 2)] }
            NR == FNR { next }
            FNR in code { last = ":" FNR }
            /^}/ && FNR < line { last = "" }
            FNR == line { print file last; exit }' "$covered/code" "$1")
    fi
    echo "$at" >"$place/at.$job"
    if [ "$at" = "$1" ] && ! grep -qxF "$1" "$covered"/*.lines; then
        (cd "$whole/build" && grep -lrF --include='*.d' " $1" vm base asm rt web) |
            sed 's/d$/c/' >"$place/at.$job"
    fi
    grep -lxFf "$place/at.$job" "$covered"/*.lines | while read -r lines; do
        echo "$(cat "${lines%.lines}.seconds") $(basename "$lines" .lines | tr + /)"
    done
}

# Prints the parts to run. The part that assembles all programs of the kernels is first.
parts_of() { # FILE LINE NUMBER
    if [ "$total" = planted ]; then
        $plant -v number="$3" -v parts=1 "$list" | sed 's/^/30 /'
    else
        covering "$1" "$2" | sort -n
    fi | awk -v kernel="$1" '
        kernel ~ /^rt\/kernels/ && /UNITS=test_kernel_registers$/ { print; next }
        { rest = rest $0 "\n" }
        END { printf "%s", rest }'
}

# Returns true if the last part failed because this file or a program was not built.
is_rejected() { # FILE
    grep -qE '^make.*\[.*build/.*\.(o|a)\] Error' "$log" && return
    case $1 in
    *.s) grep -qE "${1#*/*/}:[0-9]+(:[0-9]+)?: " "$log" ;;
    *) false ;;
    esac
}

# Sets the verdict, the part, and the number of failed cases. A part that crashes or
# hangs has no such number.
find_fault() { # TREE FILE LINE NUMBER
    log=$place/log.$job
    part=- cases=0
    # The words are goals.
    # shellcheck disable=SC2046
    if ! in_tree "$1" 900 $(objects_of "$2") >"$log" 2>&1; then
        verdict="not built"
        return
    fi
    is_changed "$1" || { verdict="same code" && [ -n "$(objects_of "$2")" ] && return; }
    verdict=survived
    parts_of "$2" "$3" "$4" |
        awk '{ sum += NR > 6 ? $1 : 0; print 20 + 5 * int($1 + 1), int(sum), $2 }' >"$place/order.$job"
    [ -s "$place/order.$job" ] || part="no part executes it"
    while read -r limit sum name; do
        if [ "$seconds" -gt 0 ] && [ "$sum" -gt "$seconds" ]; then
            part="parts of $seconds s"
            return
        fi
        # shellcheck disable=SC2046
        in_tree "$1" "$limit" $(echo "$name" | tr : ' ') >"$log" 2>&1 && continue
        part=$name verdict=found
        cases=$(awk '/ passed, [0-9]+ failed$/ { n += $3 }
            /^\[  FAILED  \] [0-9]+ test/ { n += $4 }
            END { print n ? n : "no count" }' "$log")
        ! is_rejected "$2" || verdict="not built"
        return
    done <"$place/order.$job"
}

try() { # ROOM KEY FILE NUMBER LINE KIND: tries one fault
    tree=$place/tree.$job
    begin=$(date +%s)
    touch "$tree/stamp"
    make_fault "$3" "$4" >"$tree/$3"
    diff -u -L "$3" -L "$3" "$whole/$3" "$tree/$3" >"$place/diffs/$2"
    find_fault "$tree" "$3" "$5" "$4"
    remove_fault "$tree" "$3"
    printf '%s\t' "$2" "$1" "$verdict" "$3:$5" "$6" "$part" "$cases" >"$place/line.$job"
    echo $(($(date +%s) - begin)) >>"$place/line.$job"
    cat "$place/line.$job" >>"$results"
}

# ---- All faults -----------------------------------------------------------

# Returns true if a fault needs no other trial.
is_decided() { # KEY
    awk -F '\t' -v key="$1" -v seconds="$seconds" '
        $1 == key {
            split($6, tried, " ")
            done = $6 !~ /^parts of [0-9]+ s$/ || seconds > 0 && tried[3] >= seconds
        }
        END { exit !done }' "$results"
}

# Tries this job's share of a room's faults.
try_room() { # ROOM COUNT
    awk -v jobs="$jobs" -v job="$job" 'NR % jobs == job % jobs' "$place/faults.$1" |
        while read -r file number line kind && [ "$2" -gt 0 ]; do
            key=$(make_fault "$file" "$number" | cksum | tr ' ' -)
            is_decided "$key" || try "$1" "$key" "$file" "$number" "$line" "$kind"
            echo "$key" >>"$place/drawn.$job"
            grep -q "^$key	$1	[fs][ou]" "$results" || continue
            set -- "$1" $(($2 - 1))
        done
}

work() { # JOB: tries the share of a job
    job=$1
    rm -rf "$place/tree.$job"
    mkdir "$place/tree.$job"
    find "$whole" -mindepth 1 -maxdepth 1 ! -name cover -exec cp -Rp {} "$place/tree.$job" \;
    for room in $chosen; do
        try_room "$room" $(((share + jobs - job) / jobs))
    done
}

report() {
    sort -u "$place"/drawn.* | awk -F '\t' -v rooms="$chosen" -v diffs="$place/diffs/" '
        function fault(text, part) {
            split(text, part)
            count[part[2]]++; sum[part[3]]++; number[part[2], part[3]]++
            if (part[3] == "found") {
                printf "found: %s: %s, by %s, %s failed, %d s\n", part[4], part[5],
                    part[6], part[7], part[8]
                single += part[7] == 1
            } else if (part[3] == "survived") {
                printf "survived: %s: %s, %s, %d s\n", part[4], part[5], part[6], part[8]
                while ((getline text <(diffs part[1])) > 0)
                    print "    " text
            }
        }
        function row(name, n, f, s) {
            printf "| %s | %d | %d | %d | %d | %s |\n", name, n, n - f - s, f, s,
                f + s ? sprintf("%.0f %%", 100 * f / (f + s)) : "-"
        }
        FNR == NR { drawn[$1]; next }
        !($1 in drawn) { next }
        !($1 in last) { order[++all] = $1 }
        { last[$1] = $0 } # the last trial counts
        END {
            for (i = 1; i <= all; i++)
                fault(last[order[i]])
            print "\n| room | drawn | discarded | found | survived | found |"
            print "|---|--:|--:|--:|--:|--:|"
            n = split(rooms, room, " ")
            for (i = 1; i <= n; i++)
                row(room[i], count[room[i]], number[room[i], "found"],
                    number[room[i], "survived"])
            row("all", all, sum["found"], sum["survived"])
            printf "\n%d of those found failed one case alone.\n", single
        }' - "$results"
}

# Copies the sources with their times. Built files remain.
refresh() {
    mkdir -p "$whole"
    for name in vm base asm rt web tests scenes docs .ci Makefile README.md LICENSE; do
        rm -rf "${whole:?}/$name"
        cp -Rp "$name" "$whole"
    done
    rm -rf "$whole/web/node_modules"
    in_tree "$whole" 3600 -j "$jobs" mutants-whole || exit 1
}

refresh
cd "$whole" || exit 1
if [ "$total" = planted ]; then
    chosen=planted
    $plant "$list" | grep -F -e "$only" >"$place/faults.planted"
    share=$(wc -l <"$place/faults.planted")
else
    sh "$here/cover.sh" "$place" "$make" "$jobs" "$@"
    chosen='' rooms="vm base asm rt kernels web fit"
    case " $rooms " in *" $only "*) rooms=$only only='' ;; esac
    for room in $rooms; do
        room_files "$room" >"$place/files" || continue
        chosen="$chosen $room"
        # shellcheck disable=SC2086
        xargs $mutate -v seed="$seed" -v count=$((3 * total)) \
            <"$place/files" >"$place/faults.$room"
    done
    share=$(echo "$total $chosen" | awk '{ print int(($1 + NF - 2) / (NF - 1)) }')
fi
rm -f "$place"/drawn.*
workers=''
trap 'kill $workers $(cat "$place"/pid.*) 2>/dev/null; exit 130' INT TERM
for job in $(seq "$jobs"); do
    work "$job" &
    workers="$workers $!"
done
wait
report
