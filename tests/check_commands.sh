#!/bin/sh
# check_commands.sh BUILD - the commands as a user meets them: exit codes,
# where output goes, files written whole or not at all, Ctrl-C.
set -u
build=$(cd "$1" && pwd)
scene=$(pwd)/scenes/first.pov
kernels=$(pwd)/rt/kernels
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
passed=0 failed=0

verdict() { # STATUS TEXT
    if [ "$1" -eq 0 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAIL $2"
        sed 's/^/    /' "$work/err"
    fi
}

ends() { # CODE COMMAND ..: its exit code; what it prints goes to out and err
    wanted=$1
    shift
    "$@" >"$work/out" 2>"$work/err" </dev/null
    [ $? -eq "$wanted" ]
    verdict $? "exit code is not $wanted: $*"
}

tells() { # FILE TEXT: the last command's out or err holds the text
    grep -q -e "$2" "$work/$1"
    verdict $? "$1 does not say '$2'"
}

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
printf '#version 3.7;\ntorus { 1, .2 }\nsphere { 0, }\n' >bad.pov
printf '#version 3.7;\nsphere { 0, 1 pigment { granite } }\n' >replaced.pov
printf '#version 3.7;\nsphere { 0, 1e-310 }\n' >beyond.pov

# help and wrong usage
for command in c205 rt205; do
    ends 0 "$build/$command" --help
    ends 2 "$build/$command"
    ends 2 "$build/$command" nonsense
done
for command in run asm dis isa model time; do
    ends 0 "$build/c205" $command --help
    ends 2 "$build/c205" $command --nonsense
done
for command in render speedup; do
    ends 0 "$build/rt205" $command --help
    ends 2 "$build/rt205" $command --nonsense
done
ends 2 "$build/c205" run
ends 2 "$build/c205" run --limit many good.s
ends 2 "$build/c205" isa NOPE
ends 2 "$build/rt205" render "$scene"
ends 2 "$build/rt205" render "$scene" -o x.png -W 0
ends 2 "$build/rt205" render "$scene" -o x.png --queue 65536
ends 2 "$build/rt205" render "$scene" -o x.png --mode sideways
ends 2 "$build/rt205" render "$scene" -o x.png --half
ends 2 "$build/rt205" render "$scene" -o x.png --json x.png

# programs
ends 0 "$build/c205" run good.s
tells out '1.5'
tells out 'clocks'
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
ends 0 "$build/c205" isa ADDNV
tells out 'normalised'
ends 0 "$build/c205" model cyber205-4pipe
tells out 'startup.vadd'
ends 0 "$build/c205" time
tells out "^VXTOV "
tells out "^ACPSV "
tells out "^CNTOB "

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
sed 1d out | cmp -s - whole.accounts
verdict $? "a restored run ends with other accounts"
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
ends 0 "$build/c205" asm "$kernels/frame_vector.s" --define QUEUE=2000
ends 0 "$build/c205" asm "$kernels/frame_scalar.s"

# pictures
ends 0 "$build/rt205" render "$scene" -o a.png -W 40 -H 30 --json a.json
[ -s a.png ] && [ -s a.json ]
verdict $? "no picture, or no a.json"
cp a.png b.png
ends 0 "$build/rt205" render "$scene" -o b.png -W 40 -H 30
cmp -s a.png b.png
verdict $? "the same frame twice gives two pictures"
ends 1 "$build/rt205" render "$scene" -o a.gif -W 40 -H 30
ends 1 "$build/rt205" render "$scene" -o missing/a.png -W 40 -H 30
for ending in jpg exr tif; do
    ends 0 "$build/rt205" render "$scene" -o a.$ending -W 40 -H 30
    [ -s a.$ending ]
    verdict $? "no a.$ending"
done
ends 1 "$build/rt205" render missing.pov -o a.png
ends 1 "$build/rt205" render beyond.pov -o a.png
tells err "line 2"
ends 1 "$build/rt205" render bad.pov -o a.png
tells err 'bad.pov:2:'
tells err 'bad.pov:3:'
tells err '\^'
cmp -s a.png b.png
verdict $? "a failed render has changed the picture"
ends 0 "$build/rt205" render replaced.pov -o c.png -W 40 -H 30
tells err 'replaced.pov:2:'
ends 1 "$build/rt205" render replaced.pov -o c.png -W 40 -H 30 --strict

# Ctrl-C in the middle of a long frame
"$build/rt205" render "$scene" -o long.png -W 4000 -H 3000 --mode scalar \
    >out 2>err &
sleep 1
kill -INT $!
wait $!
[ $? -eq 1 ]
verdict $? "an interrupted render does not end with 1"
tells err 'stopped after'
[ -z "$(find . -name '*long*')" ]
verdict $? "an interrupted render left a file"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
