#!/bin/sh
# check_grading.sh BUILD - c205 check as students and teachers meet it: a lesson, an answer,
# a class of thirty of whom it is known what they get.
set -u
. "$(dirname "$0")/count.sh"
cd "$(dirname "$0")/.." || exit 1
here=$(pwd)
build=$(cd "$1" && pwd)
lesson=$here/tests/lessons/01-scale
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
said=$work/err
. "$here/tests/commands.sh"
check() { # CODE WORD ..: c205 check, and how it ends
    code=$1
    shift
    ends "$code" "$build/c205" check "$@"
}

# A lesson
check 0
check 0 "$lesson"
tells out '^# Twice a vector$'
tells out '^large  *25000  *40000  *300000  *n = 10000  *x  *above, y  *ten'
! grep -q -e "First hint" -e "<" out
verdict $? "hints are printed, or tags"
check 0 "$lesson" --hints
tells out "^First hint$"
check 0 "$lesson" --format json
tells out '"start": "; y := 2 x'
check 0 "$lesson" --start
cmp -s out "$lesson/start.s"
verdict $? "the program to complete is another one"
check 0 "$lesson" --start -o begun.s
cmp -s begun.s "$lesson/start.s"
verdict $? "the program to complete is written otherwise"
check 1 "$lesson" --start -o missing/begun.s
check 2 --start
check 2 --hints
check 2 "$lesson" begun.s --hints
check 2 "$lesson" --start --hints
check 2 "$lesson" --folder . --hints
check 2 "$lesson" begun.s --start
check 2 "$lesson" -o begun.s
check 2 "$lesson" begun.s --folder .
check 1 no-lesson
tells err "there is no lesson 'no-lesson'"
check 1 "$here/tests/lessons"
tells err 'is no lesson: it has no lesson.md'
mkdir broken
cp "$lesson"/lesson.md "$lesson"/start.s broken
printf '; test: one\n; goals: gold 3, silver 2, bronze 1\n' >broken/test-one.s
check 1 broken begun.s
tells err "^c205 check: broken/test-one.s:2: expected 'goals:"
printf '; test: one\nwant_y: .wort 1\n' >broken/test-one.s
check 1 broken begun.s
tells err '^c205 check: test-one.s:2:9: '
check 1 broken
tells err '^c205 check: test-one.s:2:9: '
printf '; test: one\n; expect-model: nosuch\nwant_y: .word 1\n' >broken/test-one.s
check 1 broken --folder .
tells err "^c205 check: test-one.s: there is no machine model 'nosuch'"
[ "$(wc -l <err)" -eq 1 ]
verdict $? "a wrong test is told more than once"

# An answer
check 0 "$lesson" "$lesson/solution.s"
tells out '^scale: passed, gold$'
"$build/c205" check "$lesson" - <"$lesson/solution.s" | cmp -s - out
verdict $? "an answer from stdin is graded otherwise"
check 1 "$lesson" begun.s --json verdict.json
tells out '^small: not right (five elements)$'
tells out '^    above is 0 and should be 1\.  It holds what it held'
tells verdict.json '"passed": false'
check 1 "$lesson" begun.s --format json
cmp -s out verdict.json
verdict $? "the verdict in a file is another one"
check 1 "$lesson" begun.s --format csv
tells out '^small,no,,[0-9]*,"above is 0 and'
check 1 "$lesson" begun.s --format md
cp "$lesson/solution.s" .
printf '        .include "solution.s"\n' >includes.s
ends 0 "$build/c205" run includes.s
check 1 "$lesson" includes.s
tells out "'solution.s' cannot be read"
check 1 "$lesson" missing.s
tells err '^c205 check: missing.s: '
check 1 "$lesson" begun.s --json missing/verdict.json

# What students hand in
answer() { # NAME SCRIPT: the solution, edited
    sed "$2" "$lesson/solution.s" >"$1"
}
over() { # TIMES: the work, done so often
    printf 's/^ *MPYSV .*/ .rept %d\\n&\\n .endr/' "$1"
}
mkdir drawer
answer drawer/1-no-gold.s ''
answer drawer/2-silver.s "$(over 5)"
answer drawer/3-bronze.s "$(over 40)"
answer drawer/4-slow.s "$(over 100)"
answer drawer/5-untouched.s '/MPYSV/d'
answer drawer/6-endless.s 's/^ *MPYSV/here: BIM here\n&/'
answer drawer/7-trap.s 's/^ *MPYSV/ LOD [r0], two\n&/'
answer drawer/8-bad.s 's/MPYSV/MPYSW/'
answer drawer/9-sets-n.s 's/^ *\.ifndef.*/ .if 1/'
answer drawer/10-no-label.s '/^above:/s//over:/; s/, above$/, over/'
while read -r kind does medal text; do
    if [ "$does" = yes ]; then code=0; else code=1; fi
    check $code "$lesson" "drawer/$kind.s"
    tells out "$text"
    for student in anna ben chloe; do
        mkdir -p "class/$student-$kind" one-lesson
        cp "drawer/$kind.s" "class/$student-$kind/scale.s"
        cp "drawer/$kind.s" "one-lesson/$student-$kind.s"
        echo "$student-$kind,scale,$does,${medal#-}" >>unsorted
    done
