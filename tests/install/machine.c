/* machine.c - a client of the installed libraries: encodes and runs a program. */
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
    const c205_word code[] = { insn("EX", (c205_fields){ .r = 16, .immediate = 205 }),
                               insn("EXIT", (c205_fields){ .r = 16 }) };
    const c205_segment segment = { 0x400000, 2, code };
    const c205_program program = { 0x400000, 1, &segment, 0, NULL, false };
    c205_model *model = c205_model_find("cyber205-2pipe", &error);
    c205 *machine = model ? c205_new(model, &error) : NULL;
    if (!machine || !c205_load(machine, &program, &error)) {
        puts(error.message);
        return 1;
    }
    c205_stop stop = c205_run(machine, C205_NO_LIMIT);
    printf("status %d after %d clocks\n", (int)stop.status, (int)c205_clock(machine));
    c205_free(machine);
    c205_model_free(model);
    return stop.trap == C205_TRAP_NONE && stop.status == 205 ? 0 : 1;
}
