#!/bin/sh
# check_grading.sh BUILD - checks c205 check as students and teachers use it: the
# verdicts on a lesson, an answer (rows of commands.txt) and a class of thirty.
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
check() { # CODE WORD ..: c205 check exits with the code
    code=$1
    shift
    ends "$code" "$build/c205" check "$@"
}

rows grading

# Files that students hand in.
answer() { # NAME SCRIPT: writes the edited solution
    sed "$2" "$lesson/solution.s" >"$1"
}
over() { # TIMES: makes the answer repeat its work TIMES times
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
3-bronze yes bronze ^    The largest part is vector stream: [0-9]* clocks, 9[0-9] %\.
4-slow no - ^large: right, [0-9]* clocks: too slow (
5-untouched no - ^    All 5 elements of y are wrong: element 0 was not stored and should be 2,
6-endless no - It was at line 23: here:
7-trap no - ^    drawer/7-trap.s:23:2: error: trap unmapped-address
8-bad no - ^    drawer/8-bad.s:23:9: error: .* did you mean MPYSH?$
9-sets-n no - ^    Line 8 sets n, which the tests set: put '.ifndef n' before it
10-no-label no - ^    The answer has no label above, which must hold results\.$
END
columns=student,lesson,passed,medal,clocks,right,tests,points,date,remarks,report
LC_ALL=C sort unsorted >wanted
expect "not thirty have handed in" [ "$(wc -l <wanted)" -eq 30 ]
for folder in class one-lesson; do
    check 0 --folder $folder "$lesson" --format csv --json $folder.json
    expect "the folder $folder prints an error" [ ! -s err ]
    expect "other columns" \
        [ "$(head -n 1 out)" = "$columns" ]
    sed 1d out | cut -d, -f1-4 | LC_ALL=C sort | cmp -s - wanted
    verdict $? "a class gets other marks: $folder"
    expect "not a line each" [ "$(wc -l <out)" -eq 31 ]
    [ "$(grep -c '"student": "[abc]' $folder.json)" -eq 30 ]
    verdict $? "not all are in the JSON: $folder"
done

# Every file has a row in every format. It has the reason if the file has no grade.
hand_in() { # KIND PATH
    mkdir -p "$(dirname "$2")"
    case $1 in
    folder) mkdir -p "$2" ;;
    link) ln -s nowhere "$2" ;;
    pipe) mkfifo "$2" ;;
    text) cp drawer/1-no-gold.s "$2" ;;
    esac
}
hand_ins() { # FOLDER [LESSON]; stdin: KIND PATH STUDENT LESSON REASON, "-" for none
    : >rows
    while read -r kind path student of reason; do
        hand_in "$kind" "$1/$path"
        [ "$reason" = - ] ||
            echo "${student#-},${of#-},no,,$1/$path: not graded: $reason" >>rows
    done
    LC_ALL=C sort rows >wanted
    check 1 --folder "$@" --format csv --json rows.json
    cut -d, -f5 wanted | sed 's/^/c205 check: /' | LC_ALL=C sort >messages
    LC_ALL=C sort err | cmp -s - messages
    verdict $? "other messages: $*"
    grep ': not graded: ' out | cut -d, -f1-4,11 | LC_ALL=C sort | cmp -s - wanted
    verdict $? "other rows: $*"
    [ "$(grep -c '^      "student": ' rows.json)" -eq $(($(wc -l <out) - 1)) ]
    verdict $? "other hand-ins in JSON: $*"
    [ "$(grep -c ': not graded: ' rows.json)" -eq "$(wc -l <wanted)" ]
    verdict $? "other reasons in JSON: $*"
    for format in text md; do
        check 1 --folder "$@" --format $format
        [ "$(grep -c 'not graded:' out)" -eq "$(wc -l <wanted)" ]
        verdict $? "other rows of $format: $*"
    done
}
hand_ins few "$lesson" <<'END'
text anna/scale.s anna scale -
text anna/numbers.s anna numbers -
folder anna/1.s anna scale a folder
text ben/Scale.s ben - its name is not the name of a lesson
text ben/SCALE.S ben - its name does not end in '.s'
text ben/scale.s.txt ben - its name does not end in '.s'
text ben/scale ben - its name does not end in '.s'
link ben/scale.s ben scale a broken link
link ben/notes.txt ben - a broken link
folder ben/old ben - a folder
pipe chloe/scale.s chloe scale a pipe or a device
text dora/numbers.s dora numbers -
folder dora dora scale no answer was found
folder emil emil scale no answer was found
text .hidden - - -
text fred/.scale.s fred scale -
folder fred fred scale no answer was found
text gina.s gina scale -
text gina.S gina - its name does not end in '.s'
text gina.s.txt gina - its name does not end in '.s'
link hans hans - a broken link
link hans.s hans scale a broken link
pipe ida.s ida scale a pipe or a device
END
truncate -s 300M few/kate.s
check 1 --folder few "$lesson" --format csv
tells out '^kate,scale,no,,.*,few/kate.s: not graded: this file has more than [0-9]* bytes$'
[ "$(grep -c ',scale,yes,gold,' out)" -eq 2 ]
verdict $? "hand-ins that are not graded change the marks"
hand_ins class-of-one <<'END'
text numbers.s - numbers -
text Numbers.s - - its name is not the name of a lesson
text numbers.s.txt - - its name does not end in '.s'
link anna anna - a broken link
link 1.s - numbers a broken link
text ben/2.s ben scoreboard -
text ben/Numbers.S ben - its name does not end in '.s'
folder chloe chloe - no answer was found
END
long=$(printf "%0200d" 205)
hand_in text "one/$long.s"
hand_in text one/anna.s
check 0 --folder one "$lesson" --format csv
tells out '^anna,scale,yes,gold,'
tells out "^$long,scale,yes,gold,"
for mark in '=1+1' '+1+1' '-1+1' '@a' "$(printf '\t=1')" "$(printf '\r=1')"; do
    hand_in text "marked/$mark/scale.s"
