#!/bin/sh
# check_plurals.sh BUILD - checks that a count of one has a singular noun. The commands
# get inputs with one instruction, clock, element, pixel, ray, polynomial or breakpoint.
# Their output must not contain "1 clocks" or similar text.
set -u
. "$(dirname "$0")/count.sh"
build=$(cd "$1" && pwd)
lesson=$(pwd)/docs/course/01-numbers
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
PATH=$build:$PATH
said=$work/plurals

# Exceptions that are not plurals: the size of a picture, the number of a table, a verb.
allowed='x 1 rays|Table 1 lacks|part 1 of 1 is'
singular() { # COMMAND ..: checks its output and the files that it writes
    mkdir files
    "$@" >files/printed 2>&1 </dev/null
    sed -E "s/$allowed//g" files/* |
        grep -aoE '(^|[^0-9.,:/x-])1 [a-z]+s\b.*' >plurals
    expect "$*" [ ! -s plurals ]
    rm -r files
}

echo '        EXIT' >one.s
printf '        EXIT\n; expect-clocks: 1\n' >clock.s
printf '        .macro m a\n        .endm\n        m\n        m 1, 2\n' >macro.s
printf '        .data\n        .vector v, 0, 1\n' >vector.s
cat >element.s <<'END'
        .regs   r16, a, b
        .data
x:      .vector x, 1, 2.5
        .code
        EX      a, x
        ELEN    a, 1
        ADDNV   [a], [a], [a]
        LOD     [r0], b
        EXIT
END
sed '/LOD/d' element.s >vector_of_one.s
printf 'break 1\nstep\naccount\nwhy\ninfo breaks\nrun\ncontinue\nwhy\n%s\n' \
    'info breaks' >script

for format in text csv md json; do
    singular c205 run --warm one.s --format $format
    singular c205 run --warm one.s --profile --format $format
    singular c205 run --warm vector_of_one.s --profile --format $format
    singular c205 compare --warm one.s one.s --format $format
    singular c205 compare --warm one.s vector_of_one.s --format $format
done
singular c205 run --warm one.s --limit 1
singular c205 run --warm element.s
singular c205 run --check one.s clock.s
singular c205 debug one.s -x script
singular c205 debug element.s -x script
for file in one macro vector element; do
    singular c205 asm $file.s
done
for kind in svg kanata json; do
    singular c205 timeline --warm one.s -o files/one.$kind
    singular c205 timeline --warm vector_of_one.s -o files/one.$kind
done
singular c205 timeline --warm one.s --from 5 -o files/never.svg
singular c205 sweep vector.s --define n=1:2
singular c205 model
singular c205 model cyber205-2pipe --provenance
singular c205 check "$lesson" one.s

cat >one.pov <<'END'
#version 3.7;
camera { location <0, 0, -5> look_at 0 }
light_source { <-5, 9, -9>, 1 }
sphere { 0, 1 part { "ball" density 1 temperature 300 emissivity .5 } }
END
for scene in '#macro M(a) #end M()' 'sphere { <1>, 1 }' '#declare A = substr("a", 3, 1);' \
    'mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2> } normal_indices { 2, <0, 0, 0>, <0, 0, 0> } }'
do
    echo "$scene" >bad.pov
    singular rt205 render bad.pov -o files/bad.png
done
echo 1,0,0,0,-1 >one.csv
for mode in scalar kernels vector; do
    singular rt205 render one.pov -W 1 -H 1 -o files/one.png --mode $mode
    singular rt205 quartic one.csv --mode $mode
    singular rt205 heat one.pov --rays 1 --exchange --mode $mode
    singular rt205 mass one.pov --rays 1 --mode $mode
done
singular rt205 render one.pov -W 1 -H 1 -o files/one.png --samples 2 --threshold .5
singular rt205 heat one.pov --lines 1
singular rt205 profile one.pov -W 1 -H 1
singular rt205 speedup sphere -W 1 -H 1 --details
singular rt205 sweep queue one.pov -W 1 -H 1
singular rt205 render one.pov -W 1 -H 1 --part 1/1 --resume files/units
singular rt205 timeline one.pov -W 1 -H 1 -o files/one.svg
counted
