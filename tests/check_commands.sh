#!/bin/sh
# check_commands.sh BUILD - the commands as a user meets them: exit codes,
# where output goes, files written whole or not at all, Ctrl-C.
set -u
. "$(dirname "$0")/count.sh"
build=$(cd "$1" && pwd)
here=$(pwd)
scene=$here/scenes/first.pov
kernels=$(pwd)/rt/kernels
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
said=$work/err

. "$here/tests/commands.sh"

cat >good.s <<'END'
        .include "print.s"
        .data
numbers: .word 1.5, 2.0
        .code
        EX      r10, numbers
        LOD     [r10], r11
        print_number r11
        EXIT
END
printf '        ADDN r1, r2\n        NOPE\n        ADDNV [r1], [r2], [r3\n' >bad.s
printf 'loop:   BIM loop\n' >endless.s
printf '        EX r10, 64\n        LOD [r10], r11\n        EXIT\n' >trap.s
printf '#version 3.7;\novus { }\nsphere { 0, }\n' >bad.pov
printf '#version 3.7;\nsphere { 0, 1 pigment { granite } }\n' >replaced.pov
printf '#version 3.7;\nsphere { 0, 1e-310 }\n' >beyond.pov

printf 'title Odd\nlike cyber205-2pipe\nmemory.banks 0 banks R\n' >odd.model
cat >expects.s <<'END'
        EX      r10, 5
        EXIT
; expect: r10 = 5
END
cat >wrong.s <<'END'
        .include "print.s"
        EX      r10, 5
        print_integer r0
        EX      r11, 1
        print_integer r11
        EXIT
        .org    0x10000040
x:      .word   1.0, X'A000 0000 0000 0000'
; expect: r10 = 6
; expect: [x] = 2.0
; expect: [0x7000000000] = 1
; expect-bits: [x + 64] = 111
; expect-flags: 1
; expect-clocks: 3
; expect-print: 0
; expect-print: two
END
printf '        EX r10, 64\n        LOD [r10], r11\n        EXIT\n%s\n' \
    '; expect-trap: bad-link' >wrong_trap.s
printf '        EX r10, 64\n        LOD [r10], r11\n        EXIT\n%s\n' \
    '; expect: r10 = 64' >wrong_end.s
printf '        ES r1, 2\n        EXIT r1, r0, 2\n        EXIT\n%s\n' \
    '; expect-print: 2' >right_print.s
printf '        ES r1, 2\n        EXIT r1, r0, 2\n        EXIT r1, r0, 5\n%s\n%s\n' \
    '        EXIT r1, r0, 2' '        EXIT
; expect-print: 2' >wrong_print.s
printf '        EXIT\n; expect-bits: [0x7000000000] = 1\n' >wrong_bits.s
printf 'loop:   BIM loop\n; expect: r1 = 0\n' >endless_test.s
printf '        .include "print.s"\n        ES r10, N + M\n%s\n        EXIT\n' \
    '        print_integer r10' >defined.s

narrow() { # COMMAND: but for names of files it prints no long lines
    [ -z "$(awk -v here="$here" 'length > 100 && !index($0, here)' out)" ]
    verdict $? "lines of more than 100 characters: $1"
}

# help and wrong usage: every command and option that the programs list
for program in c205 rt205; do
    ends 0 "$build/$program" --help
    cp out summary
    ends 0 "$build/$program" -h
    cmp -s out summary
    verdict $? "$program -h is not --help"
    ends 0 "$build/$program" help
    cmp -s out summary
    verdict $? "$program help is not --help"
    ends 2 "$build/$program"
    ends 2 "$build/$program" nonsense
    tells err 'no such command: nonsense'
    ends 2 "$build/$program" help nonsense
done
for program in c205 rt205 fit205; do
    ends 0 "$build/$program" --version
    tells out "^$program [0-9.]*$"
    ends 0 "$build/$program" help --list
    cp out "$program.list"
    ends 2 "$build/$program" help --nonsense
    ends 2 "$build/$program" help --completion tcsh
done

names() { # what the help of the command names: every option and operand
    while read -r what its_command name letter kind choices; do
        [ "$what" != command ] || continue
        [ "$its_command" = "$command" ] || continue
        tells help.txt "$name"
        [ "$letter" = - ] || tells help.txt "^  -$letter, $name"
        for choice in $choices; do
            tells help.txt "$choice"
        done
    done <"$program.list"
}
refuses() { # ARGUMENT ..: as usage, with the choices and the way to the help
    # No word is none.
    # shellcheck disable=SC2086
    ends 2 "$build/$program" $word "$@"
    tells err "$program $word${word:+ }--help tells how it is used"
    [ ! -s out ]
    verdict $? "wrong usage prints on stdout: $*"
}
wrong_values() { # a value that each option refuses, and none
    while read -r what its_command name letter kind choices; do
        [ "$what" = option ] || continue
        [ "$its_command" = "$command" ] || continue
        case $kind in
        flag)
            refuses "$name=yes"
            tells err "$name takes no argument"
            continue
            ;;
        count | clocks | number | own) refuses "$name" nonsense ;;
        choice)
            refuses "$name" nonsense
            for choice in $choices; do
                tells err "$choice"
            done
            ;;
        *) refuses "$name" '' ;;
        esac
        tells err "$name: wrong argument"
        refuses "$name"
        tells err "$name needs an argument"
        near=${name%?}${name#"${name%?}"}x
        refuses "$near" 1
        tells err "no such option: $near"
    done <"$program.list"
}
for program in c205 rt205 fit205; do
    while read -r what command rest; do
        [ "$what" = command ] || continue
        word=$command
        [ "$command" = - ] && word=
        # No word is none.
        # shellcheck disable=SC2086
        ends 0 "$build/$program" $word --help
        cp out help.txt
        [ ! -s err ]
        verdict $? "$program $word --help prints on stderr"
        # shellcheck disable=SC2086
        ends 0 "$build/$program" $word -h
        cmp -s out help.txt
        verdict $? "$program $word -h is not --help"
        if [ -n "$word" ]; then
            ends 0 "$build/$program" help "$word"
            cmp -s out help.txt
            verdict $? "$program help $word is not --help"
            ends 2 "$build/$program" "${word}x"
            tells err "($word?)"
        fi
        # shellcheck disable=SC2086
        ends 0 "$build/$program" $word --version
        tells out "^$program [0-9.]*$"
        [ "$(awk 'length > 79' help.txt)" = '' ]
        verdict $? "$program $word --help has lines beyond 79 columns"
        names
        refuses --nonsense
        refuses -Z
        wrong_values
    done <"$program.list"
done
ends 2 "$build/c205" run
ends 2 "$build/c205" run --limit many good.s
ends 2 "$build/c205" isa NOPE
ends 2 "$build/rt205" render "$scene"
ends 2 "$build/rt205" render "$scene" -o x.png --no-picture
ends 2 "$build/rt205" render "$scene" --half --no-picture
ends 2 "$build/rt205" render "$scene" -o x.png -W 0
ends 2 "$build/rt205" render "$scene" -o x.png --queue 65536
ends 2 "$build/rt205" render "$scene" -o x.png --mode sideways
ends 2 "$build/rt205" render "$scene" -o x.png --half
ends 2 "$build/rt205" render "$scene" -o x.png --json x.png

# programs
ends 0 "$build/c205" run good.s
tells out '1.5'
tells out '[0-9] clocks, [0-9.]* us$'
tells out '^time, us  *all  *%$'
tells out '^page fault  *20.00 '
tells out '^all  *[0-9.]*  *100.0$'
# The account, a message and the trace start on a line of their own, whether or
# not the program has ended its last line, and no empty line is added.
own_line() { # FILE ARGUMENT ..: stdout and stderr in one stream
    "$build/c205" run "$@" >joined 2>&1 </dev/null
    grep -qx '1.5' joined && ! grep -q '1[.]5.' joined &&
        ! grep -A1 -x '1.5' joined | grep -qx ''
    verdict $? "the program's output shares its line: $*"
}
sed 's/^        EXIT/        EXIT r0, r0, 5\n&/' good.s >ended.s
sed 's/^        EXIT/        LOD [r0], r11/' good.s >open_trap.s
sed 's/^        EXIT/        EX r12, 3\n        ADDN r11, r12, r13\n&/' good.s >open_warning.s
for file in good.s ended.s open_trap.s open_warning.s; do
    for format in text csv md json; do
        own_line $file --format $format
        [ $format = text ] || own_line $file --format $format --trace
    done
    own_line $file --json joined.json
    own_line $file --limit 1060 --save -
done
# Line by line.
ends 0 "$build/c205" run good.s --profile --json profile.json
tells out "^line  *clocks  *%  *times"
tells profile.json "\"operand_wait\""
ends 0 "$build/c205" run good.s --profile --in-order --warm --format csv
tells out "^line,clocks,percent,executions,elements,issue"
ends 2 "$build/c205" run good.s --in-order
tells err "in-order is of --profile"
ends 2 "$build/c205" run --check good.s --profile
ends 2 "$build/c205" run --restore some.state --profile
ends 2 "$build/c205" run --restore some.state --warm
"$build/c205" asm good.s -o good.o
ends 1 "$build/c205" run good.o --profile
tells err "the source lines of good.o are not known; run its text"

# Two programs side by side.
matrix=$here/asm/examples/profiling/matrix
ends 0 "$build/c205" compare --warm "${matrix}_3.s" "${matrix}_4.s" --json compare.json
tells out "^The second takes [0-9]* clocks less than the first: "
tells compare.json "\"regions\""
ends 0 "$build/c205" compare "${matrix}_4.s" --other-model cyber205-4pipe
tells out "fewer of vector stream.$"
ends 0 "$build/c205" compare "${matrix}_4.s" --other-define n=24 --format csv
"$build/c205" compare "${matrix}_3.s" "${matrix}_4.s" --format csv |
    awk -F, '$1 == "all" { print first == $2 && second == $3 ? $2 " " $3 : "off" }
             NF == 5 { first += $2; second += $3 }' >summed
for number in 3 4; do
    "$build/c205" run "${matrix}_$number.s" | sed -n 's/ clocks, .*//p'
