#!/bin/sh
# export.sh LIBRARY HEADER .. -- OBJECT .. - makes a library of one object. Functions
# and objects that the headers declare are global; all other names become local. An
# archive among the objects contributes the members that the objects need.
set -eu
library=$1
shift
headers=
while [ "$1" != -- ]; do
    headers="$headers $1"
    shift
done
shift
${LD:-ld} -r -o "$library.o" "$@"

# Candidates are words of the headers that are also names of the object. A word may be
# in a comment or in a row of a table, so the compiler determines which names are
# declared. A generated function uses each name, in a "file" of that name, so an error
# message begins with the name.
# shellcheck disable=SC2086
cat $headers | grep -oE '[A-Za-z_][A-Za-z_0-9]*' | sort -u >"$library.words"
${NM:-nm} -g --defined-only "$library.o" | awk '{ print $3 }' | sort -u |
    comm -12 - "$library.words" >"$library.api"
uses() {
    for header in $headers; do
        case $header in *.h) echo "#include \"$header\"" ;; esac
    done
    awk '{ printf "#line 1 \"%s\"\nvoid use_%d(void) { (void)%s; }\n", $0, NR, $0 }' \
        "$library.api"
}
# Repeats until the compiler reports no errors, because it may stop after some errors.
until uses | ${CC:-cc} -std=c99 -I. -fsyntax-only -x c - 2>"$library.errors"
do
    sed -n 's/^\([A-Za-z_][A-Za-z_0-9]*\):[0-9:]* error:.*/\1/p' \
        "$library.errors" | sort -u >"$library.words"
    comm -23 "$library.api" "$library.words" >"$library.left"
    if cmp -s "$library.api" "$library.left"; then
        cat "$library.errors" >&2
        exit 1
    fi
    mv "$library.left" "$library.api"
done

${OBJCOPY:-objcopy} --keep-global-symbols="$library.api" "$library.o"
rm -f "$library"
${AR:-ar} qcs "$library" "$library.o"
rm -f "$library.o" "$library.words" "$library.errors" "$library.left"
