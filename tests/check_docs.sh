#!/bin/sh
# check_docs.sh BUILD quick|full [--write] PAGE .. - compares the printed blocks of
# pages with the output of commands. In a page, a comment
#
#     <!-- printed by: COMMAND -->        (or: <!-- printed slowly by: COMMAND -->)
#
# precedes an indented block, which must be the output of the command. In the shell, the
# programs of the build are first in the path, and BUILD is the folder of the build. The
# part of the command before the first pipe runs once for all blocks. Pictures in the
# folder DRAWN must equal the pictures in docs/pictures with the same names. The command
# is printed below the block (printed_by.awk).
#
# The pages must have none of the faults that page_faults.awk lists. Each kind of fault
# is planted in a copy of the pages and must be found.
#
# quick skips slow commands, which take more than about two seconds. --write writes the
# output into the pages and replaces the pictures.
set -u
. "$(dirname "$0")/count.sh"
BUILD=$(cd "$1" && pwd) size=$2
shift 2
write=
if [ "${1:-}" = --write ]; then
    write=$1
    shift
fi
cd "$(dirname "$0")/.." || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
said=$work/diff
DRAWN=$work/drawn
PATH=$BUILD:$PATH
export BUILD DRAWN PATH
mkdir "$DRAWN"

# Writes the output of a command line to $work/out.
print() {
    first=${1%%" | "*}
    key=$(printf '%s' "$first" | cksum | tr ' ' _)
    [ -f "$work/$key" ] || sh -c "$first" >"$work/$key" 2>&1
    case $1 in
    *" | "*) sh -c "${1#*" | "}" <"$work/$key" >"$work/out" 2>&1 ;;
    *) cp "$work/$key" "$work/out" ;;
    esac
    sed -i 's/[ ]*$//' "$work/out"
}

# Splits a page: blocks go to files block1, block2 and so on, their commands to
# `commands`, and other lines to `page`, with a line "@N" for each block.
cut_blocks() {
    awk -v work="$work" -v size="$size" '
        /^<!-- printed( slowly)? by: .* -->$/ {
            if (inside)
                printf "%s", gap >(work "/page")
            inside = wanted = 0
            gap = ""
            print >(work "/page")
            command = $0
            sub(/^<!-- printed( slowly)? by: /, "", command)
            sub(/ -->$/, "", command)
            if (size == "full" || $0 !~ /^<!-- printed slowly/) {
                print command >(work "/commands")
                wanted = 1
            }
            next
        }
        wanted && !inside && /^$/ { print >(work "/page"); next }
        wanted && /^(    |$)/ {
            if (!inside) {
                inside = 1
                file = work "/block" ++n
                printf "" >file
                print "@" n >(work "/page")
            }
            if (/^$/) { gap = gap "\n"; next }
            printf "%s%s\n", gap, substr($0, 5) >file
            gap = ""
            next
        }
        inside { inside = wanted = 0; printf "%s", gap >(work "/page"); gap = "" }
        { print >(work "/page") }
        END { printf "%s", gap >(work "/page") }' "$1"
}

for page in "$@"; do
    rm -f "$work/page" "$work/commands" "$work"/block*
    cut_blocks "$page"
    [ -f "$work/commands" ] || continue
    n=0
    while IFS= read -r command; do
        n=$((n + 1))
        print "$command" </dev/null
        if diff "$work/block$n" "$work/out" >"$work/diff"; then
            pass
        elif [ "$write" ]; then
            echo "$page: written: $command"
            cp "$work/out" "$work/block$n"
        else
            fail "$page: $command"
        fi
    done <"$work/commands"
    [ "$write" ] && awk -v work="$work" '
        /^@[0-9]+$/ {
            file = work "/block" substr($0, 2)
            while ((getline line < file) > 0)
                print (line == "" ? "" : "    " line)
            next
        }
        { print }' "$work/page" >"$work/new" && cp "$work/new" "$page"
    if [ "$write" ]; then
        awk -v write=1 -f tests/printed_by.awk "$page" >"$work/new" && cp "$work/new" "$page"
    elif awk -f tests/printed_by.awk "$page" >"$work/diff" && [ ! -s "$work/diff" ]; then
        pass
    else
        fail "$page: the command below a block:"
    fi