done | paste -s -d ' ' | cmp -s - summed
verdict $? "compare has other clocks than run"
ends 0 "$build/c205" compare good.s good.s
tells out "^Both take [0-9]* clocks.$"
ends 1 "$build/c205" compare good.s endless.s
tells err "endless.s: trap clock-limit"
ends 1 "$build/c205" compare good.s missing.s
ends 2 "$build/c205" compare good.s
tells err "with what?"
ends 2 "$build/c205" compare good.s good.s good.s

# Clock by clock.
for kind in svg kanata json; do
    ends 0 "$build/c205" timeline good.s -o run.$kind
    tells out "^run.$kind: [0-9]* instructions, clocks 0 to "
done
tells run.svg "^</svg>$"
tells run.kanata "^Kanata.0004$"
tells run.json "^]}$"
ends 0 "$build/c205" timeline endless.s --from 1000 --to 1100 --warm -o run.svg
tells out "clocks 1000 to 1100$"
ends 1 "$build/c205" timeline endless.s -o never.svg
tells err "these are more than 50000 instructions: choose some by --from CLOCK and --to CLOCK"
[ ! -e never.svg ]
verdict $? "half a timeline is kept"
ends 1 "$build/c205" timeline good.s --from 5000000 -o never.svg
tells err "no instruction is at work then: the program takes [0-9]* clocks"
ends 1 "$build/c205" timeline trap.s -o run.svg
[ -s run.svg ]
verdict $? "a program that traps has no timeline"
tells err "^trap.s: trap unmapped-address"
ends 1 "$build/c205" timeline good.s -o missing/run.svg
ends 2 "$build/c205" timeline good.s
ends 2 "$build/c205" timeline good.s -o run.pdf
tells err "run.pdf: a timeline is .svg, .kanata or .json"
ends 2 "$build/c205" timeline good.s --from 9 --to 9 -o run.svg

# Against a constant.
saxpy=$here/asm/examples/saxpy
ends 0 "$build/c205" sweep "${saxpy}_scalar.s" "${saxpy}_vector.s" --warm \
    --define n=1:64:x2 -o sweep.svg --json sweep.json
tells out "^From n = 4 on the second is faster: [0-9]* clocks, and the first "
tells out "^Cycle-accounted, not cycle-accurate, on the model cyber205-2pipe;"
tells sweep.svg "^</svg>$"
tells sweep.json "\"n_half\""
tells sweep.json "\"vector_startup\""
"$build/c205" sweep "${saxpy}_vector.s" --define n=8:65535 --points 5 --format csv |
    awk -F, '/^# Causes/ { causes = 1 }
             causes && $1 == "first" {
                 sum = 0
                 for (i = 4; i <= NF; i++) sum += $i
                 print $2, $3, sum }' >summed
for n in 8 76 724 6889 65535; do
    "$build/c205" run "${saxpy}_vector.s" --define n=$n |
        sed -n "s/^\([0-9]*\) clocks, .*/$n \1 \1/p"
done | cmp -s - summed
verdict $? "a sweep has other clocks than run"
ends 0 "$build/c205" sweep "${matrix}_4.s" --define n=4:16 --format md
tells out "^The first is no straight line in n: "
printf '        ES r10, k\n        EXIT\n' >flat.s
ends 0 "$build/c205" sweep flat.s --define k=1:9
tells out "^The clocks of the first do not grow with k.$"
ends 1 "$build/c205" sweep good.s --define unused=1:9
tells err "^c205 sweep: 'unused' is defined, and not used$"
ends 1 "$build/c205" sweep flat.s --define k=1:9 --define unused=2
tells err "^c205 sweep: 'unused' is defined, and not used$"
ends 0 "$build/c205" sweep flat.s good.s --define k=1:9
ends 0 "$build/c205" compare flat.s good.s --define k=1
ends 1 "$build/c205" compare flat.s good.s --define k=1 --define unused=2
tells err "^c205 compare: 'unused' is defined, and not used$"
ends 1 "$build/c205" compare flat.s good.s --define k=1 --other-define unused=2
tells err "^c205 compare: 'unused' is defined, and not used$"
ends 0 "$build/c205" sweep "${saxpy}_scalar.s" --define n=1:9 -o - --format csv
tells out "^<svg "
tells err "^# Lines$"
ends 1 "$build/c205" sweep "${saxpy}_scalar.s" trap.s --define n=2:9 -o never.svg
tells err "^c205 sweep: trap.s with n = 2: trap unmapped-address"
ends 1 "$build/c205" sweep endless.s --define n=2:9
tells err "endless.s with n = 2: trap clock-limit"
ends 1 "$build/c205" sweep bad.s --define n=2:9 -o never.svg
tells err "bad.s:2:9: error"
tells err "^c205 sweep: bad.s with n = 2: it cannot be assembled"
[ ! -e never.svg ]
verdict $? "half a sweep is drawn"
ends 1 "$build/c205" sweep good.o --define n=2:9
tells err "constants of an object are fixed; name its text"
ends 1 "$build/c205" sweep missing.s --define n=2:9
ends 1 "$build/c205" sweep good.s --define n=2:9 -o missing/x.svg
ends 2 "$build/c205" sweep good.s
tells err "against what? --define NAME=FROM:TO"
ends 2 "$build/c205" sweep --define n=2:9
ends 2 "$build/c205" sweep good.s good.s good.s --define n=2:9
ends 2 "$build/c205" sweep good.s --define n=2:9 --define m=2:9
tells err "one constant runs through a range, not 2"
ends 2 "$build/c205" sweep good.s --define n=2:9 --define n=3
tells err "n has a range and a value as well"
ends 2 "$build/c205" sweep good.s --define n=9:2
tells err "NAME=FROM:TO, FROM:TO:STEP, FROM:TO:xFACTOR, from 1 on and rising"
ends 2 "$build/c205" sweep good.s --define n=1:9:2 --points 4
ends 2 "$build/c205" sweep good.s --define n=1:5000:1
tells err "the range has more than 1000 values"
ends 2 "$build/c205" sweep good.s --define n=1:5:5
ends 2 "$build/c205" sweep good.s --define n=1:5 -o x.png
tells err "x.png: a picture is .svg"

# Each of its values takes some tenths of a second, all of them many.
printf '        ES r1, n\n        EX r10, 20000000\n%s' \
    '        EX r11, loop
loop:   DBNZ r10, [r11]
        EXIT
' >slow.s
"$build/c205" sweep slow.s --define n=1:500:1 -o never.svg >out 2>err &
sleep 1
kill -INT $!
wait $!
[ $? -eq 1 ] && [ ! -e never.svg ]
verdict $? "Ctrl-C ends a sweep"
tells err "^c205 sweep: slow.s with n = [0-9]*: interrupted$"

# A message about a limit contains the limit
{ printf '        .data\nv:      .word   1'; seq -f ', %.0f' -s '' 20000; } >wide_line.s
ends 1 "$build/c205" asm wide_line.s
tells err "too long: a line has at most 65536 bytes"
printf ' .macro m\n m\n .endm\n m\n' >deep.s
ends 1 "$build/c205" asm deep.s
tells err "nested too deeply, more than 64"

# An empty program is reported as empty
: >empty.s
printf '        .data\nv:      .word   1\n' >data.s
for file in empty.s data.s; do
    for verb in run debug "run --check" "sweep --define n=1:2"; do
        # The words are of one command.
        # shellcheck disable=SC2086
        ends 1 "$build/c205" $verb "$file"
        cat err >>out
        tells out "the program is empty"
    done
done

# A sweep that fails says where
cat >at.s <<'END'
        .include "core.s"
        .ifndef n
        .equ    n, 4
        .endif
        .regs   r16, x
        .code
        load_constant x, n
        .if     n > 20
        LOD     [x], x
        .endif
        EXIT
END
ends 1 "$build/c205" sweep at.s --define n=10:30:5
tells err "at.s with n = 25: trap"

# The debugger, by scripts and by a pipe.
printf "step\n\nassert step == 2\n# and no more\nwhy\nquit\nassert 0\n" >good.lines
printf 'assert step == 1\nstpe' >bad.lines
ends 0 "$build/c205" debug -x good.lines good.s
tells out "^(c205) assert step == 2$"
tells out "^step 2, clock [0-9]*$"
tells out "^arrived at clock "
ends 1 "$build/c205" debug -x bad.lines good.s
tells out "^error: it does not hold: step == 1$"
tells out "^error: there is no .stpe.: was it step?$"
ends 1 "$build/c205" debug -x . good.s
tells err " debug: . cannot be read: "
ends 1 "$build/c205" debug -x missing.lines good.s
tells err "missing.lines cannot be read: "
ends 1 "$build/c205" debug missing.s
ends 2 "$build/c205" debug
ends 2 "$build/c205" debug good.s bad.s
printf 'continue\n' | "$build/c205" debug good.s >out 2>err
verdict $? "the debugger at the end of a pipe"
tells out "^1.5$"
tells out "^the program has ended with status 0$"
{ echo continue; sleep 2; echo "print clock > 1000"; } |
    "$build/c205" debug endless.s >out 2>err &
sleep 1
kill -INT $!
wait $!
[ $? -eq 1 ]
verdict $? "Ctrl-C ends the debugger, or an interrupted script succeeds"
tells out "^interrupted$"
tells out "^1  X.1.$"
ends 0 "$build/c205" run good.s --format csv
tells out '^all,page fault,1000,2[.e0-9-]*,'
tells out '^region,entries,instructions,vector_instructions,elements,operations,clocks,seconds,percent$'
ends 1 "$build/c205" run missing.s
ends 1 "$build/c205" run bad.s
tells err 'bad.s:1:'
tells err 'bad.s:2:'
tells err 'bad.s:3:'
tells err '\^'
ends 1 "$build/c205" run trap.s
tells err 'unmapped-address'
ends 1 "$build/c205" run --limit 10000 endless.s
tells err 'clock-limit'
ends 0 "$build/c205" asm good.s -o good.o
ends 0 "$build/c205" run good.o
tells out '1.5'
ends 0 "$build/c205" dis good.o
cp out again.s
ends 0 "$build/c205" asm again.s -o again.o
ends 0 "$build/c205" dis again.o
cmp -s out again.s
verdict $? "disassembling twice gives two texts"
ends 0 "$build/c205" run good.s --json run.json
[ -s run.json ]
verdict $? "run.json is empty"
ends 1 "$build/c205" run good.s --json missing/run.json
ends 1 "$build/c205" run good.s --model nonsense
ends 0 "$build/c205" isa ADDNV,H
ends 2 "$build/c205" isa LOD,H
ends 0 "$build/c205" isa ADDNV
tells out 'normalised'
ends 0 "$build/c205" isa
narrow "c205 isa"
"$build/c205" isa --names >names
awk 'NR > 1 && !/^ / { print $1 }' out | cmp -s - names
verdict $? "not a row of each instruction"
# The names are words.
# shellcheck disable=SC2046
ends 0 "$build/c205" isa $(cat names)
narrow "c205 isa MNEMONIC"
ends 0 "$build/c205" model cyber205-4pipe
tells out 'startup.vadd'
ends 0 "$build/c205" time --model cyber205-2pipe-prior
narrow "c205 time"
awk 'NR == 1 { at = index($0, "instructions"); next }
    !/^Cycle/ { print substr($0, at) }' out | tr -s ' ' '\n' | sort >classes
