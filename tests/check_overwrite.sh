#!/bin/sh
# check_overwrite.sh BUILD - checks that no command overwrites one of its inputs. For
# every command, each option that names an output is given each file that the command
# reads (operands, included files, data, images, models). The file is named by the same
# path, another path, a symbolic link or a hard link. The command must fail, and all
# inputs must be unchanged. The same command must succeed with another output.
#
# Some variables consist of several words.
# shellcheck disable=SC2086
set -u
. "$(dirname "$0")/count.sh"
build=$(cd "$1" && pwd)
PATH=$build:$PATH
lesson=$(pwd)/docs/course/03-first-vector
fitted=$(pwd)/rt/study/fit
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
said=$work/said

# ---- Inputs, all with the suffix of the output -----------------------------------

texts() { # SUFFIX: writes the folder input
    rm -rf input
    mkdir input input/lesson input/class input/fit
    cat >"input/main.$1" <<END
        .include "part.$1"
        .data
list:   .incfile "list.$1"
        .code
        EX      r10, n
loop:   IS      r10, -1
        BGE     r10, r0, [r12]
        EXIT
; expect-model: ./input/machine.$1
; expect: r12 = loop
END
    printf '        .ifndef n\n        .equ n, 1\n        .endif\n%s\n' \
        '        EX r12, loop' >"input/part.$1"
    echo 1.5 >"input/list.$1"
    printf 'title A\nlike cyber205-2pipe\n' >"input/machine.$1"
    cat >"input/scene.$1" <<END
#version 3.7;
#include "world.$1"
camera { location <0, 0, -5> look_at 0 }
light_source { <-5, 9, -9>, 1 }
sphere { 0, 1 pigment { image_map { ppm "map.$1" } } part { "ball" density 1 temperature 300 emissivity .5 } }
END
    cp -n "input/scene.$1" input/scene.pov
    echo '#declare A = 1;' >"input/world.$1"
    printf 'P3 1 1 255 255 0 0\n' >"input/map.$1"
    echo '1,0,0,0,-1' >"input/quartics.$1"
    echo '1 2 ball' >"input/densities.$1"
    cp "$lesson"/*.* input/lesson
    cp "$lesson/solution.s" input/class/03-first-vector.s
}
programs='main part list machine' scenes='scene world map'

# ---- An output that is an input --------------------------------------------------

alias_number=0
another_name() { # FILE SUFFIX: sets name, each time by another method
    alias_number=$(((alias_number + 1) % 5))
    rm -f "other.$2"
    name=other.$2
    case $alias_number in
    0) name=$1 ;;
    1) name=./input/../$1 ;;
    2) name=$work/$1 ;;
    3) ln -s "$work/$1" "$name" ;;
    4) ln "$1" "$name" ;;
    esac
}
sums() {
    cksum input/*.* input/*/*.* 2>/dev/null
}
refuses() { # FILE ENDING OPTION COMMAND ..: must fail and change no input
    another_name "$1" "$2"
    output=$3 file=$1
    shift 3
    before=$(sums)
    ! "$@" "$output" "$name" >said 2>&1 </dev/null &&
        grep -Eq 'would overwrite the input|output of this command' said
    verdict $? "$* $output $name does not refuse to write over $file"
    expect "$* $output $name changes its inputs" [ "$(sums)" = "$before" ]
}
over() { # OPTION ENDING INPUTS COMMAND ..: tries each input as the output
    output=$1 ending=$2 inputs=$3
    shift 3
    texts "$ending"
    echo "$1 $2 $output" >>covered
    rm -f new.*
    "$@" "$output" "new.$ending" >said 2>&1 </dev/null
    verdict $? "$* $output new.$ending"
    for input in $inputs; do
        [ -f "input/$input" ] || input=$input.$ending
        refuses "input/$input" "$ending" "$output" "$@"
    done
}
small='-W 4 -H 3'
machine='--model ./input/machine'

