#!/bin/sh
# check_commands.sh BUILD - checks commands as a user calls them: exit codes, output
# streams, complete files and Ctrl-C. Most checks are rows of commands.txt.
set -u
. "$(dirname "$0")/count.sh"
build=$(cd "$1" && pwd)
here=$(pwd)
scene=$here/scenes/first.pov
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

narrow() { # COMMAND: prints no long lines, except names of files
    [ -z "$(awk -v here="$here" 'length > 100 && !index($0, here)' out)" ]
    verdict $? "lines of more than 100 characters: $1"
}

# Checks help and wrong usage of every command and option that the programs list.
for program in c205 rt205; do
    ends 0 "$build/$program" --help
    cp out summary
    ends 0 "$build/$program" -h
    expect "$program -h is not --help" cmp -s out summary
    ends 0 "$build/$program" help
    expect "$program help is not --help" cmp -s out summary
    ends 2 "$build/$program"
    ends 2 "$build/$program" nonsense
    tells err 'unknown command .nonsense.'
    ends 2 "$build/$program" help nonsense
    tells err 'unknown command .nonsense.'
done
for program in c205 rt205 fit205; do
    ends 0 "$build/$program" --version
    tells out "^$program [0-9.]*$"
    ends 0 "$build/$program" help --list
    cp out "$program.list"
    ends 2 "$build/$program" help --nonsense
    ends 2 "$build/$program" help --completion tcsh
done

