#!/bin/sh
# run.sh BUILD [SECONDS] - runs each fuzz target of BUILD for SECONDS seconds (60).
#
# The corpus remains in BUILD for later runs. An input that crashes or hangs a target is
# reported and saved in BUILD/found. A target fails if no seed passes its first check.
set -u
. "$(dirname "$0")/../count.sh"
build=$1 seconds=${2:-60}
here=$(dirname "$0")

rm -rf "$build/seeds"
sh "$here/seed.sh" "$build/c205" "$build/seeds"
for source in "$here"/fuzz_*.c; do
    target=$(basename "$source" .c)
    target=${target#fuzz_}
    mkdir -p "$build/corpus/$target" "$build/found/$target"
    "$build/tests/fuzz/replay_$target" "$build/seeds/$target"/* >"$build/$target.log" 2>&1
    verdict $? "no seed gets past the first check of fuzz_$target; $build/$target.log"
    echo "fuzz_$target, $seconds s"
    if "$build/tests/fuzz/fuzz_$target" -max_total_time="$seconds" \
        -timeout=10 -len_control=0 -rss_limit_mb=4096 -print_final_stats=0 \
        -artifact_prefix="$build/found/$target/" \
        "$build/corpus/$target" "$build/seeds/$target" >"$build/$target.log" 2>&1; then
        pass
        tail -n 1 "$build/$target.log"
    else
        fail "fuzz_$target; $build/$target.log ends:"
        tail -n 12 "$build/$target.log" | sed 's/^/    /'
    fi
done
counted
