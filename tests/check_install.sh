#!/bin/sh
# check_install.sh BUILD MAKE - what make install puts into a folder is all
# that is needed: rt205 finds its adapter there, and a C program that has only
# the header, the table and the library runs a program of the machine.
set -u
build=$1 make=$2
scene=$(pwd)/scenes/first.pov
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/root/usr
passed=0 failed=0

succeeds() { # COMMAND ..
    if "$@" >"$work/out" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAIL $*"
        sed 's/^/    /' "$work/out"
    fi
}

cat >"$work/client.c" <<'END'
#include <c205.h>
#include <stdio.h>
#include <string.h>

static c205_word insn(const char *mnemonic, c205_fields fields)
{
    return c205_encode(c205_insn_named(mnemonic, strlen(mnemonic)), &fields);
}

int main(void)
{
    c205_error error = { "" };
    const c205_word code[] = {
        insn("EX", (c205_fields){ .r = 16, .immediate = 205 }),
        insn("EXIT", (c205_fields){ .r = 16 })
    };
    const c205_segment segment = { 0x400000, 2, code };
    const c205_program program = { 0x400000, 1, &segment, 0, NULL };
    c205_model *model = c205_model_find("cyber205-2pipe", &error);
    c205 *machine = model ? c205_new(model, &error) : NULL;

    if (!machine || !c205_load(machine, &program, &error)) {
        puts(error.message);
        return 1;
    }
    c205_stop stop = c205_run(machine, C205_NO_LIMIT);
    printf("status %d after %d clocks\n", (int)stop.status,
           (int)c205_clock(machine));
    c205_free(machine);
    c205_model_free(model);
    return stop.trap == C205_TRAP_NONE && stop.status == 205 ? 0 : 1;
}
END

succeeds "$make" --no-print-directory BUILD="$build" \
    DESTDIR="$work/root" PREFIX=/usr install
unset RT205_LIBDIR
cd "$work" || exit 1
succeeds "$root/bin/rt205" render "$scene" -o a.png -W 40 -H 30
succeeds test -s a.png
succeeds "$root/bin/c205" isa ADDNV
succeeds "${CC:-cc}" -std=c99 -pedantic -Wall -Wextra -Werror \
    -I"$root/include" -o client client.c -L"$root/lib" -lc205 -lm
succeeds sh -c "./client >said"
succeeds grep -q '^status 205 after [1-9][0-9]* clocks$' said
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
