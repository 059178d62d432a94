#!/bin/sh
# check_quick.sh BUILD MAKE SECONDS - runs the tests that the changed files can affect.
#
# Changed files differ from the last commit, or are part of it if no file differs. make
# reports which objects it would compile for them, and each linked test has a list of
# its objects (X.objects). Tests with a changed object run, two at a time, with the
# shortest of the last run first. No test begins after SECONDS.
set -u
build=$1 make=$2 limit=$3
. "$(dirname "$0")/count.sh"
cd "$(dirname "$0")/.." || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
begin=$(date +%s)

{
    git diff --name-only HEAD
    git ls-files --others --exclude-standard
} >"$work/changed"
[ -s "$work/changed" ] || git diff --name-only HEAD~1 HEAD >"$work/changed"
echo "changed: $(tr '\n' ' ' <"$work/changed")"

"$make" --no-print-directory -k -j 2 all >"$work/made" 2>&1 ||
    { grep -E 'error|warning' "$work/made"; fail "it does not build"; }
# The list consists of files.
# shellcheck disable=SC2046
"$make" --no-print-directory -n $(sed "s|^|-W |" "$work/changed") all tests 2>/dev/null |
    sed -n 's|.* -c -o [^ ]*/\([^ /]*\)\.o .*|[(/]\1[.]o|p' | sort -u >"$work/objects"

for list in "$build"/tests/unit/*.objects "$build"/tests/oracle/*.objects; do
    grep -q -f "$work/objects" "$list" || continue
    program=${list%.objects}
    case $program in
    */check_scene | */check_sample | */digest | */draw_*) continue ;;
    */oracle/check_*) part=$(basename "$program" | tr _ -) ;;
    *) part=$program ;;
    esac
    echo "$(cat "$program.seconds" 2>/dev/null || echo 1) $program $part"
done | sort -n >"$work/tests"
part_of() { # PATTERN PART VARIABLE: adds a part for matching changed files
    files=$(grep "$1" "$work/changed" | tr "\n" " ")
    [ -z "$files" ] || echo "5 $work/$2 $2 $3=$files" >>"$work/tests"
}
part_of "[.]md$" check-docs PAGES
part_of "scenes/.*[.]pov$" check-scenes SCENES
for part in check-rooms check-programs; do
    echo "5 $work/$part $part" >>"$work/tests"
done
sed -n "s|^[^ ]* \($build/[^ ]*\) .*|\1|p" "$work/tests" >"$work/programs"
echo "affected: $(wc -l <"$work/programs") tests"
xargs "$make" --no-print-directory -k -j 2 <"$work/programs" >"$work/made" 2>&1 ||
    { grep -E 'error|warning' "$work/made"; fail "the tests do not build"; }

cat >"$work/one" <<'END'
if [ "$(date +%s)" -ge "$4" ]; then
    echo "left out: $2"
    exit
fi
from=$(date +%s)
case $2 in
check-*) "$5" --no-print-directory JOBS=1 "$2" ${3:+"$3"} >"$1.log" 2>&1 ;;
*) "$2" >"$1.log" 2>&1 ;;
esac && echo "passed: $2" || { cat "$1.log"; echo "failed: $2"; }
echo "$(($(date +%s) - from))" >"$1.seconds"
END
# A line has the seconds, the program, its part, and a variable of the part.
while read -r _ program part variable; do
    printf '%s\n' "$program" "$part" "$variable" "$((begin + limit))" "$make"
done <"$work/tests" | xargs -r -d '\n' -n 5 -P 2 sh "$work/one" >"$work/results"
grep -v '^passed\|^left out' "$work/results"
for word in passed failed; do
    count=$(grep -c "^$word: " "$work/results")
    [ "$word" = passed ] && passed=$count || failed=$((failed + count))
done
left=$(grep -c '^left out' "$work/results")
[ "$left" -eq 0 ] || echo "$left tests were left out after $limit s: make check runs all"
counted