done

for picture in "$DRAWN"/*.svg; do
    [ -f "$picture" ] || continue
    old=docs/pictures/$(basename "$picture")
    if cmp -s "$picture" "$old"; then
        pass
    elif [ "$write" ]; then
        echo "written: $old"
        cp "$picture" "$old"
    else
        fail "$old"
    fi
done

[ -z "$write" ] || { counted; exit; }

# ---- Faults of the text ----------------------------------------------------------

rules=$PWD/tests/page_faults.awk

awk -f "$rules" "$@" >"$said"
expect "faults of pages" [ ! -s "$said" ]

# The copy links to all files that pages refer to. Pages are copied.
mkdir "$work/copy"
for file in *; do
    ln -s "$PWD/$file" "$work/copy"
done
rm "$work/copy/docs"
cp -r docs "$work/copy"
cd "$work/copy" || exit 1

planted() { # PAGE LINE FAULT: adds the line at the end of the first section
    awk -v line="$2" '
        /^## / && !n++ { printf "%s\n\n", line }
        { print }' "$1" >"$work/page"
    cp --remove-destination "$work/page" "$1"
    awk -f "$rules" "$1" >"$said"
    expect "not found in $1: $3" grep -qF "$3" "$said"
    cp --remove-destination "$OLDPWD/$1" "$1"
}

# A figure may be far from its unit.
planted README.md 'All in vector form is 16.7 and 2.31 times as fast.' 'the figure 16.7'
planted README.md 'All in vector form is 16.7 and 2.31 times as fast.' 'the figure 2.31'
planted README.md 'All in vector form is 16.7\ntimes as fast.' 'the figure 16.7'
planted README.md 'That saves **16.7** % of the time.' 'the figure 16.7'
planted README.md 'It has a hundredth, 16.7%, of the time.' 'the figure 16.7'
planted docs/solids.md 'The trees take 37 % of the clocks.' 'the figure 37'
planted docs/solids.md '| a tree | takes 37x as long |\n|---|---|' 'the figure 37'
planted docs/solids.md 'The trees take 37× as long.' 'the figure 37'
planted docs/solids.md '| a | b |\n|---|---|\n\n| 1 | 2 |' 'a row of a table without a head'
planted docs/solids.md '| a | b |\n| 1 | 2 |' 'a row of a table without a head'
planted docs/solids.md '| a | b |\n|---|---|\n| 1 | 2 | 3 |' 'a row of 3 cells in a table of 2'
planted docs/solids.md 'A table.\n| a | b |\n|---|---|' 'a table without an empty line before it'
planted docs/solids.md '| a | b |\n|---|---|\nA text.' 'a table without an empty line after it'
planted docs/solids.md 'A [page](nowhere.md) is missing.' 'a link to nothing: nowhere.md'
planted docs/solids.md 'A [page](\nnowhere.md) is missing.' 'a link to nothing'
planted docs/solids.md 'A [heading](#nowhere) is missing.' 'a link to no heading: #nowhere'
planted docs/solids.md 'A [heading](tracer.md#nowhere) is missing.' 'a link to no heading: tracer.md#nowhere'
planted docs/solids.md '![A picture](pictures/nowhere.png)' 'a link to nothing: pictures/nowhere.png'
planted docs/solids.md 'A [page]() is missing.' 'a link to nothing'
planted docs/solids.md 'A [page][nowhere] is missing.' 'a link without a target'
planted docs/solids.md 'A text that stops in the' 'a paragraph without an end'
planted docs/solids.md 'A source may be\nThe flags are not kept.\nthe result.' 'a sentence begins within another one'
planted docs/solids.md 'The flags are not kept. the result is.' 'a sentence begins in lower case'
counted
