#!/bin/sh
# check_course.sh BUILD - checks every lesson against docs/grading.md. All parts must
# exist. The starting program must assemble, run and fail, the solution must get gold,
# and other answers in the text must be correct. With THOROUGH all must keep their medals
# with fresh tests. (test_cheating_answers grades all solutions with a draw.)
set -u
build=$(cd "$1" && pwd)
. "$(dirname "$0")/count.sh"
cd "$(dirname "$0")/.." || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
said=$work/said
draws=${THOROUGH:+--fresh 4}

# Runs c205 WORD .., records its exit code, and writes its output to `said`.
c205() {
    "$build/c205" "$@" >"$said" 2>&1 </dev/null
}

medal() { # FILE: prints the last line of a verdict without the number of tests
    sed -n '$s/, [0-9]* of .*//; $p' "$1"
}

# Prints the headings of a text and the summaries of its hints.
headings() {
    sed -n 's/^## \(Exercise\|Hints\|What to remember\)$/\1/p
        s|^<details><summary>\(.* hint\)</summary>$|\1|p' "$1"
}

check_parts() { # FOLDER: checks the files of a lesson
    for file in lesson.md start.s solution.s fresh.s; do
        expect "$1 has no $file" [ -f "$1/$file" ]
    done
    find "$1" -mindepth 1 ! -name '*.s' ! -name '*.inc' ! -name '*.svg' \
        ! -name lesson.md ! -path "$1/answers" >"$said"
    expect "$1 has what belongs to no lesson" [ ! -s "$said" ]
    expect "$1: no test has goals" grep -q '^; goals:' "$1"/test-*.s
    sed -n 's/^; goals: //p' "$1"/test-*.s | tr -d , >"$work/goals"
    tr -d , <"$1/lesson.md" | grep '^Goals' | grep -q -F -f "$work/goals"
    verdict $? "$1/lesson.md: other goals than those of its tests"
    head -n 1 "$1/lesson.md" | grep -q '^# .'
    verdict $? "$1/lesson.md: no title in its first line"
    sed -n 2,3p "$1/lesson.md" | tr '\n' '|' | grep -q '^|[^#<|]'
    verdict $? "$1/lesson.md: no paragraph below the title"
    headings "$1/lesson.md" | diff - "$work/headings" >"$said"
    verdict $? "$1/lesson.md: other headings or hints"
    [ "$(grep -c '^</details>$' "$1/lesson.md")" -eq \
        "$(grep -c '^<details><summary>' "$1/lesson.md")" ]
    verdict $? "$1/lesson.md: hints without an end"
}

# A built-in lesson is given by name, and any other lesson by folder.
check_programs() { # FOLDER LESSON
    for program in start solution; do
        c205 asm "$1/$program.s" -o "$work/object" && [ ! -s "$said" ]
        verdict $? "$1/$program.s does not assemble, or is warned of"
        c205 run "$1/$program.s"
        verdict $? "$1/$program.s does not run by itself"
    done
    c205 check "$2" "$1/start.s"
    [ $? -eq 1 ] && grep -q -e ': not right (' -e 'too slow (' "$said"
    verdict $? "$1/start.s is not graded, or passes"
    # shellcheck disable=SC2086 # two words, or none
    c205 check "$2" "$1/solution.s" $draws && grep -q ': passed, gold$' "$said"
    verdict $? "$1/solution.s does not get gold"
    for answer in "$1"/answers/*.s; do
        [ -f "$answer" ] || continue
        c205 check "$2" "$answer"
        grep -q ': right' "$said" && ! grep -q ': not right (' "$said"
        verdict $? "$answer is not right"
        [ "$draws" ] || continue
        medal "$said" >"$work/medal"
        # shellcheck disable=SC2086 # two words
        c205 check "$2" "$answer" $draws
        medal "$said" | cmp -s - "$work/medal"
        verdict $? "$answer gets another medal with fresh tests"
    done
    c205 check "$2"
    verdict $? "$2 is not printed"
}

cat >"$work/headings" <<'END'
Exercise
Hints
First hint
Second hint
Third hint
What to remember
END
for folder in docs/course/*/ tests/lessons/*/; do
    [ -d "$folder" ] || continue
    folder=${folder%/}
    lesson=${folder##*/}
    expr "$lesson" : '[0-9][0-9]-[a-z][a-z0-9-]*$' >/dev/null
    verdict $? "$folder is no name of a lesson"
    check_parts "$folder"
    case $folder in
    docs/*) check_programs "$folder" "${lesson#*-}" ;;
    *) check_programs "$folder" "$folder" ;;
    esac
done

# The built-in lessons must be the same as the lessons of the folders.
c205 check --format csv
sed 1d "$said" | cut -d, -f1,2 >"$work/built-in"
for folder in docs/course/*/; do
    [ -d "$folder" ] || continue
    folder=${folder%/}
    lesson=${folder##*/}
    number=${lesson%%-*}
    echo "${number#0},${lesson#*-}"
done | diff - "$work/built-in" >"$said"
verdict $? "other lessons are built in"
[ "$(cut -d, -f1 "$work/built-in" | sort | uniq -d | wc -l)" -eq 0 ]
verdict $? "two lessons have one number"
counted
