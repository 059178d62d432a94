#!/bin/sh
# bench_hosts.sh BUILD - measures the host nanoseconds per element of spans of words
# (tests/bench_lanes.c) for each compiler. It also measures less capable hosts, with
# AVX2 alone or without a vector unit. The last rows are the largest ratios between two
# builds, over all operations on words of several kinds.
set -eu
build=$1
. "$(dirname "$0")/measure.sh"

: >"$work/names"
# The smallest size compares this build with one of check-hosts, to save compiling.
folder_of() { # NAME
    case $1 in
    gcc-best) sized "$build/bench/$1" "$build" ;;
    *) sized "$build/bench/$1" "$build/hosts/gcc-O1-avx2" ;;
    esac
}

for compiler in gcc $(sized clang ""); do
    for vectors in best AVX2 $(sized WORDS ""); do
        name=$compiler-$vectors
        folder=$(folder_of "$name")
        flags=
        [ "$vectors" = best ] || flags=-DHOST_VECTORS=HOST_$vectors
        "${MAKE:-make}" --no-print-directory -s "BUILD=$folder" "CC=$compiler" \
            "OPT=$(sized -O3 -O1)" "CFLAGS=-g $flags" "$folder/tests/bench_lanes"
        echo "$name" >>"$work/names"
    done
done

for _ in $(seq "$trials"); do
    while read -r name; do
        run "$(folder_of "$name")/tests/bench_lanes" "$trials" | cells "$name"
    done <"$work/names"
done | sed -n 's/^\(.*\),"\(.*\)",lanes,/\1\t\2\t/p' >"$work/times"

awk -F '\t' -v results="$results" '
    FILENAME == ARGV[1] { names[++count] = $1; next }
    !($2 in seen) { seen[$2] = 1; rows[++row_count] = $2 }
    !(($1, $2) in least) || $3 < least[$1, $2] { least[$1, $2] = $3 }
    function compare(name, other,    most, i, times) {
        if (!((name, rows[1]) in least) || !((other, rows[1]) in least))
            return
        most = 0
        for (i = 1; i <= row_count; i++) {
            if (rows[i] ~ /zeros/)
                continue
            times = least[name, rows[i]] / least[other, rows[i]]
            if (times > most)
                most = times
        }
        printf "%-24s %11.2f times %s\n", name, most, other
        printf "hosts,\"%s to %s\",times,%.2f\n", name, other, most >>results
    }
    END {
        printf "%-24s", "ns an element"
        for (n = 1; n <= count; n++)
            printf " %11s", names[n]
        for (i = 1; i <= row_count; i++) {
            printf "\n%-24s", rows[i]
            for (n = 1; n <= count; n++) {
                figure = least[names[n], rows[i]]
                printf " %11s", figure
                printf "hosts,\"%s, %s\",ns,%s\n", rows[i], names[n],
                    figure >>results
            }
        }
        printf "\n\n"
        compare("gcc-AVX2", "gcc-best")
        compare("gcc-WORDS", "gcc-best")
        compare("clang-best", "gcc-best")
        compare("clang-AVX2", "clang-best")
        compare("clang-WORDS", "clang-best")
    }' "$work/names" "$work/times"
