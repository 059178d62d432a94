#!/bin/sh
# check_replay.sh BUILD [--write] - compares the output of debugger scripts, byte for
# byte, between a file, a pipe and a second run.
#
# The output of tests/debugger/forty.lines, 40 commands, over five programs is also
# compared with the recorded files next to it. --write records them again. The other
# scripts are drawn by test_debugger_scripts, with 40 lines each.
set -u
. "$(dirname "$0")/count.sh"
build=$1 write=${2:-}
here=tests/debugger
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
said=$work/said

# The models have round constants, which do not change.
debug() { # PROGRAM [OPTION ..]
    program=$1
    shift
    "$build/c205" debug --model cyber205-2pipe-prior "$@" \
        "asm/examples/$program.s" 2>&1
    echo "ends with $?"
}

same() { # FILE FILE TEXT: the files must be equal
    diff "$1" "$2" >"$said"
    verdict $? "$3"
}

replay() { # PROGRAM SCRIPT: writes its output to $work/file
    debug "$1" -x "$2" >"$work/file"
    debug "$1" -x "$2" >"$work/again"
    debug "$1" <"$2" >"$work/pipe"
    same "$work/file" "$work/again" "$2 says something else again, over $1"
    same "$work/file" "$work/pipe" "$2 says something else from a pipe, over $1"
}

number=0
for program in dot horner lookup saxpy_scalar sieve; do
    replay "$program" $here/forty.lines
    [ "$write" ] && cp "$work/file" "$here/forty.$program"
    same "$here/forty.$program" "$work/file" "$here/forty.$program"
    while [ $((number += 1)) -le 8 ]; do
        "$build/tests/unit/test_debugger_scripts" draw "$number" \
            "asm/examples/$program.s" >"$work/drawn"
        replay "$program" "$work/drawn"
    done
    number=0
done
counted
