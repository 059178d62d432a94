#!/bin/sh
# check_dialect.sh - checks the rules of the house style that clang-format cannot check:
#
# - A local variable is not const, neither a value nor a pointer. The target of a
#   pointer may be const. So may a table, which is initialised in braces.
# - A pointer is tested by if (!p), not by a comparison with NULL.
# - No blank line is between the declarations at the beginning of a block and its
#   statements (blank_lines.awk).
# - The include guard of a header ends with the name of the header, and no other header
#   has the same guard. (A guard of vm/c205_NAME.h ends with API_NAME_H.)
# - Values of scenes are computed with elementary.h, not with functions of the host.
set -u
cd "$(dirname "$0")/.." || exit 1

sources() {
    find vm base asm web/engine web/tracer/platform rt tests -name '*.[ch]' ! -path '*/kernels/*' | sort
}
blank=$(sources | xargs awk -f tests/blank_lines.awk)
[ -z "$blank" ] || echo "$blank" | sed 's/$/: a blank line after declarations/'

# The text is a program of awk, whose $2 is a field.
# shellcheck disable=SC2016
sources | xargs awk -v blank="$blank" '
    function complain(text) {
        print FILENAME ":" FNR ": " text
        failed++
    }
    FNR == 1 { files++ }
    FILENAME ~ /\.h$/ && /^#ifndef [A-Z0-9_]+_H$/ {
        name = toupper(FILENAME)
        sub(/.*\//, "", name)
        sub(/\.H$/, "_H", name)
        if (FILENAME ~ /c205_/)
            sub(/^C205_/, "API_", name)
        if (guards[$2]++ || ("_" $2) !~ "_" name "$")
            complain("the include guard " $2)
    }
    /^ +const [a-z_0-9 ]+ [a-z_0-9]+ = *[^{]*$/ && !/= [^;]*{/ &&
        !/^ +const struct [a-z_]+ [a-z_]+ =$/ {
        complain("a local value that is const")
    }
    /^ +[a-z_0-9 ]+ \*const [a-z_0-9]+ =/ && !/static/ {
        complain("a local pointer that is const")
    }
    FILENAME ~ /^rt\/(scene|bvh|layout|shapes)\// && FILENAME !~ /elementary/ &&
        /[^_a-z](a?(sin|cos|tan)h?|atan2|exp|log|log10|pow|hypot|cbrt)\(/ &&
        !/^ *\/?\*/ {
        complain("an elementary function of the host")
    }
    /(if|while) \([^=]* [=!]= NULL\)/ { complain("a pointer compared") }
    END {
        failed += split(blank, lines, "\n")
        printf "%d passed, %d failed\n", files - failed, failed
        exit failed > 0
    }'
