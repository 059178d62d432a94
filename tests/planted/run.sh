#!/bin/sh
# run.sh - plant each bug of bugs.list in a copy of the machine and see
# whether check_random finds it.
#
#   sh tests/planted/run.sh BUILD [programs]
#
# The copy, its objects and the outputs stay in BUILD/planted.
set -u

here=$(dirname "$0")
place=$1/planted
programs=${2:-20000}
found=0
missed=0
number=0

# Field 1 to 4 of bug $1: what it breaks, file, old text, new text.
field() {
    awk -v bug="$1" -v wanted="$2" '
        BEGIN { RS = ""; FS = "\n"; split("# = - +", marks, " ") }
        $2 !~ /^= / { next }
        ++n == bug {
            for (i = 1; i <= NF; i++)
                if (substr($i, 1, 1) == marks[wanted])
                    print substr($i, 3)
        }' "$here/bugs.list"
}

# The file with the text replaced; fails unless it stands there once.
plant() {
    old=$3 new=$4 awk '
        {
            at = index($0, ENVIRON["old"])
            if (at) {
                count++
                $0 = substr($0, 1, at - 1) ENVIRON["new"] \
                     substr($0, at + length(ENVIRON["old"]))
            }
            print
        }
        END { exit count != 1 }' "$1" > "$2"
}

build() {
    make -s -C "$place/source" BUILD=build OPT=-O1 \
        build/tests/oracle/check_random > "$place/make.txt" 2>&1
}

try() {
    if ! plant "$file" "$place/source/$file" "$old" "$new"; then
        verdict="stale: $file has other text now"
    elif ! build; then
        verdict="stale: does not compile"
    elif "$place/source/build/tests/oracle/check_random" "$programs" \
        --first > "$place/bug$number.txt" 2>&1; then
        verdict=missed
    else
        verdict=found
    fi
    cp "$file" "$place/source/$file"
}

mkdir -p "$place/source"
cp -R Makefile .ci vm base asm rt tests "$place/source"
build || { cat "$place/make.txt"; exit 1; }
if ! "$place/source/build/tests/oracle/check_random" 500; then
    echo "planted: they differ without a bug"
    exit 1
fi
while number=$((number + 1)); what=$(field $number 1); [ -n "$what" ]; do
    file=$(field $number 2)
    old=$(field $number 3)
    new=$(field $number 4)
    try
    printf '%-7s %s (%s)\n' "$verdict" "$what" "$file"
    [ "$verdict" = found ] && found=$((found + 1)) || missed=$((missed + 1))
done
echo "$found passed, $missed failed"
[ $missed -eq 0 ] && [ $found -ge 20 ]
