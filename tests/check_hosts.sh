#!/bin/sh
# check_hosts.sh BUILD MAKE [full] - compares results and clocks of the machine between
# builds: by gcc and clang, with and without optimisation, with this host's vector unit,
# with AVX2 alone, and without a vector unit. full: all combinations, and valgrind.
#
# Each variant builds the machine (vm) in a separate folder. It is linked with the
# assembler and the random programs of the build; with full, the same compiler builds
# these, too. Each variant prints a number for the final states, clocks and accounts of
# the examples, the test programs and some random programs (tests/oracle/digest.c). All
# numbers must be equal.
set -u
. "$(dirname "$0")/count.sh"
build=$1 make=$2 size=${3:-quick}
place=$build/hosts
first=
mkdir -p "$place"

avx2=-DHOST_VECTORS=HOST_AVX2
words=-DHOST_VECTORS=HOST_WORDS
# The AVX2 variant uses plain lanes on a host without AVX2.
grep -qw avx2 /proc/cpuinfo || avx2=-DHOST_VECTORS=HOST_LANES
[ "$size" = full ] && programs=20000 || programs=4000

digest() { # NAME WRAPPER ..: writes out/NAME
    case $1 in
    own) binary=$build/tests/oracle/digest ;;
    *) binary=$place/${1%%,*}/digest ;;
    esac
    name=$1
    shift
    "$@" "$binary" -v -n "$count" asm/examples/*.s tests/programs/*.s \
        >"$place/$name.txt" 2>"$place/$name.err"
}

compare() { # NAME WRAPPER ..: compares with the first variant
    name=$1
    if ! digest "$@"; then
        fail "$name:"
        tail -n 5 "$place/$name.err"
    elif [ -z "$first" ]; then
        first=$name
        echo "$(tail -n 1 "$place/$name.txt"), $name"
    elif diff "$place/$first.txt" "$place/$name.txt" >"$place/$name.diff"; then
        pass
        echo "as $first: $name"
    else
        fail "$name is not as $first; the first programs that differ:"
        head -n 5 "$place/$name.diff"
    fi
}

build_goals() { # NAME MAKE-ARGUMENT ..: runs make for a variant
    name=$1
    shift
    "$make" --no-print-directory "$@" >>"$place/$name.make" 2>&1
}

variant() { # NAME CC OPT [FLAG]: builds a variant and compares its results
    : >"$place/$1.make"
    goal=libc205.a
    [ "$size" = full ] && goal=tests/oracle/digest
    if ! build_goals "$1" BUILD="$place/$1" CC="$2" OPT="$3" CFLAGS="${4:-}" "$place/$1/$goal"; then
        fail "$1 is not built:"
        tail -n 5 "$place/$1.make"
    elif [ "$size" = full ]; then
        cp "$place/$1/$goal" "$place/$1/digest" && compare "$1"
    else
        build_goals "$1" BUILD="$build" "$build/hosts/$1/digest" && compare "$1"
    fi
}

count=$programs
compare own
variant gcc-O0-words gcc -O0 "$words"
variant gcc-O1-avx2 gcc -O1 "$avx2"
variant clang-O2 clang -O2
if [ "$size" = full ]; then
    variant gcc-O3 gcc -O3
    variant gcc-O0 gcc -O0
    variant gcc-O3-words gcc -O3 "$words"
    variant gcc-O3-avx2 gcc -O3 "$avx2"
    variant clang-O0 clang -O0
    variant clang-O3 clang -O3
    variant clang-O3-avx2 clang -O3 "$avx2"
    variant clang-O3-words clang -O3 "$words"
    count=200 first=
    compare gcc-O3,plain
    compare gcc-O3,valgrind valgrind --quiet --error-exitcode=9
    compare gcc-O0,valgrind valgrind --quiet --error-exitcode=9
fi
counted
