#!/bin/sh
# bench_goals.sh BUILD - compares the figures of the other parts with target values.
set -eu
build=$1
. "$(dirname "$0")/measure.sh"

printf '%-44s %9s %9s\n' goal "to reach" measured
awk '
    function judge(name, limit, least) {
        value = $0
        sub(/.*,/, "", value)
        good = least ? value + 0 >= limit + 0 : value + 0 <= limit + 0
        printf "%-44s %3s %5s %9s%s\n", name, least ? ">=" : "<=", limit,
            value, good ? "" : "  not reached"
        rows[++count] = "goals,\"" name "\",measured," value
    }
    { split($0, quoted, "\"") }
    /^frames,.*,ratio,/ {
        judge(quoted[2] ", times POV-Ray\x27s",
              /bench.pov|first.pov/ ? "1.0" : "1.5")
    }
    /^growth,"flake, 7381",ratio,/ { judge(quoted[2] ", times POV-Ray\x27s", 2) }
    /^growth,"flake, exponent",clocks,/ { judge("flake, exponent of clocks", .5) }
    /^growth,"mesh, 100352",ratio,/ { judge(quoted[2] ", times POV-Ray\x27s", 2) }
    /^machine,"add, 64.*,ns\/element,/ { judge("add, ns an element", .7) }
    /^machine,"multiply, .*,ns\/element,/ { judge("multiply, ns an element", .75) }
    /^hosts,.*AVX2 to/ { judge(quoted[2] ", times, at most", 2.5) }
    /^hosts,.*WORDS to/ { judge(quoted[2] ", times, at most", 5) }
    /^hosts,"clang-best to/ { judge(quoted[2] ", times, at most", 1.1) }
    /^short,.*,n = 8,/ { judge(quoted[2] ", n = 8, ns", 40) }
    /^machine,"scalar, .*,M instr\/s,/ {
        judge("scalar, M instructions a second", 150, 1)
    }
    /^jobs,.*,times,/ { judge(quoted[2] ", two jobs to one", 1.85, 1) }
    /^ranks,.*,times,/ { judge(quoted[2] ", two ranks to one", 1.85, 1) }
    END {
        for (i = 1; i <= count; i++)
            print rows[i] >>FILENAME
    }
' "$results"
