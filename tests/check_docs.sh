#!/bin/sh
# check_docs.sh BUILD quick|full [--write] PAGE .. - what the pages print is what
# the commands print.  In a page, a comment
#
#     <!-- printed by: COMMAND -->        (or: <!-- printed slowly by: COMMAND -->)
#
# stands above an indented block, which must be the output of the command; the
# shell runs it with the build's programs first in its path and the build's
# folder in BUILD, and what comes before its first " | " once for all blocks.
# What it draws in the folder DRAWN is what docs/pictures has under that name.
# quick leaves out the slow ones, which take more than about two seconds.
# --write puts the output and the pictures into the pages instead.
set -u
. "$(dirname "$0")/count.sh"
BUILD=$(cd "$1" && pwd) size=$2
shift 2
write=
if [ "${1:-}" = --write ]; then
    write=$1
    shift
fi
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
said=$work/diff
DRAWN=$work/drawn
PATH=$BUILD:$PATH
export BUILD DRAWN PATH
mkdir "$DRAWN"

# The output of a command line, into $work/out.
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

# The page with its blocks cut into files block1 .. and their commands in
# commands; the lines between them in the file page, a line "@N" for a block.
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
done

# But for the line in which gnuplot names itself.
drawing() {
    sed '/Produced by GNUPLOT/d' "$1"
}

for picture in "$DRAWN"/*.svg; do
    [ -f "$picture" ] || continue
    old=docs/pictures/$(basename "$picture")
    drawing "$picture" >"$work/new"
    if drawing "$old" | diff - "$work/new" >"$work/diff"; then
        pass
    elif [ "$write" ]; then
        echo "written: $old"
        cp "$picture" "$old"
    else
        fail "$old"
    fi
done
counted