done
check 0 --folder marked "$lesson" --format csv
[ "$(grep -c "^\"\{0,1\}'.*scale,yes,gold," out)" -eq 5 ]
verdict $? "a name of a student is a formula"
tells out '^\\x0d=1,scale,yes,gold,'
if [ "$(id -u)" -ne 0 ]; then
    chmod 0 one/anna.s marked/=1+1
    hand_ins one "$lesson" <<'END'
none anna.s anna scale Permission denied
END
    hand_ins marked "$lesson" <<'END'
none =1+1 '=1+1 scale Permission denied
END
    chmod 700 one/anna.s marked/=1+1
fi
mkdir -p numbered/anna
cp drawer/1-no-gold.s numbered/anna/1.s
check 0 --folder numbered "$lesson" --format csv
tells out "^anna,scale,yes,gold,"
check 1 --folder missing "$lesson"
tells err '^c205 check: missing is not a folder'
mkdir empty
check 0 --folder empty

# Dates, remarks, points and the files for the students.
mkdir -p marks/anna marks/ben marks/chloe marks/dora marks/emil feedback
cp drawer/8-bad.s marks/emil/scale.s
cp drawer/2-silver.s marks/anna/scale.s
sed 's/xs/input/g; s/r10/r20/; s/;.*//' drawer/2-silver.s >marks/ben/1.s
cp drawer/5-untouched.s marks/chloe/scale.s
sed 's/^ *EXIT/        .if n == 1\n        EXIT\n        .endif\n&/' \
    drawer/1-no-gold.s | sed 's/limit, 1000/limit, n * 500/' >marks/dora/scale.s
TZ=UTC touch -d '2027-03-01 09:30' marks/anna/scale.s
check 0 --folder marks "$lesson" --format csv --feedback feedback --json marks.json
expect "the marks print an error" [ ! -s err ]
tells out '^anna,scale,yes,silver,30485,4,4,90,2027-03-01 09:30,,'
tells out '^ben,scale,yes,silver,30485,4,4,90,.*,The same code as anna/scale\.s\.,'
tells out '^chloe,scale,no,,,0,4,0,'
tells out '^emil,scale,no,,,0,4,0,.*The answer cannot be assembled:'
tells feedback/emil.txt 'error: .* did you mean MPYSH?$'
tells marks.json '"points": 90'
tells marks.json '"date": "2027-03-01 09:30"'
tells marks.json '"The same code as'
tells feedback/anna.txt '^anna/scale.s, 2027-03-01 09:30$'
tells feedback/anna.txt '^    It took 30485 clocks, 5485 more'
tells feedback/anna.txt '^Tests: 4 of 4 right\.  Points: 90 of 100\.$'
tells feedback/chloe.txt '^scale: not passed, 0 of 4 tests right$'
expect "not a file each" [ "$(find feedback -type f | wc -l)" -eq 5 ]
check 1 --folder marks "$lesson" --feedback nowhere
tells err '^c205 check: nowhere is not a folder$'

# A lesson without fresh inputs is refused, unless the teacher accepts it.
cp -r "$lesson" 01-scale
rm 01-scale/fresh.s
check 1 --folder marks 01-scale --format csv
tells out '^anna,scale,no,,.*not graded: 01-scale has no fresh\.s, which fresh tests need'
check 0 --folder marks 01-scale --format csv --no-fresh
tells out '^anna,scale,yes,silver,30485,3,3,90,'

# Unpublished tests, of one lesson and of the course.
mkdir -p hidden course/05-control-vectors
sed 's/n, 10000/n, 7/; s/^; test: .*/; test: seven/; s/want_above: .*/want_above: .word 0/
    /^; goals/d' "$lesson/test-large.s" >hidden/test-seven.s
sed 's/^; test: .*/; test: as the edge/' \
    "$here/docs/course/05-control-vectors/test-edge.s" \
    >course/05-control-vectors/test-other.s
check 0 --folder marks "$lesson" --format csv --tests hidden
tells out '^anna,scale,yes,silver,30485,5,5,90,'
check 0 "$lesson" drawer/1-no-gold.s --tests hidden
tells out '^seven: right (seven)$'
cp "$here/docs/course/05-control-vectors/solution.s" control-vectors.s
mkdir tax && mv control-vectors.s tax
check 0 --folder tax --tests course --format csv --json tax.json
tells out '^,control-vectors,yes,gold,.*,6,6,100,'
tells tax.json '"tries": "as the edge"'
echo 'want_y: .wort 1' >hidden/test-wrong.s
check 1 --folder marks "$lesson" --tests hidden
tells err '^c205 check: 01-scale/test-wrong.s:1: the note '
check 1 --folder marks "$lesson" --tests nowhere
tells err '^c205 check: nowhere is not a folder$'

# Ctrl-C while a class of endless loops is graded.
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