tells out "^vadd  *51.1 .* 102.1 .* ADDUV ADDLV ADDNV"
tells out "^vadd,H  *51.2 .* 204.8 .* ADDUV ADDLV ADDNV"
ends 0 "$build/c205" time --format csv
for name in VXTOV ACPSV CNTOB 'ADDNV,H' TRIAD; do
    tells out "^\"*${name}[,\"]"
done
sed '/^instruction/d; /^#/d; /^$/d; s/^"\([^,]*\),H"/\1/; s/,.*//' out | sort | cmp -s - classes
verdict $? "the classes do not have each instruction once"

# what a command does with wrong arguments
ends 2 "$build/c205" asm
tells err 'FILE is missing'
ends 2 "$build/c205" model one two
tells err 'too many arguments: two'
ends 2 "$build/c205" run --limit
tells err 'needs an argument'
ends 2 "$build/c205" run --points good.s
tells err 'no such option: --points; it is for time'
ends 2 "$build/c205" run good.s trap.s
ends 2 "$build/c205" time NOPE
tells err 'no such vector instruction: NOPE'
ends 2 "$build/c205" isa --markdown ADDNV
tells err 'stands alone'
ends 2 "$build/c205" isa --card --grammar
tells err 'stands alone'
for define in NAME =1 NAME=x; do
    ends 2 "$build/c205" run --define $define good.s
    tells err "wrong argument: $define"
done
ends 2 "$build/c205" run --define k=1 --define k=2 flat.s
tells err "wrong argument: k=2 (NAME=VALUE, a name and an integer, each name once)"
# Names that cannot be, or are not used, wherever they are given.
for define in "a b" r5 h255 ADDN 3x .code "" unused; do
    code=1
    [ "$define" ] || code=2
    for command in run asm dis debug "timeline -o defined.svg" "run --check" \
        "compare --other-model cyber205-1pipe"; do
        # The command and its options.
        # shellcheck disable=SC2086
        ends $code "$build/c205" $command flat.s --define k=1 --define "$define=1" \
            </dev/null
        cat out >>err
        tells err "'$define' \(is defined, and not used\|cannot be defined: it is\)\|wrong argument"
    done
    ends $code "$build/c205" sweep flat.s --define k=1:9 --define "$define=1"
    ends $code "$build/c205" sweep flat.s --define "$define=1:9" --define k=1
done
ends 1 "$build/c205" run good.o --define k=1
tells err "^good.o: error: 'k' is defined, and not used$"
for command in run asm dis; do
    ends 1 "$build/c205" $command bad.s
    tells err 'bad.s:2:'
done
ends 1 "$build/c205" model nonsense
ends 1 "$build/c205" isa --markdown --model nonsense
ends 1 "$build/c205" isa --card --model nonsense
ends 1 "$build/c205" isa --card --model cdc6600
tells err "cdc6600 has no clocks of single instructions"
ends 1 "$build/c205" time --model nonsense ADDNV
ends 1 "$build/c205" run --check --model nonsense good.s
ends 1 "$build/c205" asm good.s -o missing/good.o
printf 'c205-object 1\nentry nowhere\n' >bad.o
ends 1 "$build/c205" run bad.o
tells err 'bad.o'
if [ -e /dev/full ]; then
    "$build/c205" isa >/dev/full 2>err
    [ $? -eq 1 ]
    verdict $? "a full disc is not noticed"
    tells err 'write error'
fi

# every table as a file
for command in 'run good.s' 'run --check expects.s' 'isa' 'isa ADDNV' \
    'isa --names' 'model' 'model cyber205-1pipe' 'time ADDNV TRIAD'; do
    rm -f table.json
    # The command and its arguments are words.
    # shellcheck disable=SC2086
    ends 0 "$build/c205" $command --json table.json
    [ "$(head -c 1 table.json)" = '{' ] && [ "$(tail -c 2 table.json)" = '}' ]
    verdict $? "c205 $command --json: no table"
    # shellcheck disable=SC2086
    ends 1 "$build/c205" $command --json missing/table.json
done
ends 1 "$build/c205" time --model odd.model ADDNV --json never.json
tells err "^odd.model:3:14: error: "
[ ! -e never.json ]
verdict $? "a run that failed wrote its table"
ends 0 "$build/c205" model
tells out '^cyber205-4pipe'
ends 0 "$build/c205" time --points ADDNV TRIAD
tells out '^TRIAD .* 65535 '

# what is printed of a program
ends 0 "$build/c205" asm --listing good.s
tells out 'LOD  *\[r10\], r11'
ends 0 "$build/c205" run --trace good.s
tells err 'LOD .*\[r10\], r11'
printf '        ES r10, 7\n        EXIT r10, r0, 0\n' >seven.s
ends 1 "$build/c205" run seven.s
tells err 'ended with status 7'
printf '        EXIT r0, r0, 99\n' >asks.s
ends 1 "$build/c205" run asks.s
tells err 'bad-request'
printf '        EX r10, 64\n        ELEN r10, 8\n%s' \
    '        EXIT r10, r0, 4
        EXIT
' >nowhere.s
ends 1 "$build/c205" run nowhere.s
tells err 'unmapped-address at 400060: EXIT: address 40'
ends 0 "$build/c205" run --define N=3 --define M=0x10 defined.s
tells out '^19'

# test programs that find what they do not expect
ends 0 "$build/c205" run --check expects.s
tells out '^PASS expects.s'
ends 1 "$build/c205" run --check expects.s wrong.s seven.s bad.s missing.s
tells out '^1 passed, 4 failed$'
tells out '^FAIL wrong.s'
tells out "wrong.s:9: expected r0*10 = X'0000 0000 0000 0006' (6), found X'0000 0000 0000 0005' (5)"
tells out "expected word 0, at 10000040, = X'FFD3 4000 0000 0000' (2), found"
tells out 'expected a value at 7000000000, found no memory there'
tells out 'expected bit 1, at 10000081, = 1, found 0'
tells out 'expected data flags = '
tells out 'expected 3 clocks, found '
tells out "expected 'two' printed, found ''"
tells out 'the program expects nothing'
tells out 'bad.s:2:'
tells out 'missing.s'
for kind in trap end print bits; do
    ends 1 "$build/c205" run --check wrong_$kind.s
done
ends 1 "$build/c205" run --check wrong_trap.s
tells out 'expected trap bad-link, found: '
ends 1 "$build/c205" run --check wrong_end.s
tells out 'expected the program to EXIT, found: '
ends 1 "$build/c205" run --check wrong_print.s
tells out "expected nothing more printed, found '2'"
ends 1 "$build/c205" run --check wrong_bits.s
tells out 'found no memory there'
# the model that a program names, and the one that the user names
printf '        EXIT\n; expect-clocks: 5\n; expect-model: cyber205-1pipe\n' >named.s
ends 1 "$build/c205" run --check named.s
tells out 'expected 5 clocks, found'
ends 0 "$build/c205" run --check --model cyber205-4pipe named.s
tells out 'PASS named.s (but for the clocks: not of cyber205-4pipe)'
printf '; expect-model: nonsense\n' >>right_print.s
ends 1 "$build/c205" run --check right_print.s
# traps with their line, the limit that a run has, Ctrl-C, the exit status
ends 1 "$build/c205" run trap.s
tells err '^trap.s:2:9: error: trap unmapped-address .*: no memory is mapped there'
tells err '^    r10 = '
printf '        ES r1, 259\n        EXIT r1\n' >status.s
ends 3 "$build/c205" run --exit-status status.s
ends 1 "$build/c205" run --exit-status trap.s
ends 1 "$build/c205" run endless.s
tells err '^endless.s:1:1: error: trap clock-limit'
tells err '--limit CLOCKS or --no-limit'
"$build/c205" run --no-limit endless.s >out 2>err &
sleep 1
kill -TERM $!
wait $!
[ $? -eq 1 ]
verdict $? 'an interrupted run does not end with 1'
tells err 'interrupted; these are the accounts'
tells out 'clocks'

# warnings: of a text and of a run, turned off, into errors
printf '        ES r1, 3\n        ES r2, 1\n        MPYS r1, r2, r1\n%s\n' \
    '        EXIT' >product.s
ends 0 "$build/c205" run product.s
tells err '^product.s:3:9: warning: r1 is the integer 3.*-Winteger-operand'
tells err '^            MPYS r1, r2, r1$'
ends 1 "$build/c205" run -Werror product.s
tells err '^product.s:3:9: error: '
ends 0 "$build/c205" run -Werror -Wno-integer-operand product.s
ends 0 "$build/c205" run -Wno-all product.s
[ ! -s err ]
verdict $? 'a warning is told that was turned off'
ends 2 "$build/c205" run -Wnonsense product.s
ends 0 "$build/c205" asm -W list
tells out '^run-off '
printf '        ES r1, 3\n' >endless_code.s
ends 0 "$build/c205" asm endless_code.s
tells err '^endless_code.s:1:9: warning: .*-Wrun-off'
ends 1 "$build/c205" asm -Werror endless_code.s

ends 1 "$build/c205" run --check --limit 100 endless_test.s
tells out 'clock-limit'

# programs that are saved and go on
cat >counting.s <<'TEXT'
        .include "print.s"
        EX      r10, 0
        EX      r11, 100
        EX      r13, 1
loop:   print_integer r10
        IBXLT   r10, r13, r11, loop, r10
        EXIT