over --json s "$programs" c205 run input/main.s $machine.s
over --json s "$programs" c205 run --check input/main.s
over --save s "$programs" c205 run input/main.s $machine.s --limit 40
over --output s 'main part list' c205 asm input/main.s
over --json s machine c205 isa ADDNV $machine.s
over --json s machine c205 model ./input/machine.s
over --json s machine c205 time ADDNV $machine.s
over --json s "$programs" c205 compare input/main.s input/main.s $machine.s
over --json s machine c205 compare input/main.s input/main.s --other-model ./input/machine.s
over --output svg "$programs" c205 timeline input/main.svg $machine.svg
over --output svg "$programs" c205 sweep input/main.svg $machine.svg --define n=1:3
over --json s "$programs" c205 sweep input/main.s $machine.s --define n=1:3
over --json s 'lesson/solution.s lesson/test-pixel.s' c205 check input/lesson input/lesson/solution.s
over --json s class/03-first-vector.s c205 check --folder input/class
over --output s lesson/start.s c205 check input/lesson --start

over --output png "$scenes machine" rt205 render input/scene.png $small $machine.png
over --resume pov "$scenes machine" rt205 render input/scene.pov -o x.png $small $machine.pov
over --json pov "$scenes machine" rt205 render input/scene.pov -o x.png $small $machine.pov
over --json pov "$scenes machine" rt205 profile input/scene.pov $small $machine.pov
over --json pov machine rt205 speedup sphere $small $machine.pov
sweep="rt205 sweep queue input/scene.pov $small --points 2"
over --output svg 'world map machine' $sweep $machine.svg
over --json pov "$scenes machine" $sweep $machine.pov
over --json csv 'quartics machine' rt205 quartic input/quartics.csv $machine.csv
over --output png "$scenes machine" rt205 heat input/scene.png --rays 8 --exchange $small $machine.png
for output in --json --resume; do
    over $output pov "$scenes machine" rt205 heat input/scene.pov --rays 8 $machine.pov
    over $output pov "$scenes densities machine" rt205 mass input/scene.pov --rays 8 \
        --densities input/densities.pov $machine.pov
done
over --output svg "$scenes machine" rt205 timeline input/scene.svg $small $machine.svg
for output in --json --write; do # a fit takes long
    texts csv
    cp -r "$fitted"/*.csv "$fitted/observations" "$fitted/programs" input/fit
    echo "fit205 - $output" >>covered
    for input in constants.csv observations/table1.csv; do
        refuses input/fit/$input csv $output fit205 --data input/fit --brief
    done
done

# A .png plot has another file with the same name and another suffix.
texts svg
for input in world map machine; do
    before=$(sums)
    ! $sweep $machine.svg -o input/$input.png >said 2>&1 &&
        grep -q 'output of this command' said
    verdict $? "a plot does not refuse to write over $input.svg"
    expect "a plot changes $input.svg" [ "$(sums)" = "$before" ]
done

# Stdin is an input, too.
texts s
before=$(sums)
# The command must not overwrite its stdin.
# shellcheck disable=SC2094
c205 asm - -o input/main.s <input/main.s >said 2>&1
[ $? -eq 1 ] && grep -q 'output of this command' said && [ "$(sums)" = "$before" ]
verdict $? 'the file that stdin is was written over'
# A file without contents may be both input and output. Two streams are not one file.
echo '        EXIT' | c205 asm - -o - >object.o
verdict $? 'stdin to stdout is refused'
c205 asm /dev/null -o /dev/null >said 2>&1
verdict $? '/dev/null to /dev/null is refused'
# A link to another file must remain, and the contents of that file must be replaced.
mkdir -p links/far
seq 10000 >links/far/old
ln -s far/old links/one
ln -s one links/two
c205 asm input/main.s -o links/two >said 2>&1
c205 asm input/main.s -o plain.o >said 2>&1
[ -L links/two ] && [ -L links/one ] && cmp links/far/old plain.o
verdict $? 'a link to an output is not followed'

# Checks all outputs that the programs list.
for program in c205 rt205 fit205; do
    "$program" help --list | awk -v program=$program '
        $1 == "option" && ($5 == "output" || $5 == "file") {
            print program, $2, $3
        }'
done | sort -u >listed
sort -u covered | comm -23 listed - >missing
said=$work/missing
expect 'outputs without a test' [ ! -s missing ]
counted
