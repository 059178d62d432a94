#!/bin/sh
# check_rooms.sh [BUILD] - checks that no file includes a file of a higher room
# (tests/rooms.txt). With BUILD, it also checks that no object needs a symbol of a
# higher room, that every file is in a room, and that C++ and JavaScript are only in
# their folders.
set -u
build=${1:-}
cd "$(dirname "$0")/.." || exit 1

# Reads the rooms: the row of each folder and file, and the side rooms.
rooms='
    function room_of(path) {
        while (!(path in rank) && sub(/\/[^\/]*$/, "", path))
            ;
        return path in rank ? path : ""
    }
    function complain(text) {
        print text
        failed++
    }
    function report(what) {
        if (!passed)
            complain("no " what " was read")
        printf "%d passed, %d failed\n", passed, failed
        exit failed > 0
    }
    BEGIN {
        while ((getline line <"tests/rooms.txt") > 0)
            if (line !~ /^#/) {
                side_room = sub(/^\| */, "", line)
                count = split(line, names, " ")
                lines++
                for (i = 1; i <= count; i++) {
                    rank[names[i]] = lines
                    side[names[i]] = side_room
                }
            }
    }'

find vm base asm web/engine web/tracer/platform rt -name '*.[ch]' -o -name '*.cc' -o -name '*.def' | sort |
    xargs grep -H '^#include "' |
    awk "$rooms"'
    {
        split($0, parts, /:#include "|"/)
        from = parts[1]
        to = parts[2]
        if (to !~ /\//) {          # in the folder of the file
            to = from
            sub(/[^\/]*$/, parts[2], to)
        }
        if (room_of(from) == "")
            complain(from ": in no room of tests/rooms.txt")
        else if (room_of(to) == "" || (getline line < to) < 0)
            complain(from ": " to " is in no room of tests/rooms.txt")
        else if (rank[room_of(to)] > rank[room_of(from)])
            complain(from ": " to " lies above it")
        else if (side[room_of(to)] && room_of(from) != room_of(to))
            complain(from ": " to " lies in a side room")
        else
            passed++
        close(to)
    }
    END { report("include") }' || exit 1

# A symbol belongs to the room of its file, or of the header with the same name as the
# file. If two programs define the same symbol, the lower room counts.
[ -z "$build" ] || find vm base asm web/engine rt -name '*.c' | while read -r source; do
    [ ! -e "$build/${source%.c}.o" ] || echo "$build/${source%.c}.o"
done | xargs nm -A -P -g | awk -v build="$build/" "$rooms"'
    {
        file = substr($1, length(build) + 1)
        sub(/o:$/, "c", file)
    }
    $2 == "main" || $3 !~ /[A-Z]/ { next }
    $3 == "U" {
        uses++
        user[uses] = file
        used[uses] = $2
        next
    }
    {
        header = substr(file, 1, length(file) - 1) "h"
        row = rank[room_of(header in rank ? header : file)]
        if (!($2 in defined) || row < lowest[$2]) {
            defined[$2] = file
            lowest[$2] = row
        }
    }
    END {
        for (i = 1; i <= uses; i++)
            if (!(used[i] in defined))
                continue
            else if (lowest[used[i]] > rank[room_of(user[i])] ||
                    (side[room_of(defined[used[i]])] &&
                        room_of(defined[used[i]]) != room_of(user[i])))
                complain(user[i] ": " used[i] " is above it, in " defined[used[i]])
            else
                passed++
        report("symbol")
    }' || exit 1
others=$(find vm base asm web/engine web/tracer/platform rt \( -name '*.cc' -o -name '*.js' -o -name '*.py' \) |
    grep -vx -e rt/picture/picture_oiio.cc -e rt/study/fit/ceres_fit.cc)
[ -z "$others" ] || { echo "not C, and no adapter: $others"; exit 1; }

# docs/architecture.md must have a row for each room and name only files that exist.
. tests/count.sh
page=docs/architecture.md
for room in $(grep -v '^#' tests/rooms.txt | tr '| ' '\n' | grep -v '[.]'); do
    grep -q "^| \`$room\` |" "$page"
    verdict $? "$page has no row for $room"
done
# The quotes are part of the page.
# shellcheck disable=SC2016
for file in $(grep -o '`[a-z][a-z0-9_/.]*`' "$page" | tr -d '`' | grep /); do
    [ -e "$file" ]
    verdict $? "$page names $file, which does not exist"
done
counted
