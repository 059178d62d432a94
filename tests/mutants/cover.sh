#!/bin/sh
# cover.sh PLACE MAKE PART .. - measures which lines each part of make check executes.
#
# A part is GOAL or GOAL:VARIABLE=VALUE. PLACE/whole has the sources; they are built
# with the counters of gcov in PLACE/whole/cover. For each part PLACE/covered gets
#
#   PART.lines    FILE:LINE of each executed line, FILE of each file with such a line
#                 and of each text that is assembled
#   PART.seconds  the processor time of the part
#
# and `code`, all lines that have code. A part that was measured is not run again. A
# part that fails is reported and has no lines.
set -u
make=$2
covered=$1/covered
cd "$1/whole" || exit 1
shift 2
mkdir -p "$covered"
TEXTS_READ=$covered/texts
export TEXTS_READ

# Programs without the assembler have no source_find.
in_cover() { # GOAL ..
    timeout 3600 "$make" -s BUILD=cover OPT=-O1 CFLAGS=--coverage CXXFLAGS=--coverage JOBS=1 \
        LDFLAGS="--coverage -Wl,--wrap=source_find,--unresolved-symbols=ignore-all -no-pie \
            $TEXTS_READ.o" "$@" </dev/null
}

# Appends the lines with code to $1.
executed() { # FILE
    find cover -name '*.gcda' -exec gcov -t {} + 2>/dev/null | awk -v all="$1" '
        / 0:Source:/ {
            file = $0
            sub(/.*:Source:/, "", file)
            ours = file !~ /^(\/|tests\/|cover\/)/
        }
        ours && $0 !~ /^ *-:/ {
            split($0, part, ":")
            line = file ":" part[2] + 0
            print line >>all
            if (part[1] ~ /[0-9]/)
                print line "\n" file
        }'
}

texts() {
    sort -u "$TEXTS_READ" | while read -r name; do
        for folder in rt/kernels asm/lib; do
            [ ! -f "$folder/$name" ] || echo "$folder/$name"
        done
    done
}

measure() { # PART
    here=$covered/$(echo "$1" | tr / +)
    [ ! -e "$here.lines" ] || return
    find cover -name '*.gcda' -delete
    : >"$TEXTS_READ"
    # The words are a goal and its variable. The last line of "times" is that of ended
    # processes.
    # shellcheck disable=SC2046
    if ! (in_cover $(echo "$1" | tr : ' ') && times >"$here.times") >"$here.log" 2>&1; then
        echo "fails without a fault: $1"
        return
    fi
    tr 'ms' '  ' <"$here.times" | awk 'END { print 60 * ($1 + $3) + $2 + $4 }' >"$here.seconds"
    { executed "$covered/code" && texts; } | sort -u >"$here.new"
    sort -u -o "$covered/code" "$covered/code"
    mv "$here.new" "$here.lines"
}

${CC:-cc} -std=c99 -I. -c -o "$TEXTS_READ.o" tests/mutants/texts_read.c || exit 1
# Files without counters are not built again.
for folder in unit oracle fuzz; do
    mkdir -p "cover/tests/$folder"
    cp -p "build/tests/$folder"/*.o "cover/tests/$folder"
done
for part; do
    measure "$part"
done
[ -d "$covered/sources" ] || { mkdir "$covered/sources" && cp -Rp vm base asm rt web "$covered/sources"; }
