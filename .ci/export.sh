#!/bin/sh
# export.sh LIBRARY HEADER ... -- OBJECT ... - one library of one object, whose
# global names are those that the headers declare; all else is its own.  What is
# wanted of an archive among the objects goes with them.
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
# shellcheck disable=SC2086
cat $headers | grep -oE '[A-Za-z_][A-Za-z_0-9]*' | sort -u >"$library.names"
${NM:-nm} -g --defined-only "$library.o" | awk '{ print $3 }' | sort -u |
    comm -12 - "$library.names" >"$library.api"
${OBJCOPY:-objcopy} --keep-global-symbols="$library.api" "$library.o"
rm -f "$library"
${AR:-ar} qcs "$library" "$library.o"
rm -f "$library.o" "$library.names"
