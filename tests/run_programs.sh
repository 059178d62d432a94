#!/bin/sh
# run_programs.sh C205 - run every test program and every example; each
# instruction of the table must have a program of its name.
set -eu
c205=$1
cd "$(dirname "$0")/.."
code=0
for name in $("$c205" isa --names); do
    program=tests/programs/$(printf '%s' "$name" | tr '[:upper:]' '[:lower:]').s
    if [ ! -f "$program" ]; then
        printf 'no program for %s: %s\n' "$name" "$program"
        code=1
    fi
done
"$c205" run --check -Werror tests/programs/*.s tests/programs/traps/*.s \
    asm/examples/*.s || code=1
"$c205" run --check -Werror -I rt/kernels rt/study/fit/programs/*.s || code=1
exit $code
