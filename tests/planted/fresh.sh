#!/bin/sh
# fresh.sh - the text that each fault of bugs.list replaces is one line's, stands
# once in its file, and an empty line parts it from the fault before.  Whether
# the fault is found is for run.sh to say.
set -u
cd "$(dirname "$0")/../.." || exit 1

awk '
    function times(text, path, line, count) {
        while ((getline line < path) > 0)
            if (index(line, text))
                count++
        close(path)
        return count + 0
    }
    /^# / {
        what = substr($0, 3)
        if (before ~ /^\+/) {
            print "FAIL joined to the fault before: " what
            failed++
        }
    }
    /^= / { path = substr($0, 3) }
    /^- / {
        if (before ~ /^- /) {
            print "FAIL two lines are replaced: " what
            failed++
        } else if (times(substr($0, 3), path) == 1)
            passed++
        else {
            print "FAIL stale in " path ": " what
            failed++
        }
    }
    { before = $0 }
    END {
        printf "%d passed, %d failed\n", passed, failed
        exit failed > 0
    }' tests/planted/bugs.list