done <<'END'
1-no-gold yes gold ^scale: passed, gold$
2-silver yes silver ^    It took [0-9]* clocks, [0-9]* more than the 25000 of gold\.$
3-bronze yes bronze ^    What took most is vector stream: [0-9]* clocks, 9[0-9] %\.
4-slow no - ^large: right, [0-9]* clocks: too slow (
5-untouched no - ^    All 5 elements of y are wrong: element 0 is 0 and should be 2,
6-endless no - It was in line 23 then: here:$
7-trap no - ^    drawer/7-trap.s:23:2: error: trap unmapped-address
8-bad no - ^    drawer/8-bad.s:23:9: error: .* did you mean MPYSH?$
9-sets-n no - ^    Line 8 sets n, which the tests set: put '.ifndef n' before it
10-no-label no - ^    The answer has no label above, where results are looked for\.$
END
LC_ALL=C sort unsorted >wanted
[ "$(wc -l <wanted)" -eq 30 ]
verdict $? "not thirty have handed in"
for folder in class one-lesson; do
    check 0 --folder $folder "$lesson" --format csv --json $folder.json
    [ ! -s err ]
    verdict $? "something is told of the folder $folder"
    [ "$(head -n 1 out)" = student,lesson,passed,medal,clocks,report ]
    verdict $? "other columns"
    sed 1d out | cut -d, -f1-4 | LC_ALL=C sort | cmp -s - wanted
    verdict $? "a class gets other marks: $folder"
    [ "$(wc -l <out)" -eq 31 ]
    verdict $? "not a line each"
    [ "$(grep -c '"student": "[abc]' $folder.json)" -eq 30 ]
    verdict $? "not all are in the JSON: $folder"
done

# What is not known is told
mkdir -p few/anna/old few/ben one
cp drawer/2-silver.s few/anna/scale.s
cp drawer/8-bad.s few/ben/scale.s
cp drawer/1-no-gold.s one/anna.s
touch few/.hidden
rmdir few/anna/old
check 0 --folder few "$lesson" --format md
check 0 --folder few "$lesson"
cp out known
mkdir few/anna/old
touch few/anna/other.s few/notes.txt one/notes.txt
check 1 --folder few "$lesson" --json few.json
cmp -s out known
verdict $? "strange files change the marks"
for name in anna/old anna/other.s notes.txt; do
    tells err "^c205 check: few/$name: not graded"
done
[ "$(wc -l <err)" -eq 3 ]
verdict $? "more is told"
[ "$(grep -c '"student": "' few.json)" -eq 2 ]
verdict $? "the JSON is not kept"
check 1 --folder one "$lesson" --format csv
tells err '^c205 check: one/notes.txt: not graded'
tells out '^anna,scale,yes,gold,'
ln -s nowhere one/dangling.s
mkfifo one/pipe.s
long=$(printf "%0200d" 205)
cp drawer/1-no-gold.s "one/$long.s"
check 1 --folder one "$lesson" --format csv
tells err "^c205 check: one/dangling.s: not graded, as it is no file$"
tells err "^c205 check: one/pipe.s: not graded, as it is no file$"
tells out "^$long,scale,yes,gold,"
mkdir -p numbered/anna
cp drawer/1-no-gold.s numbered/anna/1.s
check 0 --folder numbered "$lesson" --format csv
tells out "^anna,scale,yes,gold,"
check 1 --folder few
tells err 'few/anna/scale.s: not graded'
check 1 --folder missing "$lesson"
tells err '^c205 check: missing: '
mkdir empty
check 0 --folder empty

# Ctrl-C in the middle of a class of endless loops
mkdir late
for student in 0 1 2 3 4 5 6 7 8 9; do
    cp drawer/6-endless.s late/$student.s
    cp drawer/6-endless.s late/1$student.s
done
"$build/c205" check --folder late "$lesson" --json late.json >out 2>err &
sleep .5
kill -INT $!
wait $!
[ $? -eq 1 ] && [ ! -s out ] && [ -z "$(find . -name 'late.json*')" ]
verdict $? "an interrupted class leaves marks"
tells err "^c205 check: interrupted$"
counted
