#!/bin/sh
# check.sh - checks mutate.awk. Random faults in some files of every room must change
# these files. The same seed must draw the same faults. Short texts must have all kinds.
set -u
. "$(dirname "$0")/../count.sh"
mutate="awk -f $(dirname "$0")/masked.awk -f $(dirname "$0")/mutate.awk"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

kinds() { # FILE KIND ..: the kinds of faults of the file, in alphabetical order
    file=$1
    shift
    number=1
    while $mutate -v number="$number" "$file" >"$work/fault" 2>/dev/null; do
        diff "$file" "$work/fault" | sed -n 's/^> *//p'
        number=$((number + 1))
    done | LC_ALL=C sort >"$work/found"
    printf '%s\n' "$@" | LC_ALL=C sort | diff "$work/found" -
    verdict $? "faults of $file"
}

cat >"$work/text.c" <<'END'
#define A(x) ((x) + 1)
/* a < b */
    if (a < b && !c) f("a < b", 7);
    *a = b;
    int n[3] = { 0 };
END
kinds "$work/text.c" 'if (!(a < b && !c)) f("a < b", 7);' \
    'if (a <= b && !c) f("a < b", 7);' 'if (a < b || !c) f("a < b", 7);' \
    'if (a < b && !c) f("a < b", (7 + 1));' 'if (a < b && !c) f("a < b", (7 - 1));' ';'
cat >"$work/text.s" <<'END'
; r1, 2
        RTOR    a, b
next:   CMPLTV  [c], [d], [e] ? [z]     ; 1
        .equ    n, 4
END
kinds "$work/text.s" '' 'RTOR    b, a' 'next:        ; 1' \
    'next:   CMPGEV  [c], [d], [e] ? [z]     ; 1' \
    'next:   CMPLTV  [d], [c], [e] ? [z]     ; 1' \
    'next:   CMPLTV  [c], [e], [d] ? [z]     ; 1' \
    'next:   CMPLTV  [c], [d], [e] ?! [z]     ; 1' \
    'next:   CMPLTV  [c], [d], [e]      ; 1' '.equ    n, 5' '.equ    n, 3'
printf '\nROW(A, "b")\nROW(C, "d")\n' >"$work/text.def"
kinds "$work/text.def" 'ROW("b", A)' 'ROW("d", C)' 'ROW(A, "b")' 'ROW(C, "b")' \
    'ROW(A, "d")' 'ROW(A, "d")' 'ROW(C, "b")'

for room in vm base asm asm/lib rt rt/kernels rt/study/fit web/engine; do
    # The names contain no blanks.
    # shellcheck disable=SC2046
    set -- $(find "$room" -name '*.[ch]' -o -name '*.def' -o -name '*.s' |
        awk 'NR % 8 == 1')
    $mutate -v seed=7 -v count=5 "$@" >"$work/drawn"
    $mutate -v seed=7 -v count=5 "$@" | cmp -s - "$work/drawn" && [ "$(wc -l <"$work/drawn")" -eq 5 ]
    verdict $? "the draw of $room"
    while read -r file number line kind; do
        $mutate -v number="$number" "$file" | diff "$file" - >"$work/changes"
        grep -q "^$line\|^[0-9,]*[acd]$line" "$work/changes"
        verdict $? "the change in $file:$line: $kind"
    done <"$work/drawn"
done
counted
