#!/bin/sh
# cover.sh BUILD - reports how the tests cover vm/, base/ and asm/, from the profiles in
# BUILD/profile. It prints a table of files and the totals, which must reach 95 % of the
# lines and 85 % of the branches (each condition both ways). BUILD/uncovered.txt lists
# the lines that were not executed.
set -eu
build=$1
lines_least=95 branches_least=85

llvm-profdata merge -o "$build/profile.data" "$build"/profile/*.profraw
llvm-cov report "$build/c205" -instr-profile "$build/profile.data" vm base asm \
    >"$build/report.txt"
llvm-cov show "$build/c205" -instr-profile "$build/profile.data" vm base asm |
    awk '/^[^ ].*:$/ { file = $0 } /^ *[0-9]+\| +0\|/ { print file $0 }' |
    sed "s|^$PWD/||" >"$build/uncovered.txt"

# Columns 8 and 9 are lines and missed lines; columns 11 and 12 are branches.
awk -v lines_least=$lines_least -v branches_least=$branches_least '
    function share(all, missed) {
        return all ? sprintf("%6.2f %%", 100 * (all - missed) / all) : "       -"
    }
    function row(name) {
        return sprintf("%-26s %6d %s %8d %s", name, $8, share($8, $9),
                       $11, share($11, $12))
    }
    BEGIN { printf "%-26s %15s %17s\n", "", "lines", "branches" }
    NF == 13 && $8 > 0 && $1 ~ /\.[ch]$/ {
        sub(/.*\/vm\//, "vm/", $1)
        sub(/.*\/asm\//, "asm/", $1)
        print row($1) | "sort"
    }
    $1 == "TOTAL" {
        close("sort")
        print row("total")
        found = 1
        if (100 * ($8 - $9) < lines_least * $8) {
            printf "less than %d %% of the lines\n", lines_least
            failed = 1
        }
        if (100 * ($11 - $12) < branches_least * $11) {
            printf "less than %d %% of the branches\n", branches_least
            failed = 1
        }
    }
    END { exit failed || !found }' "$build/report.txt"