TEXT
ends 0 "$build/c205" run counting.s
cp out whole
ends 0 "$build/c205" run counting.s --limit 300 --save early
tells out 'saved as early'

ends 0 "$build/c205" run --restore early counting.s --limit 700 --save late
ends 0 "$build/c205" run --restore late
sed 1d whole >whole.accounts
cp whole.accounts whole.counting
sed 1d out | cmp -s - whole.accounts
verdict $? "a restored run ends with other accounts"
cat >vectors.s <<'TEXT'
        .include "core.s"
        .include "print.s"
        .data
list:   .space  2000
        .code
        descriptor r10, list, 2000
        load_constant r11, 1.5
        INTVLV  r11, r11, [r10]
        SUMV    [r10], r12
        print_number r12
        EXIT
TEXT
ends 0 "$build/c205" run vectors.s
sed 1d out >whole.accounts
ends 0 "$build/c205" run vectors.s --limit 700 --save middle
tells out '^700 clocks'
ends 2 "$build/c205" run --restore middle --limit 3000 --save middle
tells err 'save would write over the input middle'
ends 0 "$build/c205" run --restore middle --limit 3000 --save further
tells out '^3000 clocks'
ends 0 "$build/c205" run --restore further
tells out '^3001500'
sed 1d out | cmp -s - whole.accounts
verdict $? "a run that was stopped in vector instructions ends otherwise"
ends 1 "$build/c205" run --restore early --limit 400
tells err 'clock-limit'
ends 1 "$build/c205" run --restore late good.s
tells err 'another program'
ends 1 "$build/c205" run --restore late --model cyber205-4pipe
tells err 'cyber205-2pipe'
ends 1 "$build/c205" run --restore good.s
tells err 'not a saved machine'
head -c 1000 late >part
ends 1 "$build/c205" run --restore part
tells err 'damaged'
ends 1 "$build/c205" run --restore missing
ends 0 "$build/c205" run good.s --limit 1000000 --save never
tells err 'nothing is saved'
[ ! -e never ]
verdict $? "a run that ended was saved"
ends 1 "$build/c205" run counting.s --limit 300 --save missing/state
ends 2 "$build/c205" run good.s --save state
ends 2 "$build/c205" run --check good.s --save state --limit 10
ends 2 "$build/c205" run --restore late good.s trap.s

# kernels are programs like any other
ends 0 "$build/c205" asm -I "$kernels" "$kernels/roots/roots_vector.s" --define QUEUE=2000
ends 0 "$build/c205" asm -I "$kernels" "$kernels/roots/roots_scalar.s"

# polynomials
cat >good.csv <<'END'
c4,c3,c2,c1,c0,bound
# four, the same above 2.5, none, two beyond doubles
1,-10,35,-50,24
 1, -10, 35, -50, 24, 2.5

1,0,0,0,1
0,0,1e3000,-3e3000,2e3000,
END
printf '1,-10,35,-50,24\n1,2,3,4\n1,2,x,4,5\n1,2,3,4,5,6,7\n1,2,3,4,1e9000\n' \
    >bad.csv
printf '1,2,3,4,1e-9000\n1,2,3,4 5\n1,2,3,,5\ninf,0,0,0,1\n' >bad2.csv
printf '1,1e4000,0,0,1\n0,0,0,1,-2\n' >far.csv
for mode in scalar vector; do
    ends 0 "$build/rt205" quartic good.csv --mode $mode
    grep -v '^#' out >$mode.roots
    tells out '^# 4 polynomials, 8 roots; '$mode
    tells out '^# root_solver '
done
cmp -s scalar.roots vector.roots
verdict $? "scalar and vector form find other roots"
[ "$(cut -d: -f1 vector.roots | tr '\n' ' ')" = '0 1 2 3 ' ]
verdict $? "not the numbers 0 to 3 before the roots"
[ "$(sed -n 3p vector.roots)" = '2:' ]
verdict $? "roots of t^4 + 1"
ends 0 "$build/rt205" quartic good.csv --first --json roots.json
[ "$(grep -v '^#' out | awk '{ n += NF - 1 } END { print n }')" -eq 3 ]
verdict $? "not the first roots alone"
grep -q '"texts"' roots.json
verdict $? "no roots in roots.json"
ends 0 "$build/rt205" quartic good.csv --falsi illinois
tells out "falsi illinois$"
ends 0 "$build/rt205" quartic good.csv --falsi all
tells out '^# anderson-bjorck *vector '
printf '\357\273\277c4,c3,c2,c1,c0\r\n0,0,0,1,-2' >sheet.csv
ends 0 "$build/rt205" quartic sheet.csv
tells out "^0: 2$"
: >nothing.csv
ends 0 "$build/rt205" quartic nothing.csv
tells out "^# 0 polynomials, 0 roots"
ends 1 "$build/rt205" quartic bad.csv --json never.json
tells err '^bad.csv:2:8: error: expected a comma'
tells err '^bad.csv:3:5: error: expected a number'
tells err '^bad.csv:4:12: error: more than six numbers'
tells err '^bad.csv:5:9: error: larger than'
[ ! -s out ] && [ ! -e never.json ]
verdict $? "bad polynomials have roots"
ends 1 "$build/rt205" quartic bad2.csv
tells err '^bad2.csv:1:9: error: smaller than'
tells err '^bad2.csv:2:9: error: expected a comma'
tells err '^bad2.csv:3:7: error: expected a number'
tells err '^bad2.csv:4:1: error: expected a number'
ends 1 "$build/rt205" quartic far.csv
tells err '^far.csv:1:1: error: polynomial 0: '
tells out '^1: '
ends 1 "$build/rt205" quartic missing.csv
tells err 'missing.csv'
ends 1 "$build/rt205" quartic good.csv --json missing/roots.json
ends 1 "$build/rt205" quartic good.csv --model nonsense
ends 2 "$build/rt205" quartic
tells err 'FILE is missing: a file of polynomials'
ends 2 "$build/rt205" quartic good.csv bad.csv
ends 2 "$build/rt205" quartic good.csv --mode sideways
ends 2 "$build/rt205" quartic good.csv --falsi nonsense
ends 2 "$build/rt205" quartic good.csv --queue 0
ends 2 "$build/rt205" quartic good.csv -W 3
tells err "no such option: -W"

# heat
cat >bay.pov <<"END"
#version 3.7; camera { location -5*z look_at 0 }
cylinder { 0, .7*y, 1 open }
disc { 0, y, 1.8, 1 }
disc { .7*y, -y, 1.8, 1 }
END
for mode in scalar kernels vector; do
    ends 0 "$build/rt205" heat bay.pov --rays 200 --repeats 3 --mode $mode
    sed "/^Where/,\$d" out >$mode.factors
    cmp -s scalar.factors $mode.factors
    verdict $? "scalar form and $mode find other factors"
done
tells out "^1 *environment  0\.[34]"
ends 0 "$build/rt205" heat bay.pov --rays 64 --points random --seed 7 --json heat.json
tells heat.json "\"factors\""
# Surfaces that nothing sees are counted; --details and JSON list them.
echo "sphere { 0, 1 } sphere { 0, .5 }" >hidden.pov
cp hidden.pov hidden_2.pov
echo "sphere { 0, .2 }" >>hidden_2.pov
ends 0 "$build/rt205" heat hidden.pov --rays 16 --json heat.json
tells out "^1 surface has no area that is seen; --details lists it$"
[ "$(grep -c '^[0-9]* *sphere' out)" -eq 1 ] && [ "$(grep -c '"kind"' heat.json)" -eq 2 ]
verdict $? "heat does not leave out the surface that is not seen"
ends 0 "$build/rt205" heat hidden_2.pov --rays 16
tells out "^2 surfaces have no area that is seen; --details lists them$"
ends 0 "$build/rt205" heat hidden.pov --rays 16 --details
[ "$(grep -c '^[0-9]* *sphere' out)" -eq 2 ] && ! grep -q 'no area that' out
verdict $? "heat --details does not list the surface that is not seen"
echo "plane { y, -1 } sphere { 0, 1 }" >floor.pov
ends 0 "$build/rt205" heat floor.pov --rays 64
tells err "^floor.pov:1: warning: the plane receives alone: a plane has no end"
ends 2 "$build/rt205" heat bay.pov --rays 0
ends 2 "$build/rt205" heat bay.pov --rays 1048577
ends 2 "$build/rt205" heat bay.pov --repeats 1
ends 2 "$build/rt205" heat bay.pov --points square
ends 2 "$build/rt205" heat bay.pov --mode 1984
ends 0 "$build/rt205" heat bay.pov --rays 16 --repeats 2 --stages --json heat.json
tells out "^step  *scalar  *kernels  *vector"
tells heat.json "\"speedup_vector\""
ends 2 "$build/rt205" heat bay.pov --stages --ranks 2
tells err "stages compares what this process finds: not with --ranks or --part"
ends 0 "$build/rt205" heat bay.pov --rays 16 --tolerance .01
tells out "16 repeats of 256 points of each primitive"
ends 1 "$build/rt205" heat bay.pov --rays 16 --tolerance 1e-9 --limit 40 --json never.json
tells err "the tolerance 1e-09 is not reached: the error of the factor from [123] to "
tells out "16 repeats of 40 points of each primitive"
[ ! -e never.json ]
verdict $? "factors that are not good enough are kept"
ends 2 "$build/rt205" heat bay.pov --tolerance .1 --part 1/2 --resume kept
for wish in --stages --smooth --exchange "--tolerance .1" "-o hits.png"; do
    # An option and its value are two words.
    # shellcheck disable=SC2086
    ends 2 "$build/rt205" heat bay.pov --hits --from 1 $wish
    tells err "hits tells what rays strike, and no more"
done
ends 1 "$build/rt205" heat bay.pov --rays 16 --tolerance 1e-9 --limit 40 --show factor --from 1 -o never.png
[ ! -e never.png ]
verdict $? "factors that are not good enough are drawn"
ends 2 "$build/rt205" heat bay.pov --tolerance 2
ends 2 "$build/rt205" heat bay.pov --by line
ends 2 "$build/rt205" heat
ends 1 "$build/rt205" heat missing.pov

