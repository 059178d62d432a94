#!/bin/sh
# run_programs.sh C205 - runs the test programs and examples and compares registers and
# memory with their expectations. Each instruction of the table must be named by a
# program that executes it. It must cause the warnings that the program expects.
set -eu
c205=$1
cd "$(dirname "$0")/.."
code=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for file in tests/programs/*.*; do
    sed '/^; expect-warning/d' "$file" >"$work/${file##*/}"
done
mkdir "$work/alone"
cp "$work"/*.inc "$work/alone"

# The instructions that the programs name, and those of them that they execute.
for path in tests/programs/*.s; do
    "$c205" run --trace -Wno-all "$path" 2>&1 | awk '
        FNR == NR && /^; tests: / { for (i = 3; i <= NF; i++) named[$i] }
        FNR != NR { sub(/,H$/, "", $4); if ($4 in named) print $4 }
    ' "$path" -
done | sort -u >"$work/executed"
for name in $("$c205" isa --names); do
    if ! grep -qx "$name" "$work/executed"; then
        printf 'no program tests %s\n' "$name"
        code=1
    fi
done

# A warning is reported once for a line of a macro. Each instruction is therefore also
# run alone, in a copy without the lines that name other instructions. Some of these
# lines write registers, so reads of unwritten registers are not reported.
awk -v folder="$work/alone" '
    function names_other(text, only, words, n, i) {
        if (text !~ /^;/)
            sub(/;.*/, "", text)
        n = split(text, words, /[^A-Z0-9]+/)
        for (i = 1; i <= n; i++)
            if (words[i] in tested && words[i] != only && words[i] "H" != only)
                return 1
        return 0
    }
    function write(name, i, file) {
        for (name in tested) {
            file = folder "/" name ".s"
            for (i = 1; i <= lines; i++)
                if (!names_other(line[i], name))
                    print line[i] >file
            close(file)
        }
    }
    FNR == 1 {
        if (warns)
            write()
        lines = warns = 0
        split("", tested)
    }
    { line[++lines] = $0 }
    /^; tests: / { for (i = 3; i <= NF; i++) tested[$i] }
    /^; warns: / { warns = 1 }
    END { if (warns) write() }' "$work"/*.s
awk '/^; warns: / { for (i = 4; i <= NF; i++) print $3, $i }' tests/programs/*.s |
    sort -u >"$work/said"
"$c205" run --check -Wno-unwritten-register "$work"/*.s "$work"/alone/*.s 2>&1 | awk '
    /warning: .*\[-W/ {
        match($0, /\[-W[a-z-]*/)
        name = substr($0, RSTART + 3, RLENGTH - 3)
        getline
        print name, $1
    }' | sort -u >"$work/reported"
diff "$work/said" "$work/reported" || code=1

"$c205" run --check -Werror tests/programs/*.s tests/programs/traps/*.s \
    asm/examples/*.s || code=1
awk -f tests/forms.awk asm/lib/forms.s >"$work/operations.s" || code=1
"$c205" run --check -Werror "$work/operations.s" || code=1
"$c205" run --check -Werror -I rt/kernels rt/study/fit/programs/*.s || code=1
exit $code