names() { # checks that the help of the command has every option and operand
    while read -r what its_command name letter kind choices; do
        [ "$what" != command ] || continue
        [ "$its_command" = "$command" ] || continue
        tells help.txt "$name"
        case $what$kind in
        optionflag | operand*) ;;
        *) tells help.txt "$name [^ ]" ;; # the placeholder of the value of the option
        esac
        [ "$letter" = - ] || tells help.txt "^  -$letter, $name"
        for choice in $choices; do
            tells help.txt "$choice"
        done
    done <"$program.list"
}
refuses() { # ARGUMENT ..: reports wrong usage, with the choices and a reference to the help
    # An empty word means no argument.
    # shellcheck disable=SC2086
    ends 2 "$build/$program" $word "$@"
    tells err "$program $word${word:+ }--help prints the usage"
    expect "wrong usage prints on stdout: $*" [ ! -s out ]
}
wrong_values() { # checks for each option an invalid value and a missing value
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
        tells err "$name: expected"
        refuses "$name"
        tells err "$name requires an argument"
        near=${name%?}${name#"${name%?}"}x
        refuses "$near" 1
        tells err "unknown option $near"
    done <"$program.list"
}
for program in c205 rt205 fit205; do
    while read -r what command rest; do
        [ "$what" = command ] || continue
        word=$command
        [ "$command" = - ] && word=
        # An empty word means no argument.
        # shellcheck disable=SC2086
        ends 0 "$build/$program" $word --help
        cp out help.txt
        expect "$program $word --help prints on stderr" [ ! -s err ]
        # shellcheck disable=SC2086
        ends 0 "$build/$program" $word -h
        expect "$program $word -h is not --help" cmp -s out help.txt
        if [ -n "$word" ]; then
            ends 0 "$build/$program" help "$word"
            expect "$program help $word is not --help" cmp -s out help.txt
            ends 2 "$build/$program" "${word}x"
            tells err "did you mean '$word'?"
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
rows usage
# The account, a message and the trace each begin on a new line, even if the program has
# not ended its last line. No empty line is added.
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
# A profile, line by line.
rows profile

# A comparison of two programs.
matrix=$here/asm/examples/profiling/matrix
"$build/c205" compare "${matrix}_3.s" "${matrix}_4.s" --format csv |
    awk -F, '$1 == "all" { print first == $2 && second == $3 ? $2 " " $3 : "off" }
             NF == 5 { first += $2; second += $3 }' >summed
for number in 3 4; do
    "$build/c205" run "${matrix}_$number.s" | sed -n 's/ clocks, .*//p'
done | paste -s -d ' ' | cmp -s - summed
verdict $? "compare has other clocks than run"
rows compare

# A timeline, clock by clock.
for kind in svg kanata json; do
    ends 0 "$build/c205" timeline good.s -o run.$kind
    tells out "^run.$kind: [0-9]* instructions, clocks 0 to "
done
tells run.svg "^</svg>$"
tells run.kanata "^Kanata.0004$"
tells run.json "^]}$"
rows timeline

# A sweep over a constant.
saxpy=$here/asm/examples/saxpy
rows sweep_picture
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
rows sweep

# A value takes some tenths of a second, so all values would take long.
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

# An empty program is reported as empty.
: >empty.s
printf '        .data\nv:      .word   1\n' >data.s
for file in empty.s data.s; do
    for verb in run debug "run --check" "sweep --define n=1:2"; do
        # The words belong to one command.
        # shellcheck disable=SC2086
        ends 1 "$build/c205" $verb "$file"
        cat err >>out
        tells out "the program is empty"
    done
done

# A sweep that fails reports the place.
rows debug
{ echo continue; sleep 2; echo "print clock > 1000"; } |
    "$build/c205" debug endless.s >out 2>err &
sleep 1
kill -INT $!
wait $!
[ $? -eq 1 ]
verdict $? "Ctrl-C ends the debugger, or an interrupted script succeeds"
tells out "^interrupted$"
tells out "^1  X.1.$"
rows objects
narrow "c205 isa"
"$build/c205" isa --names >names
awk 'NR > 1 && !/^ / { print $1 }' out | cmp -s - names
verdict $? "not a row of each instruction"
# The list consists of names.
# shellcheck disable=SC2046
ends 0 "$build/c205" isa $(cat names)
narrow "c205 isa MNEMONIC"
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

# Wrong arguments of commands are rejected.
rows arguments
for define in NAME =1 NAME=x; do
    ends 2 "$build/c205" run --define $define good.s
    tells err "expected NAME=VALUE, .*, found .$define.$"
done
# Invalid or unused names of constants, in every command that takes them.
for define in "a b" r5 h255 ADDN 3x .code "" unused; do
    code=1
    [ "$define" ] || code=2
    for command in run asm dis debug "timeline -o defined.svg" "run --check" \
        "compare --other-model cyber205-1pipe"; do
        # The words are a command and its options.
        # shellcheck disable=SC2086
        ends $code "$build/c205" $command flat.s --define k=1 --define "$define=1" \
            </dev/null
        cat out >>err
        tells err "'$define' \(is defined, but the program does not use it\|cannot be defined: it is\)\|expected NAME=VALUE"
    done
    ends $code "$build/c205" sweep flat.s --define k=1:9 --define "$define=1"
    ends $code "$build/c205" sweep flat.s --define "$define=1:9" --define k=1
done
rows missing
if [ -e /dev/full ]; then
    "$build/c205" isa >/dev/full 2>err
    [ $? -eq 1 ]
    verdict $? "a full disc is not noticed"
    tells err 'write error'
fi

# Every table as a file.
for command in 'run good.s' 'run --check expects.s' 'isa' 'isa ADDNV' \
    'isa --names' 'model' 'model cyber205-1pipe' 'time ADDNV TRIAD'; do
    rm -f table.json
    # The words are a command and its arguments.
    # shellcheck disable=SC2086
    ends 0 "$build/c205" $command --json table.json
    [ "$(head -c 1 table.json)" = '{' ] && [ "$(tail -c 2 table.json)" = '}' ]
    verdict $? "c205 $command --json: no table"
    # shellcheck disable=SC2086
    ends 1 "$build/c205" $command --json missing/table.json
done
rows tables
printf '        EX r10, 64\n        ELEN r10, 8\n%s' \
    '        EXIT r10, r0, 4
        EXIT
' >nowhere.s
rows run_check
"$build/c205" run --no-limit endless.s >out 2>err &
sleep 1
kill -TERM $!
wait $!
[ $? -eq 1 ]
verdict $? 'an interrupted run does not end with 1'
tells err 'interrupted; these are the accounts'
tells out 'clocks'

# Warnings of a text and of a run: disabled, and as errors.
rows warnings
for mode in scalar vector; do
    ends 0 "$build/rt205" quartic good.csv --mode $mode
    grep -v '^#' out >$mode.roots
    tells out '^# 4 polynomials, 8 roots; '$mode
    tells out '^# root_solver '
done
rows quartic
for mode in scalar kernels vector; do
    ends 0 "$build/rt205" heat bay.pov --rays 200 --repeats 3 --mode $mode
    sed "/^Where/,\$d" out >$mode.factors
    expect "scalar form and $mode find other factors" cmp -s scalar.factors $mode.factors
done
tells out "^1 *environment  0\.[34]"
rows heat
for wish in --stages --smooth --exchange "--tolerance .1" "-o hits.png"; do
    # An option and its value are two words.
    # shellcheck disable=SC2086
    ends 2 "$build/rt205" heat bay.pov --hits --from 1 $wish
    tells err "hits cannot be combined with"
done
rows uses
ends 0 env RT205_LIBDIR=missing "$build/rt205" render "$scene" --no-picture \
    -W 40 -H 30
expect "rt205 render --no-picture tells something else" cmp -s pictured out
expect "the same frame twice gives two pictures" cmp -s a.png b.png
# A pixel in the debugger.
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
tells out '^error: unknown verb .stpe.; did you mean .step..$'
ends 1 "$build/rt205" render "$scene" -W 40 -H 30 --debug 20,15 --samples 2
tells err 'a pixel of this frame has 2 x 2 rays: only a pixel with one ray can be followed$'
ends 2 "$build/rt205" render "$scene" -W 40 -H 30 --debug 40,15
ends 2 "$build/rt205" render "$scene" --no-picture -x pixel.lines
# A queue of the pixel, clock by clock.
for kind in svg kanata json; do
    ends 0 "$build/rt205" timeline "$scene" -W 40 -H 30 -o queue.$kind
    tells out "^queue.$kind: [0-9]* instructions, clocks [0-9]* to [0-9]* of band 1 of 1$"
done
tells queue.svg "vector, the queue of pixel 20,15 of 40 x 30, clocks "
rows frame_timeline
for ending in jpg exr tif; do
    ends 0 "$build/rt205" render "$scene" -o a.$ending -W 40 -H 30
    expect "no a.$ending" [ -s a.$ending ]
done
dated() { # DATE: sets the date of a.exr
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
expect "the same frame a second later is another file" cmp -s a.exr b.exr
ends 0 env SOURCE_DATE_EPOCH=86400 "$build/rt205" render "$scene" -o a.exr \
    -W 40 -H 30
dated '1970:01:02 00:00:00'
verdict $? "a picture lacks the date of SOURCE_DATE_EPOCH"
ends 0 env SOURCE_DATE_EPOCH=today "$build/rt205" render "$scene" -o a.exr \
    -W 40 -H 30
rows render

# Sweeps.
sweep() {
    "$build/rt205" sweep "$@"
}
rows sweep_views
ends 0 sweep length sphere --points 1,2,4,8,64 -o "the plot.svg"
grep -q '^</svg>$' "the plot.svg"
verdict $? "a sweep draws a plot"
# Without rsvg-convert, only the picture in PNG is missing.
ends 1 env PATH=missing "$build/rt205" sweep length sphere --points 1,2,4 \
    -o plain.png --json plain.json
tells err "rsvg-convert is not found"
tells out "n-half"
for file in plain.json plain.svg; do
    expect "no $file, where only rsvg-convert is missing" [ -s $file ]
done
expect "there is a picture though nothing made it" [ ! -e plain.png ]
grep -q '"width"' plain.json
[ $? -eq 1 ]
verdict $? "a sweep of lengths tells the width of no frame"
ends 1 env PATH=missing "$build/rt205" sweep length sphere --points 1,2,4 \
    -o plain.png --format json
rows sweep_errors
for points in 0 '1,' ',1' 2,1 1,1 1,65536 x 1,,2; do
    ends 2 sweep queue sphere --points $points
    tells err "points: expected .*, found .$points.$"
done
rows sweep_models

# The accuracy of the figures, in one line and in full.
whole() { # COMMAND ..: the line continues with --provenance
    ends 0 "$@"
    tells out 'on the model cyber205-2pipe; details: --provenance$'
    ends 0 "$@" --provenance
    tells out 'on the model cyber205-2pipe,$'
    tells out 'fitted to 15 published figures, the largest error'
    tells out 'compared with 1 published figure,'
    tells out 'Not modelled: instruction fetch'
    tells out '77 constants: 10 from a primary source (P)'
    ends 0 "$@" --json model.json
    grep -q '"not_modelled": "instruction fetch' model.json
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

# Checks every result in every format, from and to streams.
formats() { # COMMAND ..: prints its results as text, CSV, Markdown and JSON
    ends 0 "$@" --format csv
    [ -z "$(sed "/^#/d; /^\$/d; /,/d" out)" ] && grep -q , out
    verdict $? "CSV has lines that are neither rows nor remarks: $*"
    ends 0 "$@" --format md
    tells out '^|[:-]*-[:|-]*$'
    ends 0 "$@" --json beside.json
    cp out text
    ends 0 "$@" --format json
    expect "--format json is not what --json writes: $*" cmp -s out beside.json
    ends 0 "$@" --json -
    expect "--json - is not what --json writes: $*" cmp -s out beside.json
    ends 0 "$@" --format text
    expect "--format text is not the usual format: $*" cmp -s out text
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

pipes() { # WHAT: checks that the last pipe succeeded
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
rows streams

# Several jobs must give the same results in the same order.
several() { # COMMAND ..: --jobs 3 prints the same as --jobs 1
    ends 0 "$build/rt205" "$@" --jobs 1
    cp out alone
    ends 0 "$build/rt205" "$@" --jobs 3
    expect "three jobs print something else: rt205 $*" cmp -s out alone
}
several speedup -W 16 -H 10 --format json
several speedup -W 16 -H 10 --formulations
several sweep queue torus -W 16 -H 12 --format json
several sweep hits sphere -W 16 -H 12
several sweep length "$scene" --points 1,2,8
several profile "$scene" -W 40 -H 30
several quartic good.csv --falsi all
several mass parts.pov --density default=1 --rays 512
several render "$scene" -o jobs.png -W 40 -H 30

# The order of pixels in queues must not change the frame.
ordered() { # OPTION ..: prints the checksum of a frame
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
tells err "--order: expected .*, found .spiral."
ends 0 "$build/rt205" profile "$scene" -W 40 -H 30 --order tiles
ends 0 "$build/rt205" sweep queue "$scene" --points 1,50 -W 16 -H 12 --order tiles

# A missing library for pictures must be reported before a long frame begins, and no
# file may remain.
mkdir alone.bin
cp "$build/rt205" alone.bin
ends 1 env -u RT205_LIBDIR timeout 60 alone.bin/rt205 render "$scene" -o alone.png \
    -W 8000 -H 8000
tells err "pictures: no rt205_oiio.so in"
rows samples

# Ctrl-C during a long frame.
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

# Ctrl-C stops a program soon while it lays out a scene with many spheres, and while it
# traces the scene on a fast machine. The frame is too large to be complete by then.
printf '#version 3.7;\ncamera { location -30*z } light_source { -30*z, 1 }\n%s' \
    '#for (I, 1, 100000) sphere { <mod(I, 317), I / 317, 0> / 20 - 8, .02 } #end' \
    >many.pov
times >begin
"$build/rt205" render many.pov -o many.png -W 2000 -H 8000 \
    --resume many.kept >out 2>err &
sleep 2
ticks=$(cut -d ' ' -f 14,15 "/proc/$!/stat")
kill -INT $!
wait $!
code=$?
times >end
[ $code -eq 1 ]
verdict $? "an interrupted render of 100,000 spheres ends with $code"
# The second line of times is the processor time of children, as in 1m2.5s.
awk -v ticks="$ticks" -v rate="$(getconf CLK_TCK)" '
    FNR == 2 {
        split($1 "m" $2, part, /[ms]+/)
        spent = 60 * (part[1] + part[3]) + part[2] + part[4] - spent
    }
    END {
        split(ticks, until, " ")
        spent -= (until[1] + until[2]) / rate
        print spent " s of processor time after Ctrl-C"
        exit spent > 5
    }' begin end >out
verdict $? "100,000 spheres do not stop soon: $(cat out)"
ends 1 "$build/rt205" render many.pov -o many.png --resume good.csv
tells err "does not hold units of work"
printf '#version 3.7;\n' >none.pov
ends 0 "$build/rt205" render none.pov -o none.png -W 40 -H 30 --resume none.kept
tells err "the scene has no objects"
tells err "the frame starts: none.kept has no band yet"

# Ctrl-C during a sweep.
"$build/rt205" sweep queue steiner --json long.json >out 2>err &
sleep 1
kill -INT $!
wait $!
[ $? -eq 1 ]
verdict $? "an interrupted sweep does not end with 1"
[ ! -s out ] && [ ! -e long.json ]
verdict $? "an interrupted sweep leaves results"

# Finished bands must be saved, and a later run must continue from them.
frame() { # OPTION ..: prints the checksum and the clocks of a frame
    "$build/rt205" render "$scene" -o bands.png -W 640 -H 480 "$@" 2>err \
        | grep -e checksum -e 'clocks,'
}
frame --jobs 1 >whole
rows bands
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
tells err 'continues from bands.kept'
frame --mode scalar >serial
printf 'half a band' >>bands.kept
frame --mode scalar --resume bands.kept | cmp -s - serial
verdict $? "a frame that is gone on with differs from a whole one"
rows kept_bands
for group in rays intersections surfaces 'the frame'; do
    tells out "^$group "
done
narrow "rt205 profile"
ends 0 "$build/rt205" profile "$scene" -W 60 -H 45 --format csv
tells out '^the frame,,[0-9]*,'
tells out '^part,kernel,scalar_clocks,'
expect "CSV has rounded clocks" ! grep -q '^# Millions' out
ends 2 "$build/rt205" profile "$scene" -o picture.png
ends 2 "$build/rt205" quartic "$scene" --mode kernels

counted