cat >shell.pov <<'END'
#declare Ball = sphere { 0, 1 }
#declare Shell = difference { sphere { 0, 2.5 } sphere { 0, 2 } }
#declare Ball_Temperature = 500;
object { Ball } object { Shell }
END
heat_shell() { # CODE OPTION ..: heat of this scene ends with the code
    code=$1
    shift
    ends "$code" "$build/rt205" heat shell.pov --by part --rays 64 --repeats 4 \
        --exchange "$@"
}
heat_shell 0 --temperature Shell=300 --emissivity Ball=.5 --json heat.json
tells out "^Ball  *0\.500  500\.0"
tells out "^all  *-*[0-9]"
tells heat.json "\"flows\""
heat_shell 0 --temperature Shell=adiabatic --temperature environment=20
heat_shell 1
tells err "no temperature is known of: Shell; --temperature NAME=KELVINS, or default=300"
heat_shell 1 --temperature Lid=3
tells err "no part and no material is called 'Lid'; parts: Ball, Shell"
heat_shell 1 --temperature Shell=-3
tells err "a temperature is NAME=VALUE with a value not below 0, not 'Shell=-3'"
heat_shell 1 --temperature Shell=3 --emissivity Shell=1.5
tells err "an emissivity is NAME=VALUE with a value 0 to 1"
cat >room.pov <<'END'
#declare Room = sphere { 0, 2 inverse }
#declare Ball = sphere { 0, 1 }
object { Room } object { Ball }
END
ends 1 "$build/rt205" heat room.pov --by part --rays 64 --exchange --temperature default=adiabatic
tells err "the exchange has no solution: surface [A-Z][a-z]* is of some that are adiabatic"
ends 1 "$build/rt205" heat floor.pov --rays 64 --exchange --temperature default=300
tells err "surface 1, the plane of line 1, receives alone"
heat_shell 0 --temperature Shell=300 --smooth -W 40 -H 30 -o flows.png
tells out "^picture flows.png: flow from -.* W/m^2; "
tells out "^Smoothed factors:"
[ -s flows.png ]
verdict $? "no picture of flows"
ends 0 "$build/rt205" heat shell.pov --by part --rays 64 --show factor --from Ball -W 40 -H 30 -o factors.exr
tells out "^picture factors.exr: factor from 0 to 1; "
ends 1 "$build/rt205" heat shell.pov --by part --rays 64 --show factor --from Lid -o factors.png
tells err "no surface is called .Lid., or nothing comes from it; surfaces: Ball, Shell"
ends 2 "$build/rt205" heat shell.pov -o flows.png
tells err "a picture shows flows, which --exchange finds; or --show factor --from NAME"
ends 2 "$build/rt205" heat shell.pov --show factor -o flows.png
ends 2 "$build/rt205" heat shell.pov --exchange -o flows.xcf
ends 1 "$build/rt205" heat shell.pov --exchange -o missing/flows.png
ends 2 "$build/rt205" heat shell.pov --exchange --part 1/2 --resume kept -o flows.png
cat >row.pov <<'END'
#declare Burner = disc { 0, y, 2 }
#declare Tube = cylinder { -2*x, 2*x, .3 }
object { Burner } object { Tube translate y }
END
ends 0 "$build/rt205" heat bay.pov --rays 64 --strict
printf "#version 3.7; plane { y, 0 }\ndisc { -2*y, y, 1 }\nsphere { <1,-1,0>, .4 }\n" >sunk.pov
ends 0 "$build/rt205" heat sunk.pov --rays 64
ends 1 "$build/rt205" heat sunk.pov --rays 64 --strict
tells err "A F from [0-9] to [0-9] is not that back: .* --strict allows 4.5"
heat_hits() { # CODE OPTION ..: hits in this scene end with the code
    code=$1
    shift
    ends "$code" "$build/rt205" heat row.pov --hits --rays 128 --repeats 2 "$@"
}
heat_hits 0 --from Burner --json heat.json
tells out "^CDC 6600, projected  *1  "
tells out "^vector  *2000  "
tells heat.json "\"hits\""
heat_hits 1
tells err "^rt205 heat: --hits asks --from NAME"
heat_hits 1 --from Stove
tells err "no part and no material is called 'Stove'"
heat_hits 1 --from Tube
tells err "the disc of line 1 is no solid cylinder"
printf "sphere { 0, .5 }\nbox { <1,-1,-1>, <2,1,1> }\n" >pair.pov
ends 0 "$build/rt205" heat pair.pov --lines 64 --tolerance .01 --limit 2048
tells out "16 repeats of 1024 lines through all of it"
ends 0 "$build/rt205" heat pair.pov --lines 2000 --json heat.json
tells out "16 repeats of 128 lines through all of it"
tells heat.json "\"lines\": 128"
ends 0 "$build/rt205" heat shell.pov --lines 2000 --by part --exchange --temperature Shell=300
tells out "^all  *-*0\.000$"
ends 1 "$build/rt205" heat sunk.pov --lines 64
tells err "line 1 has no end that is known"

echo "camera { location -5*z }" >nothing.pov
ends 1 "$build/rt205" heat nothing.pov
tells err "the scene has no surfaces"

