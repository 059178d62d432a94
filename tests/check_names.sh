#!/bin/sh
# check_names.sh BUILD - checks that a name has one meaning. No struct, union or enum
# may be defined in two files, and no symbol in two libraries.
set -u
build=$1
here=$(dirname "$0")
. "$here/count.sh"
cd "$here/.." || exit 1

tags=$(find vm base asm web/engine rt -name '*.[ch]' -exec grep -HoE \
    '\b(struct|union|enum) [a-z_0-9]+ \{' {} + | sort -u | cut -d: -f2 |
    sort | uniq -d)
expect "defined in two files: $tags" [ -z "$tags" ]
names=$(for library in libc205 libbase libc205asm libengine librt205; do
    nm -g --defined-only "$build/$library.a" 2>/dev/null |
        awk 'NF == 3 { print $3 }' | sort -u
done | sort | uniq -d)
expect "in two libraries: $names" [ -z "$names" ]
counted
