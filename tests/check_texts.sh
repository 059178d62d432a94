#!/bin/sh
# check_texts.sh BUILD [EVERY] - compares the readers of texts in all encodings.
#
# The programs, scenes, models, scripts and tables of the tests are rewritten in two
# forms: with CR as line ends, and with a byte order mark, CR LF, and the end mark of
# DOS files followed by further bytes. The output of the commands must be the same byte
# for byte, including errors with lines and columns. Every EVERY-th scene is rendered.
set -u
. "$(dirname "$0")/count.sh"
build=$(cd "$1" && pwd) every=${2:-80}
here=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
said=$work/err
: >"$said"
. "$here/tests/commands.sh"

forms="lf cr all"
rewrite() { # FORM FILE ..: rewrites the files in place
    form=$1
    shift
    case $form in
    cr) sed -i -z 's/\n/\r/g' "$@" ;;
    all) sed -i -z 's/^/\xEF\xBB\xBF/; s/\n/\r\n/g; s/$/\x1A\n} .nonsense "/' "$@" ;;
    esac
}

# ---- The texts ----

mkdir "$work/lf"
cd "$work/lf" || exit 1
mkdir programs scenes models answers scripts
cp "$here"/tests/programs/*.* "$here"/asm/examples/*.s "$here"/asm/examples/*.csv \
    "$here"/asm/examples/*.inc programs
cp "$here"/scenes/*.inc "$here"/tests/scenes/*.inc scenes 2>/dev/null
printf "%s\n" "$here"/scenes/*.pov "$here"/tests/scenes/*.pov |
    awk -v every="$every" 'NR % every == 1 % every' | xargs cp -t scenes
cp "$here"/vm/models/*.model models
cp -R "$here"/tests/lessons/01-scale lesson
cp lesson/solution.s answers/right.s
sed 's/^\( *\)mpyv/\1addv/' answers/right.s >answers/wrong.s
cp "$here"/tests/debugger/forty.lines scripts
printf '# quartics\n1, 0, -5, 0, 4\n2, 1, -1, 3, 4\n' >quartics.csv
cp "$here"/rt/study/fit/*.csv . 2>/dev/null
printf '# g/cm^3\n1 2.5 Part\n2 1 "Other"\n' >densities
printf '1, <2, 3, 4>,\n"text",\n5\n' >numbers
printf '#declare Part = sphere { 0, 1 }\n' >part.inc
cat >read.pov <<'END'
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
light_source { <4, 7, -9>, 1 }
#include "part.inc"
#fopen F "numbers" read
#while (defined(F))
    #read (F, A, B, C, D)
    #debug concat(str(A, 0, 0), " ", vstr(3, B, " ", 0, 0), C, "\n")
#end
object { Part pigment { rgb <1, .3, .2> } translate 1/D
}
END
# Adds faults to the lines of a text, one in each third.
broken() { # TEXT FAULT
    awk -v fault="$2" '{ print } NR % 9 == 4 { print "  " fault }' "$1"
}
broken programs/sieve.s 'addx r1, , r2 ; "' >broken.s
broken read.pov "sphere { 0 }" >broken.pov
broken models/cyber205-2pipe.model 'latency.load many' >broken.model
broken scripts/forty.lines 'print )' >broken.lines
printf '1, 2, 3\nx, 5\n1, 2, 3, 4, 5\n' >broken.csv
sed 's/print.s/missing.s/' programs/first.s >missing.s

cd "$work" || exit 1
for form in $forms; do
    [ "$form" = lf ] && continue
    cp -R lf "$form"
    find "$form" -type f | {
        set --
        while read -r file; do
            set -- "$@" "$file"
        done
        rewrite "$form" "$@"
    }
done

# ---- Output of the commands ----

print_all() { # prints all output of the commands for the texts in this folder
    c205=$build/c205 rt205=$build/rt205
    "$c205" run --check programs/*.s
    "$c205" asm programs/tables.s -o out --listing - && cat out
    "$c205" asm broken.s -o never
    "$c205" asm missing.s -o never
    "$c205" run out
    "$c205" run programs/lookup.s --profile
    "$c205" sweep programs/sieve.s --define limit=100:200:100
    for model in models/*.model broken.model; do
        "$c205" model "./$model"
    done
    "$c205" check lesson
    for answer in answers/*.s broken.s; do
        "$c205" check lesson "$answer"
    done
    for script in scripts/forty.lines broken.lines; do
        "$c205" debug programs/sieve.s -x "$script"
        "$c205" debug programs/sieve.s <"$script"
    done
    "$c205" debug programs/tables.s <<'END'
break 20
list
info break
run
list 1,40
END
    "$rt205" quartic quartics.csv
    "$rt205" quartic broken.csv
    "$rt205" mass read.pov --densities densities --rays 4
    "$rt205" render broken.pov -o never.png -W 4 -H 3
    for scene in read.pov scenes/*.pov; do
        "$rt205" render "$scene" -W 8 -H 6 -o out.png
    done
}
for form in $forms; do
    (cd "$form" && print_all >../out 2>&1)
    mv out "$form.out"
    cmp -s lf.out "$form.out"
    verdict $? "texts in the form $form are not read like those in the form lf"
    diff -a lf.out "$form.out" | head -n 5
done
grep -q 'PASS programs/sieve.s' lf.out && grep -q 'broken.s:5:' lf.out &&
    grep -q 'broken.pov:5:' lf.out
verdict $? "the texts are not read at all"

# ---- UTF-16 ----

cat >one.s <<'END'
; An answer
        .code
        EXIT
END
utf16() { # ORDER [MARK]: stdin as UTF-16
    printf %b "${2:-}"
    od -An -v -t o1 | tr -s ' ' '\n' | while read -r byte; do
        case $byte:$1 in
        :*) ;;
        *:little) printf %b'\0' "\\0$byte" ;;
        *:big) printf '\0'%b "\\0$byte" ;;
        esac
    done
}
for order in little big; do
    for mark in '' with; do
        case $order$mark in
        littlewith) mark='\0377\0376' ;;
        bigwith) mark='\0376\0377' ;;
        esac
        for name in program.s scene.pov table.csv bare.model; do
            utf16 "$order" "$mark" <one.s >"$name"
        done
        for call in "c205 run program.s" "c205 debug lf/programs/sieve.s -x program.s" \
            "c205 run lf/programs/sieve.s --model bare.model" \
            "c205 check lf/lesson program.s" \
            "rt205 render scene.pov -o never.png" "rt205 quartic table.csv"; do
            # The words form a command.
            # shellcheck disable=SC2086
            ends 1 "$build/"$call
            tells err 'UTF-16'
            expect "more than one line says that it is UTF-16" [ "$(wc -l <err)" -eq 1 ]
        done
        printf '        .include "program.s"\n        .code\n EXIT\n' >outer.s
        ends 1 "$build/c205" run outer.s
        tells err 'outer.s:1:18: error: cannot read .program.s.: .*UTF-16'
        printf '#include "scene.pov"\n' >outer.pov
        ends 1 "$build/rt205" render outer.pov -o never.png
        tells err 'outer.pov:1:10: error: .*UTF-16'
    done
done

# ---- Names that a terminal would execute ----

rm -rf names
mkdir names
cd names || exit 1
# The name contains a title, a colour, an overwritten line, and a reversed direction.
name=$(printf 'a\033]0;t\007\033[31m\302\233\r\233\342\200\256')
safe() { # COMMAND ..: its output contains no terminal commands
    "$@" >"$work/out" 2>"$work/err" </dev/null
    tr -d '\n\t' <"$work/out" | cat - "$work/err" | tr -d '\n\t' |
        LC_ALL=C grep -aq -e '[[:cntrl:]]' \
            -e "$(printf '\302[\200-\237]')" -e "$(printf '\342\200\256')"
    [ $? -eq 1 ]
    verdict $? "a terminal obeys what is printed: $(printf '%s ' "$@" | tr -d '[:cntrl:]')"
}
c205=$build/c205 rt205=$build/rt205
cp ../lf/programs/saxpy_vector.s "$name.s"
cp ../lf/models/cyber205-2pipe.model "$name.model"
cp ../lf/read.pov "$name.pov"
cp ../lf/part.inc ../lf/numbers .
cp ../lf/quartics.csv "$name.csv"
cp -R ../lf/lesson "$name"
mkdir class
cp ../lf/answers/wrong.s "class/$name.s"
printf '        .code ; %s\n        %s\n        EXIT\n' "$name" "$name" >"bad$name.s"
printf '#debug "%s\\n" #warning "%s" #error "%s"\n' "$name" "$name" "$name" >"bad$name.pov"
printf '#include "%s.inc"\n sphere { %s }\n' "$name" "$name" >"worse$name.pov"
printf '%s;1\n' "$name" >"bad$name.csv"
printf 'title %s\n%s 5\n' "$name" "$name" >"bad$name.model"
printf 'list\nprint %s\nbreak %s:3\nrun\nwhere\n' "$name" "$name" >"$name.lines"
for file in "$name.s" "bad$name.s" "no$name.s"; do
    for verb in run asm debug "run --check" "run --profile" timeline compare sweep \
        "asm --listing" dis "check $name"; do
        # The words belong to one command.
        # shellcheck disable=SC2086
        safe "$c205" $verb "$file"
    done
    safe "$c205" check "$name" "$file"
    safe "$c205" compare "$file" "$file"
    safe "$c205" timeline "$file" -o "$name.svg"
    safe "$c205" timeline "$file" -o "no$name/a.svg"
    safe "$c205" sweep "$file" --define "$name=1:2"
    safe "$c205" run "$file" --json "no$name/a.json" --define "$name=1"
    safe "$c205" run "$file" --save "$name.saved" --limit 20
    safe "$c205" run "$file" --model "$name.model"
    safe "$c205" run "$file" --model "bad$name.model"
    safe "$c205" debug "$file" -x "$name.lines"
done
safe "$c205" check ../lf/lesson --folder class
safe "$c205" check ../lf/lesson --folder class --format csv
safe "$c205" check ../lf/lesson --folder class --format md
safe "$c205" check ../lf/lesson --folder class --format json
safe "$c205" model "$name"
safe "$c205" isa "$name"
safe "$c205" "$name"
safe "$c205" run "--$name" x
safe "$c205" run --warn "$name" x
safe "$c205" help "$name"
for file in "$name.pov" "bad$name.pov" "worse$name.pov" "no$name.pov"; do
    safe "$rt205" render "$file" -W 2 -H 2 -o "$name.png"
    safe "$rt205" render "$file" -W 2 -H 2 -o "$name"
    safe "$rt205" render "$file" -W 2 -H 2 -o "no$name/a.png"
    safe "$rt205" render "$file" -W 2 -H 2 -o a.png --resume "$name.kept"
    safe "$rt205" mass "$file" --rays 4 --density "$name=2"
done
safe "$rt205" quartic "$name.csv" --json "$name.json"
safe "$rt205" quartic "bad$name.csv"
safe "$rt205" heat "$name.pov" --from "$name"
safe "$rt205" timeline "bad$name.pov" -o "$name.svg"
safe "$rt205" sweep "$name"
cd "$work" || exit 1

counted