# masses
cat >parts.pov <<'END'
#version 3.7;
#declare Copper = texture { pigment { rgb <.7, .4, .2> } }
#declare Copper_Density = 8.96;
#declare Pin = cylinder { 0, 2*y, .5 }
object { Pin texture { Copper } }
sphere { 3*x, 1 }
plane { y, -9 }
END
cat >named.pov <<'END'
#version 3.7;
#declare Pin = cylinder { 0, 2*y, .5 }
object { Pin #ifdef (part) part { "lower pin" density 2 temperature 300 emissivity .5 } #end }
object { Pin translate 3*x #ifdef (part) part { "upper pin" density 4 } #end }
END
ends 0 "$build/rt205" mass named.pov --rays 512
tells out "^lower pin  *mass  *3\.1"
tells out "^upper pin  *mass  *6\.[23]"
ends 0 "$build/rt205" heat named.pov --by part --rays 64 --exchange --temperature "upper pin=adiabatic"
tells out "^lower pin  *0\.500  300\.0"
ends 1 "$build/rt205" heat named.pov --by part --rays 64 --exchange
tells err "no temperature is known of: upper pin"
cat >again.pov <<'END'
#declare Ring = torus { 2, .3 part { "lower ring" density 7 } }
#declare Other = object { Ring translate 2*y part { "upper ring" density 5 } }
#declare Kept = object { Ring }
object { Kept } object { Other translate y }
END
ends 0 "$build/rt205" mass again.pov --rays 512
tells out "^lower ring  *mass"
tells out "^upper ring  *mass"
echo "sphere { 0, 1 part { } }" >bad_part.pov
ends 1 "$build/rt205" mass bad_part.pov
tells err "expected the part.s name, a string"
echo "sphere { 0, 1 part { \"a\" weight 3 } }" >bad_part.pov
ends 1 "$build/rt205" mass bad_part.pov
tells err "expected a word of part"
echo "sphere { 0, 1 part { \"\" } }" >bad_part.pov
ends 1 "$build/rt205" mass bad_part.pov
tells err "a part.s name has 1 to 200 characters"
printf '#version 3.7;\nsphere { 0, 1 }\ndisc { 4*x, z, 1 }\n' >open.pov
printf '1 7.85 Steel\n2 .5 line 6\n' >densities.txt
printf '1 7.85 Steel\n2 x Pine\n' >bad.txt
ends 0 "$build/rt205" mass parts.pov --densities densities.txt --rays 512 \
    --json mass.json
tells err '^parts.pov: warning: line 7 has no end: it is left out$'
tells out '^Pin  *volume  *1\.[56]'
tells out '^Pin  *mass  *14\.'
tells out '^line 6  *mass  *2\.'
tells out '^all  *mass  *1[56]\.'
tells mass.json '"figures": \['
cp out vector
ends 0 "$build/rt205" mass parts.pov --densities densities.txt --rays 512 \
    --queue 77 --jobs 3
[ "$(sed "/^stage/,\$d" out)" = "$(sed "/^stage/,\$d" vector)" ]
verdict $? "a mass depends on the queue or the jobs"
ends 0 "$build/rt205" mass parts.pov --densities densities.txt --rays 512 \
    --mode kernels --stages
tells out "^step  *scalar  *kernels  *vector"
ends 0 "$build/rt205" mass parts.pov --densities densities.txt --rays 512 \
    --mode scalar
[ "$(sed '1d; /^stage/,$d' out)" = "$(sed '1d; /^stage/,$d' vector)" ]
verdict $? "scalar and vector form find other masses"
ends 0 "$build/rt205" mass parts.pov --part Copper --units mm,g --rays 512
tells out '^Pin  *volume .* mm^3$'
tells out '^Pin  *mass  *0\.014'
tells out '^Pin  *Ixx .* g mm^2$'
ends 0 "$build/rt205" mass parts.pov --density default=1 --by material \
    --overlaps --about 1,2,3 --points grid --seed 7 --rays 512
tells out '^Copper  *volume '
tells out '^overlaps  *volume '
tells out 'inertia I about <1, 2, 3>'
ends 0 "$build/rt205" mass parts.pov --part Pin --rays 512 --tolerance 1e-2
ends 1 "$build/rt205" mass parts.pov --part Pin --rays 512 --tolerance 1e-9 \
    --limit 2048 --json never.json
tells err 'the tolerance 1e-09 is not reached: the error of .* of Pin is '
[ ! -e never.json ]
verdict $? "masses that are not good enough are kept"
ends 1 "$build/rt205" mass parts.pov --json never.json
tells err 'no density is known of: line 6; --density NAME=VALUE'
[ ! -s out ] && [ ! -e never.json ]
verdict $? "masses without a density"
ends 1 "$build/rt205" mass parts.pov --density Brass=8
tells err "no part and no material is called 'Brass'; parts: Pin, line 6"
ends 1 "$build/rt205" mass parts.pov --part Brass
tells err "called 'Brass'"
ends 1 "$build/rt205" mass parts.pov --density Copper
tells err "a density is NAME=VALUE with a value above 0, not 'Copper'"
ends 1 "$build/rt205" mass parts.pov --densities bad.txt
tells err '^bad.txt:2:1: error: a line is a number, a density and a name'
ends 1 "$build/rt205" mass parts.pov --densities missing.txt
tells err 'missing.txt'
ends 1 "$build/rt205" mass parts.pov --part 'line 7' --density default=1
tells err 'the solid of line 7 has no end that is known'
ends 1 "$build/rt205" mass open.pov --density default=1
tells err 'the disc of line 3 is an open surface: it has no volume'
ends 1 "$build/rt205" mass bad.pov --density default=1
ends 2 "$build/rt205" mass
ends 2 "$build/rt205" mass parts.pov --rays 0
ends 2 "$build/rt205" mass parts.pov --repeats 1
ends 2 "$build/rt205" mass parts.pov --mode 1984
ends 2 "$build/rt205" mass parts.pov --density default=1 --stages --part 1/2 --resume kept
ends 2 "$build/rt205" mass parts.pov --points few
ends 2 "$build/rt205" mass parts.pov --about 1,2
ends 2 "$build/rt205" mass parts.pov --units mm
ends 2 "$build/rt205" mass parts.pov --by line
ends 2 "$build/rt205" mass parts.pov --tolerance 0
ends 2 "$build/rt205" mass parts.pov -W 3

# pictures
ends 2 "$build/rt205" render "$scene" -o a.png -W 40 -H 30 --json ./a.png
ends 2 "$build/rt205" render "$scene" -o a.png \
    --resume "$work/a.png"
ends 0 "$build/rt205" render "$scene" -o a.png -W 40 -H 30 --json a.json
[ -s a.png ] && [ -s a.json ]
verdict $? "no picture, or no a.json"
[ "$(wc -l <out)" -eq 5 ]
verdict $? "a frame is not told of in five lines"
tells out 'first.pov: 40 x 30, vector, a queue of 2000; 1200 of 1200 rays hit$'
tells out '^[0-9]* clocks, [0-9.]* us on the machine$'
tells out '^frame checksum [0-9A-F]\{16\}$'
tells out '^picture a.png$'
for key in '"rays": 1200' '"hits": 1200' '"picture": "a.png"' \
    '"causes": \[' '"regions": \['; do
    tells a.json "$key"
done
cp out short
ends 0 "$build/rt205" render "$scene" -o a.png -W 40 -H 30 --json b.json \
    --accounts
narrow "rt205 render --accounts"
head -5 out | cmp -s - short
verdict $? "the accounts do not follow the result"
cmp -s a.json b.json
verdict $? "the accounts are not in the JSON in any case"
tells out '^page fault '
tells out '^mean vector length '
! grep -q -e torus -e ' 0  *0  *0' out
verdict $? "the accounts tell of what took nothing"
ends 0 "$build/rt205" render "$scene" -o a.png -W 40 -H 30 --accounts \
    --format csv
tells out '^shade,page fault,[0-9]*000,'
ends 0 "$build/rt205" render "$scene" -o a.png -W 40 -H 30 --profile --jobs 2
tells out '^region  *line  *clocks '
tells out '^shade  *light_vector.s:[0-9]* '
ends 0 "$build/rt205" render "$scene" --no-picture -W 40 -H 30 --profile \
    --in-order --json lines.json
tells out '^frame  *frame_vector.s:'
tells lines.json '"lines": \['
ends 2 "$build/rt205" render "$scene" --no-picture --in-order
ends 2 "$build/rt205" render "$scene" --no-picture --profile --resume a.bands
tells err '--profile watches all bands'
cp a.png b.png
ends 0 "$build/rt205" render "$scene" -o b.png -W 40 -H 30
grep -v '^picture ' out >pictured
ends 0 env RT205_LIBDIR=missing "$build/rt205" render "$scene" --no-picture \
    -W 40 -H 30
cmp -s pictured out
verdict $? "rt205 render --no-picture tells something else"
cmp -s a.png b.png
verdict $? "the same frame twice gives two pictures"
# A pixel under the debugger.
printf 'seek\nlane nearest\nassert step > 0\ntbreak shade\ncontinue\nlane\nquit\n' >pixel.lines
for mode in vector kernels; do
    ends 0 "$build/rt205" render "$scene" -W 40 -H 30 --mode $mode --queue 50 \
        --debug 20,15 -x pixel.lines
    tells out '^lane [0-9]* of 50 rays in the queue$'
    tells out '^    nearest  *X'
done
ends 0 "$build/rt205" render "$scene" -W 10 -H 8 --mode scalar --debug 2,1 \
    -x good.lines
printf 'seek\nlane\nhelp\n' | "$build/rt205" render "$scene" -W 10 -H 8 --mode scalar \
    --debug 2,1 >out 2>err
verdict $? "the debugger of a frame at the end of a pipe"
tells out '^pixel 2,1$'
tells out '^lane .VECTOR.$'
ends 1 "$build/rt205" render "$scene" -W 40 -H 30 --debug 20,15 -x bad.lines
tells out '^error: there is no .stpe.: was it step?$'
ends 1 "$build/rt205" render "$scene" -W 40 -H 30 --debug 20,15 --samples 2
tells err 'a pixel of this frame has 2 x 2 rays: only one alone is followed$'
ends 2 "$build/rt205" render "$scene" -W 40 -H 30 --debug 40,15
ends 2 "$build/rt205" render "$scene" -W 40 -H 30 --debug 20,15 -o never.png
tells err '--debug writes nothing'
ends 2 "$build/rt205" render "$scene" --no-picture -x pixel.lines
# A queue of it, clock by clock.
for kind in svg kanata json; do
    ends 0 "$build/rt205" timeline "$scene" -W 40 -H 30 -o queue.$kind
    tells out "^queue.$kind: [0-9]* instructions, clocks [0-9]* to [0-9]* of band 1 of 1$"
done
tells queue.svg "vector, the queue of pixel 20,15 of 40 x 30, clocks "
ends 0 "$build/rt205" timeline "$scene" -W 40 -H 30 --pixel 3,29 --region shade \
    -o queue.svg
ends 1 "$build/rt205" timeline "$scene" -W 40 -H 30 --region torus -o never.svg
tells err "control is not in the region torus between clocks [0-9]* and [0-9]*$"
ends 1 "$build/rt205" timeline "$scene" -W 40 -H 30 --from 0 --mode scalar -o never.svg
tells err "are more than 50000 instructions: choose some by --region NAME, "
ends 1 "$build/rt205" timeline "$scene" -W 40 -H 30 --from 999999999 -o never.svg
tells err "nothing is left$"
[ ! -e never.svg ]
verdict $? "half a timeline of a frame is kept"
ends 2 "$build/rt205" timeline "$scene" -W 40 -H 30 --pixel 40,0 -o never.svg
tells err "there is no pixel 40,0: the frame has 40 x 30$"
ends 2 "$build/rt205" timeline "$scene" --pixel 40 -o never.svg
ends 2 "$build/rt205" timeline "$scene" -o never.png
ends 2 "$build/rt205" timeline "$scene"
ends 2 "$build/rt205" timeline "$scene" --from 9 --to 9 -o never.svg
ends 2 "$build/rt205" render "$scene" -o a.gif -W 40 -H 30
tells err "\.png, \.jpg, \.exr or \.tif"
ends 1 "$build/rt205" render "$scene" -o missing/a.png -W 40 -H 30
for ending in jpg exr tif; do
    ends 0 "$build/rt205" render "$scene" -o a.$ending -W 40 -H 30
    [ -s a.$ending ]
    verdict $? "no a.$ending"
done
dated() { # DATE: whether a.exr has it
    grep -a -q -e "$1" a.exr
}
ends 0 "$build/rt205" render "$scene" -o a.exr -W 40 -H 30
! dated capDate && ! dated ':[0-9][0-9]:[0-9][0-9] '
verdict $? "a picture has a date that nobody asked for"
version=$("$build/rt205" --version)
tells a.exr "$version"
cp a.exr b.exr
sleep 1
ends 0 "$build/rt205" render "$scene" -o a.exr -W 40 -H 30
cmp -s a.exr b.exr
verdict $? "the same frame a second later is another file"
ends 0 env SOURCE_DATE_EPOCH=86400 "$build/rt205" render "$scene" -o a.exr \
    -W 40 -H 30
dated '1970:01:02 00:00:00'
verdict $? "a picture lacks the date of SOURCE_DATE_EPOCH"
ends 0 env SOURCE_DATE_EPOCH=today "$build/rt205" render "$scene" -o a.exr \
    -W 40 -H 30
cmp -s a.exr b.exr
verdict $? "what is no date changes a picture"
ends 1 "$build/rt205" render missing.pov -o a.png
ends 1 "$build/rt205" render beyond.pov -o a.png
tells err "beyond.pov:2:1"
ends 1 "$build/rt205" render bad.pov -o a.png
tells err 'bad.pov:2:'
tells err 'bad.pov:3:'
tells err '\^'
cmp -s a.png b.png
verdict $? "a failed render has changed the picture"
ends 0 "$build/rt205" render replaced.pov -o c.png -W 40 -H 30
tells err 'replaced.pov:2:'
ends 1 "$build/rt205" render replaced.pov -o c.png -W 40 -H 30 --strict

# the paper's table
# .. of named rows alone: those of the whole table
ends 0 "$build/rt205" speedup -W 16 -H 10 --format csv
grep -e ^primitive -e cylinder -e torus out >whole
ends 0 "$build/rt205" speedup TORUS cylinder -W 16 -H 10 --format csv
grep -v "^#" out | grep , | cmp -s - whole
verdict $? "rows that are named are not those of the whole table"
ends 2 "$build/rt205" speedup spere
tells err "spere: no row of Table 1"
ends 2 "$build/rt205" speedup --formulations sphere
ends 0 "$build/rt205" speedup -W 40 -H 25 --queue 200 --json short.json
cp out short
[ "$(wc -l <short)" -eq 20 ]
verdict $? "Table 1 and its two lines on the models are not 20 lines"
tells out "on the model cyber205-2pipe; more by --provenance$"
tells out "on the model cyber720; more by --provenance$"
! grep -q -e "root_solver" -e "cdc6600" out
verdict $? "details are printed though not asked for"
ends 0 "$build/rt205" speedup -W 40 -H 25 --queue 200 --details \
    --json speedup.json
cmp -s short.json speedup.json
verdict $? "the JSON of the table is not that of its details"
sed '/^In each row/d' out | grep -v -x -F -f - short >missing
[ ! -s missing ]
verdict $? "the details lack something of the short table"
for row in sphere cylinder Steiner torus; do
    tells out "^$row.* vector "
done
tells out "root_solver"
tells out "paper: %"
[ "$(grep -c "pass by pass" out)" -eq 0 ]
verdict $? "the passes are printed though not asked for"
tells out "^Table 1"
for row in sphere cylinder Steiner; do
    for figures in ours paper "error %"; do
        tells out "^$row  *$figures "
    done
done
for row in cylinder Steiner torus; do
    tells out "^$row, ours  *ours "
done
tells out "Projected, .* on the model cyber720; more by --provenance$"
tells out "Projected, .* on the model cdc6600; more by --provenance$"
tells out "frame are equal"
for key in table1 projections rays times projected shares steps passes causes; do
    grep -q "\"$key\": \[" speedup.json
    verdict $? "speedup.json has no $key"
done
ends 0 "$build/rt205" speedup -W 16 -H 10 --distance 9.5 --angle 20 --passes
tells out "20 degrees .* 9.5"
tells out "pass by pass"
ends 0 "$build/rt205" speedup -W 16 -H 10 --model cyber205-2pipe-prior
tells out "on the model cyber205-2pipe-prior; more by --provenance$"
tells out "on the model cyber720-prior; more by --provenance$"
ends 0 "$build/rt205" speedup -W 16 -H 10 --json both.json --format json
cmp -s out both.json
verdict $? "the JSON on stdout is not that of the file"
ends 0 "$build/rt205" speedup -W 16 -H 10 --json speedup.json
cmp -s speedup.json both.json
verdict $? "the JSON is not the same beside text"
ends 0 "$build/rt205" speedup -W 16 -H 10 --format csv --details
tells out "^# Table 1"
tells out "^# Cycle-accounted, .* on the model cyber205-2pipe; more by --provenance$"
tells out "^# Projected, .* on the model cyber720; more by --provenance$"
tells out "^# .* frame are equal"
tells out "^primitive,figures,scalar,"
tells out "^\"Steiner, ours\",ours,"
[ -z "$(sed "/^#/d; /^\$/d; /,/d" out)" ]
verdict $? "CSV has lines that are neither rows nor remarks"
ends 0 "$build/rt205" speedup -W 16 -H 10 --format md --details
tells out "^## Table 1"
tells out "^| sphere  *| error % |"
tells out "on the model cyber720; more by --provenance$"
tells out "frame are equal"
ends 0 "$build/rt205" speedup -W 40 -H 25 --formulations --json tried.json
tells out "^the paper  *2.729  *0.1614 "
tells out "^ours "
! grep -q "^sphere" out
verdict $? "Table 1 is printed beside the formulations"
grep -q "\"formulations\": \[" tried.json
verdict $? "tried.json has no formulations"
ends 2 "$build/rt205" speedup --format xml
tells err "text, csv, md or json"
for wrong in "--distance 0" "--distance inf" "--angle 180" "--angle x"; do
    # An option and its argument are words.
    # shellcheck disable=SC2086
    ends 2 "$build/rt205" speedup $wrong
done
ends 1 "$build/rt205" speedup --model nonsense
ends 1 "$build/rt205" speedup -W 16 -H 10 --json missing/speedup.json
ends 1 "$build/rt205" speedup -W 16 -H 10 --json missing/x --format json
[ ! -s out ]
verdict $? "JSON on stdout though the work failed"

ends 1 "$build/rt205" speedup --model cyber720
tells err "cyber720 is a projection"
[ ! -s out ]
verdict $? "speedup prints something of a model on which nothing runs"

# sweeps
sweep() {
    "$build/rt205" sweep "$@"
}
ends 0 sweep queue sphere -W 32 -H 32 --json queue.json
tells out ", 10 degrees across from a distance of 5;"
tells out "^ *1024  .*"
tells out "^Best: a queue of 1024"
tells out "on the model cyber205-2pipe; more by --provenance$"
tells out "frame are equal"
for key in points memory difference text causes; do
    grep -q "\"$key\": \[" queue.json
    verdict $? "queue.json has no $key"
done
grep -q '"angle": 10,' queue.json
verdict $? "queue.json does not tell the angle"
ends 0 sweep queue sphere -W 32 -H 32 --format json
cmp -s out queue.json
verdict $? "the JSON of a sweep on stdout is not that of the file"
ends 0 sweep queue "$scene" -W 32 -H 24 --points 1,10,700 --mode kernels
tells out "^  700 "
tells out "kept until the visible surface is known"
ends 0 sweep pipes steiner -W 16 -H 16 --format csv
tells out "vector, a queue of 2000, 16 x 16 rays"
tells out "^pipes,bits,hit_percent,"
tells out "^4,32,"
[ -z "$(sed "/^#/d; /^\$/d; /,/d" out)" ]
verdict $? "the CSV of a sweep has lines that are neither rows nor remarks"
ends 0 sweep hits torus -W 16 -H 16 --format md
tells out ", 37 degrees across from a distance of 5;"
tells out "^| *256 | *0 | *0.0 |"
tells out "^| *256 | *256 | *100.0 |"
ends 0 sweep length "$scene" --points 1,2,4,8,16,64
tells out "^Crossover: from a length of"
tells out "n-half"
if command -v gnuplot >/dev/null; then
    ends 0 sweep length sphere --points 1,2,4,8,64 -o "the plot.svg"
    for ending in svg dat gp; do
        [ -s "the plot.$ending" ]
        verdict $? "a sweep leaves no .$ending"
    done
fi
# Without gnuplot only the picture is missing.
ends 1 env PATH=missing "$build/rt205" sweep length sphere --points 1,2,4 \
    -o plain.svg --json plain.json
tells err "gnuplot is not found"
tells out "n-half"
for file in plain.json plain.dat plain.gp; do
    [ -s $file ]
    verdict $? "no $file, where only gnuplot is missing"
done
[ ! -e plain.svg ]
verdict $? "there is a picture though nothing drew it"
grep -q '"width"' plain.json
[ $? -eq 1 ]
verdict $? "a sweep of lengths tells the width of no frame"
ends 1 env PATH=missing "$build/rt205" sweep length sphere --points 1,2,4 \
    -o plain.svg --format json
cmp -s out plain.json
verdict $? "the JSON on stdout is lost with the plot"
ends 2 sweep
ends 2 sweep queue
tells err "SCENE|PRIMITIVE is missing"
ends 2 sweep queue sphere cylinder
tells err "too many arguments: cylinder"
ends 2 sweep sideways sphere
tells err "queue, pipes, hits or length"
ends 2 sweep queue cube
tells err "sphere, cylinder, Steiner, torus"
ends 2 sweep hits "$scene"
tells err "hits takes a primitive"
ends 2 sweep pipes sphere --points 1,2
tells err "are lengths"
ends 2 sweep queue sphere --queue 100
tells err "queue is for pipes and hits"
ends 2 sweep queue sphere -W 8 -H 8 --points 65
tells err "64 rays do not fill a queue of 65"
ends 2 sweep queue sphere --mode scalar
for points in 0 '1,' ',1' 2,1 1,1 1,65536 x 1,,2; do
    ends 2 sweep queue sphere --points $points
    tells err "points: wrong argument: $points"
done
ends 2 sweep pipes sphere -o both.svg --json ./both.dat
ends 1 sweep pipes sphere -o missing/plot.svg
ends 2 sweep pipes sphere -o plot.pdf
tells err "ends in .svg or .png"
ends 1 sweep pipes sphere --model nonsense
ends 1 sweep pipes sphere --model cyber720
tells err "cyber720 is a projection"
ends 1 sweep hits sphere -W 8 -H 8 --distance 900
tells err "sphere is too small in a frame"
ends 1 sweep pipes ./bad.pov
tells err 'bad.pov:3:'
ends 1 sweep pipes ./missing.pov

# how far to trust the figures: a line, or all of it
whole() { # COMMAND ..: with --provenance the rest of the line and more
    ends 0 "$@"
    tells out 'on the model cyber205-2pipe; more by --provenance$'
    ends 0 "$@" --provenance
    tells out 'on the model cyber205-2pipe,$'
    tells out 'fitted to 15 published figures, the largest error'
    tells out 'compared with 1 published figure,'
    tells out 'Not modelled: fetching instructions'
    tells out '77 constants: 10 from a primary source (P)'
    ends 0 "$@" --json model.json
    grep -q '"not_modelled": "fetching instructions' model.json
    verdict $? "the JSON tells not all of the model: $*"
}
printf '1,-10,35,-50,24\n' >four.csv
whole "$build/c205" run good.s
whole "$build/c205" time ADDNV
whole "$build/rt205" render "$scene" -o f.png -W 20 -H 15
whole "$build/rt205" profile "$scene" -W 8 -H 6
whole "$build/rt205" speedup -W 16 -H 10
whole "$build/rt205" sweep pipes sphere -W 16 -H 16
whole "$build/rt205" quartic four.csv
whole "$build/rt205" mass parts.pov --density default=1 --rays 512
ends 0 "$build/c205" model cyber205-2pipe
tells out 'compared with 1 published figure,'

# every result in every format, from and to streams
formats() { # COMMAND ..: its results as text, CSV, Markdown and JSON
    ends 0 "$@" --format csv
    [ -z "$(sed "/^#/d; /^\$/d; /,/d" out)" ] && grep -q , out
    verdict $? "CSV has lines that are neither rows nor remarks: $*"
    ends 0 "$@" --format md
    tells out '^|[:-]*-[:|-]*$'
    ends 0 "$@" --json beside.json
    cp out text
    ends 0 "$@" --format json
    cmp -s out beside.json
    verdict $? "--format json is not what --json writes: $*"
    ends 0 "$@" --json -
    cmp -s out beside.json
    verdict $? "--json - is not what --json writes: $*"
    ends 0 "$@" --format text
    cmp -s out text
    verdict $? "--format text is not the usual format: $*"
}
formats "$build/c205" run good.s
formats "$build/c205" run --check expects.s
formats "$build/c205" time --points ADDNV
formats "$build/c205" isa
formats "$build/c205" isa ADDNV
formats "$build/c205" model
formats "$build/c205" model cyber720
formats "$build/rt205" render "$scene" -o f.png -W 20 -H 15
formats "$build/rt205" render "$scene" -o f.png -W 20 -H 15 --accounts
formats "$build/rt205" render "$scene" -o f.png -W 20 -H 15 --profile
formats "$build/rt205" profile "$scene" -W 20 -H 15
formats "$build/rt205" speedup -W 16 -H 10
formats "$build/rt205" speedup -W 16 -H 10 --details --passes
formats "$build/rt205" sweep pipes sphere -W 16 -H 16
formats "$build/rt205" quartic four.csv
formats "$build/rt205" heat bay.pov --rays 64
formats "$build/rt205" quartic four.csv --falsi all
formats "$build/rt205" mass parts.pov --density default=1 --rays 512
ends 0 "$build/c205" run good.s --format csv
tells err '^1.5$'

pipes() { # WHAT: the last pipe went well
    verdict $? "$1"
}
"$build/c205" asm good.s -o - | cmp -s - good.o
pipes "an object on stdout is not that of the file"
"$build/c205" run - <good.o 2>err | grep -q '^1.5'
pipes "no program from stdin"
"$build/c205" run counting.s --limit 300 --save - 2>accounts \
    | "$build/c205" run --restore - 2>err | sed 1d | cmp -s - whole.counting
pipes "a machine saved to stdout does not go on from stdin"
grep -q 'saved as -$' accounts
pipes "the accounts are not on stderr where stdout is taken"
"$build/c205" model - <"$here/vm/models/cyber720.model" 2>err | grep -q '720'
pipes "no model from stdin"
"$build/rt205" render "$scene" -o - -W 40 -H 30 2>err | cmp -s - a.png
pipes "a picture on stdout is not that of the file"
checksum=$(grep checksum err)
"$build/rt205" render - -o b.png -W 40 -H 30 <"$scene" | grep -q "$checksum"
pipes "no scene from stdin"
"$build/rt205" quartic - <good.csv 2>err | grep -q '^2:$'
pipes "no polynomials from stdin"
"$build/rt205" sweep queue - --points 1,10 -W 16 -H 12 <"$scene" 2>err \
    | grep -q '^ *10 '
pipes "no scene to sweep from stdin"
ends 1 "$build/rt205" render "$scene" -o - -W 8 -H 6 --format json
tells err 'for the output or for JSON'
ends 2 "$build/rt205" render "$scene" -o - -W 8 -H 6 --json -
tells err '--output and --json name one file'
ends 2 "$build/c205" run - --restore -
tells err 'only one file can be -'
ends 2 "$build/rt205" render "$scene" -o a.png --resume -
tells err 'a file that has a name'

# several jobs: the same results in the same order
several() { # COMMAND ..: prints with --jobs 3 what it prints with 1
    ends 0 "$build/rt205" "$@" --jobs 1
    cp out alone
    ends 0 "$build/rt205" "$@" --jobs 3
    cmp -s out alone
    verdict $? "three jobs print something else: rt205 $*"
}
several speedup -W 16 -H 10 --format json
several speedup -W 16 -H 10 --formulations
several sweep queue torus -W 16 -H 12 --format json
several sweep hits sphere -W 16 -H 12
several sweep length "$scene" --points 1,2,8,64
several profile "$scene" -W 40 -H 30
several quartic good.csv --falsi all
several mass parts.pov --density default=1 --rays 512
several render "$scene" -o jobs.png -W 40 -H 30

# the order in which pixels go into queues
ordered() { # OPTION ..: the checksum of a frame
    "$build/rt205" render "$scene" -o order.png -W 60 -H 45 --json order.json \
        "$@" 2>err | grep checksum
}
ordered --mode scalar >whole
tells order.json '"order": "rows"'
for mode in vector kernels; do
    for order in rows tiles; do
        ordered --mode $mode --order $order | cmp -s - whole
        verdict $? "$mode by $order: another frame"
        tells order.json "\"order\": \"$order\""
    done
done
ordered --mode kernels | cmp -s - whole && tells order.json '"order": "rows"'
ordered | cmp -s - whole && tells order.json '"order": "tiles"'
ends 2 "$build/rt205" render "$scene" -o order.png --order spiral
tells err "--order: wrong argument: spiral"
ends 0 "$build/rt205" profile "$scene" -W 40 -H 30 --order tiles
ends 0 "$build/rt205" sweep queue "$scene" --points 1,50 -W 16 -H 12 --order tiles

# no adapter for pictures: told before a long frame, and nothing is left
mkdir alone.bin
cp "$build/rt205" alone.bin
begun=$(date +%s)
ends 1 env -u RT205_LIBDIR alone.bin/rt205 render "$scene" -o alone.png \
    -W 4000 -H 4000
tells err "pictures: no rt205_oiio.so in"
[ ! -e alone.png ] && [ $(($(date +%s) - begun)) -le 5 ]
verdict $? "a picture without its adapter"

# several rays a pixel
ends 0 "$build/rt205" render "$scene" -o samples.png -W 20 -H 15 --samples 3 \
    --json samples.json
tells out "20 x 15 of 3 x 3 rays, vector"
tells out "of 300 pixels hit"
tells samples.json '"samples": 3'
tells samples.json '"rays": 2700'
ends 0 "$build/rt205" profile "$scene" -W 20 -H 15 --samples 2
ends 2 "$build/rt205" render "$scene" -o samples.png --samples 17

# .. and of some pixels alone
ends 0 "$build/rt205" render "$scene" -o some.png -W 40 -H 30 --samples 3 \
    --threshold .2 --json some.json
tells out "threshold 0.2: .* rays of the camera, .* % of those of all samples"
tells some.json '"threshold": 0.2'
ends 0 "$build/rt205" profile "$scene" -W 20 -H 15 --samples 2 --threshold .5
ends 2 "$build/rt205" render "$scene" -o some.png --threshold .2
tells err "--threshold goes with --samples 2 or more"
ends 2 "$build/rt205" render "$scene" -o some.png --samples 3 --threshold 0
tells err "a number above 0"

# Ctrl-C in the middle of a long frame
"$build/rt205" render "$scene" -o long.png -W 4000 -H 3000 --mode scalar \
    >out 2>err &
sleep 1
[ "$(find "/proc/$!/task" -mindepth 1 -maxdepth 1 | wc -l)" -ge "$(getconf _NPROCESSORS_ONLN)" ]
verdict $? "not as many jobs as there are processors"
kill -INT $!
wait $!
[ $? -eq 1 ]
verdict $? "an interrupted render does not end with 1"
tells err 'stopped after'
tells err 'long.png has .* of 3000 rows, the others are black'
[ "$(find . -name '*long*')" = ./long.png ] && tail -c 8 long.png | grep -q IEND
verdict $? "an interrupted render leaves not one whole picture"

# ... of a scene that is long to lay out: each sphere once, and soon stopped
printf '#version 3.7;\ncamera { location -30*z } light_source { -30*z, 1 }\n%s' \
    '#for (I, 1, 100000) sphere { <mod(I, 317), I / 317, 0> / 20 - 8, .02 } #end' \
    >many.pov
"$build/rt205" render many.pov -o many.png -W 4000 -H 3000 \
    --resume many.kept >out 2>err &
sleep 6
kill -INT $!
begun=$(date +%s)
wait $!
[ $? -eq 1 ] && [ $(($(date +%s) - begun)) -le 5 ]
verdict $? "100,000 spheres do not stop soon"
ends 1 "$build/rt205" render many.pov -o many.png --resume good.csv
tells err "does not hold units of work"
printf '#version 3.7;\n' >none.pov
ends 0 "$build/rt205" render none.pov -o none.png -W 40 -H 30 --resume none.kept
tells err "the scene has no objects"
tells err "the frame begins: none.kept has no band yet"

# ... and of a sweep
"$build/rt205" sweep queue steiner --json long.json >out 2>err &
sleep 1
kill -INT $!
wait $!
[ $? -eq 1 ]
verdict $? "an interrupted sweep does not end with 1"
[ ! -s out ] && [ ! -e long.json ]
verdict $? "an interrupted sweep leaves results"

# Finished bands are kept, and gone on from
frame() { # OPTION ..: the checksum and the clocks of a frame
    "$build/rt205" render "$scene" -o bands.png -W 640 -H 480 "$@" 2>err \
        | grep -e checksum -e 'clocks,'
}
frame --jobs 1 >whole
frame | cmp -s - whole
verdict $? "as many jobs as there are processors make another frame"
frame --jobs 3 | cmp -s - whole
verdict $? "three jobs make another frame, or other clocks"
frame --resume bands.kept | cmp -s - whole
verdict $? "bands that are kept make another frame, or other clocks"
[ ! -e bands.kept ]
verdict $? "a finished frame leaves its bands"
"$build/rt205" render "$scene" -o bands.png -W 640 -H 480 --mode scalar \
    --resume bands.kept >out 2>err &
child=$!
tries=0
while [ "$(stat -c %s bands.kept 2>/dev/null || echo 0)" -lt 100 ] \
    && [ $((tries += 1)) -lt 200 ]; do
    sleep .1
done
kill -INT $child
wait $child
tells err 'goes on from bands.kept'
frame --mode scalar >serial
printf 'half a band' >>bands.kept
frame --mode scalar --resume bands.kept | cmp -s - serial
verdict $? "a frame that is gone on with differs from a whole one"
printf 'no bands' >other.kept
ends 1 "$build/rt205" render "$scene" -o bands.png --resume other.kept
tells err 'does not hold units of work'
ends 2 "$build/rt205" render "$scene" -o bands.png --resume bands.png
ends 2 "$build/rt205" render "$scene" -o bands.png --resume ./bands.png
ends 2 "$build/rt205" render "$scene" -o bands.png --jobs 0
tells err "--jobs: wrong argument: 0"

# The three stages side by side
ends 0 "$build/rt205" profile "$scene" -W 60 -H 45 --json profile.json
tells out 'visible surface'
tells out 'Amdahl'
tells out "^vector *+ rest  *100.0 "
tells profile.json '"kernels_clocks"'
tells out 'Millions of clocks'
for group in rays intersections surfaces 'the frame'; do
    tells out "^$group "
done
narrow "rt205 profile"
ends 0 "$build/rt205" profile "$scene" -W 60 -H 45 --format csv
tells out '^the frame,,[0-9]*,'
tells out '^part,kernel,scalar_clocks,'
! grep -q '^# Millions' out
verdict $? "CSV has rounded clocks"
ends 2 "$build/rt205" profile "$scene" -o picture.png
ends 2 "$build/rt205" quartic "$scene" --mode kernels

counted
