#!/bin/sh
# check_rooms.sh - checks that no file includes a file of a higher room
# (tests/rooms.txt), that every file is in a room, and that C++ and JavaScript are only
# in their folders.
set -u
cd "$(dirname "$0")/.." || exit 1

find vm base asm web/engine web/tracer/platform rt -name '*.[ch]' -o -name '*.cc' -o -name '*.def' | sort |
    xargs grep -H '^#include "' |
    awk -v rooms=tests/rooms.txt '
    function room_of(path) {
        while (!(path in rank) && sub(/\/[^\/]*$/, "", path))
            ;
        return path in rank ? path : ""
    }
    function complain(text) {
        print text
        failed++
    }
    BEGIN {
        while ((getline line < rooms) > 0)
            if (line !~ /^#/) {
                side_room = sub(/^\| */, "", line)
                count = split(line, names, " ")
                lines++
                for (i = 1; i <= count; i++) {
                    rank[names[i]] = lines
                    side[names[i]] = side_room
                }
            }
    }
    {
        split($0, parts, /:#include "|"/)
        from = parts[1]
        to = parts[2]
        if (to !~ /\//) {          # in the folder of the file
            to = from
            sub(/[^\/]*$/, parts[2], to)
        }
        if (room_of(from) == "")
            complain(from ": in no room of " rooms)
        else if (room_of(to) == "" || (getline line < to) < 0)
            complain(from ": " to " is in no room of " rooms)
        else if (rank[room_of(to)] > rank[room_of(from)])
            complain(from ": " to " lies above it")
        else if (side[room_of(to)] && room_of(from) != room_of(to))
            complain(from ": " to " lies in a side room")
        else
            passed++
        close(to)
    }
    END {
        if (!passed)
            complain("no include was read")
        printf "%d passed, %d failed\n", passed, failed
        exit failed > 0
    }' || exit 1
others=$(find vm base asm web/engine web/tracer/platform rt \( -name '*.cc' -o -name '*.js' -o -name '*.py' \) |
    grep -vx -e rt/picture/picture_oiio.cc -e rt/study/fit/ceres_fit.cc)
[ -z "$others" ] || { echo "not C, and no adapter: $others"; exit 1; }

# docs/architecture.md has a row for each room and names only files that exist.
. tests/count.sh
page=docs/architecture.md
for room in $(grep -v '^#' tests/rooms.txt | tr '| ' '\n' | grep -v '[.]'); do
    grep -q "^| \`$room\` |" "$page"
    verdict $? "$page has no row for $room"
done
# The quotes are those of the page.
# shellcheck disable=SC2016
for file in $(grep -o '`[a-z][a-z0-9_/.]*`' "$page" | tr -d '`' | grep /); do
    [ -e "$file" ]
    verdict $? "$page names $file, which does not exist"
done
counted
