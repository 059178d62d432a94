#!/bin/sh
# check_bench.sh BUILD [PART ..] - runs each part of the benchmarks in its smallest
# size. A part must fail if one of its commands fails or prints nothing.
set -u
. "$(dirname "$0")/count.sh"
build=$(cd "$1" && pwd)
shift
cd "$(dirname "$0")/.." || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
said=$work/report
SIZE=small BENCH_CSV=$work/bench.csv
export SIZE BENCH_CSV

sh tests/bench.sh "$build" "$@" >"$said" 2>&1
verdict $? "the benchmark fails: $*"
said=

# A build whose commands call the commands of BUILD. One of them is broken.
mkdir -p "$work/broken/tests" "$work/broken/hosts/gcc-O1-avx2/tests"
for library in "$build"/*.so; do
    ln -s "$library" "$work/broken"
done
for command in rt205 tests/bench_lanes tests/bench_ray_query tests/bench_machine \
    tests/bench_ranks tests/bench_vector_length tests/bench_trace \
    hosts/gcc-O1-avx2/tests/bench_lanes povray; do
    path=$build/$command
    [ "$command" != povray ] || path=$(command -v povray)
    cat >"$work/broken/$command" <<END
#!/bin/sh
case \$BROKEN in
"$command silent") exit 0 ;;
"$command failing") "$path" "\$@" && exit 1 ;;
*) exec "$path" "\$@" ;;
esac
END
    chmod +x "$work/broken/$command"
done

broken() { # PART COMMAND: the part must fail with a broken command
    rows=
    [ "$2" != rt205 ] || rows=lines
    for how in silent failing; do
        env PATH="$work/broken:$PATH" BROKEN="$2 $how" MAKE=true "RANKS=$rows" \
            sh tests/bench.sh "$work/broken" "$1" >/dev/null 2>&1
        [ $? -eq 1 ]
        verdict $? "$1 does not fail with $2 $how"
    done
}

while read -r part command; do
    [ $# -eq 0 ] || case " $* " in *" $part "*) ;; *) continue ;; esac
    broken "$part" "$command" </dev/null
done <<'END'
machine tests/bench_machine
machine tests/bench_lanes
machine tests/bench_vector_length
hosts tests/bench_lanes
hosts hosts/gcc-O1-avx2/tests/bench_lanes
frames tests/bench_trace
frames povray
jobs tests/bench_trace
ranks rt205
ranks tests/bench_ranks
stages rt205
visible rt205
ray_query tests/bench_ray_query
growth tests/bench_trace
growth povray
END
counted
