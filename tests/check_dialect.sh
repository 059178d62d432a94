#!/bin/sh
# check_dialect.sh - what clang-format cannot see of the house style:
#   a local variable is not const, be it a value or a pointer: what it points
#   at is, and so are tables, which are written out in braces;
#   a pointer is asked by itself, if (!p), not by comparing it with NULL;
#   what a scene comes to is computed by elementary.h, not by the host's functions.
set -u
cd "$(dirname "$0")/.." || exit 1

find vm base asm web/engine web/tracer/platform rt tests -name '*.[ch]' ! -path '*/kernels/*' | sort |
    xargs awk '
    function complain(text) {
        print FILENAME ":" FNR ": " text
        failed++
    }
    FNR == 1 { files++ }
    /^ +const [a-z_0-9 ]+ [a-z_0-9]+ = *[^{]*$/ && !/= [^;]*{/ &&
        !/^ +const struct [a-z_]+ [a-z_]+ =$/ {
        complain("a local value that is const")
    }
    /^ +[a-z_0-9 ]+ \*const [a-z_0-9]+ =/ && !/static/ {
        complain("a local pointer that is const")
    }
    FILENAME ~ /^rt\/(scene|layout|shapes)\// && FILENAME !~ /elementary/ &&
        /[^_a-z](a?(sin|cos|tan)h?|atan2|exp|log|log10|pow|hypot|cbrt)\(/ &&
        !/^ *\/?\*/ {
        complain("an elementary function of the host")
    }
    /(if|while) \([^=]* [=!]= NULL\)/ { complain("a pointer compared") }
    END {
        printf "%d passed, %d failed\n", files - failed, failed
        exit failed > 0
    }'
