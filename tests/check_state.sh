#!/bin/sh
# check_state.sh BUILD - checks that no library has global state, because bands are
# traced in threads and a caller may have several machines. Writable data are reported,
# with two exceptions: the state of signals, and the list of the files that the process
# writes. The list is empty unless a command line is parsed.
set -u
build=$1
allowed='interrupt.o:came interrupt.o:files interrupt.o:owner outputs.o:outputs'
libraries="$build/libc205.a $build/libbase.a $build/libc205asm.a $build/libengine.a $build/librt205.a"

# The list consists of files.
# shellcheck disable=SC2086
LC_ALL=C objdump -t $libraries | awk -v allowed="$allowed" '
    / file format / { file = $1; sub(/:$/, "", file); files++ }
    / O / {
        for (i = 1; i < NF; i++)
            section = $i == "O" ? $(i + 1) : section
        name = $NF
        sub(/\.[0-9]+$/, "", name)
        if (section ~ /^(\.data|\.bss|\.tdata|\.tbss|\*COM\*)/ \
            && section !~ /^\.data\.rel\.ro/ \
            && index(" " allowed " ", " " file ":" name " ") == 0) {
            print "FAIL " file " can write " name " in " section
            failed++
        }
    }
    END {
        if (!files)
            failed++
        printf "%d passed, %d failed\n", files - failed, failed
        exit failed > 0
    }'
