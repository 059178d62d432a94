/* program.c - a client of the installed libraries: assembles a text, runs it and prints
 * the final value of a register. */
#include <asm/text/assemble.h>

#include <stdio.h>

static const char text[] = "        .regs   r16, n\n"
                           "        ES      n, 200\n"
                           "        IS      n, 5\n"
                           "        EXIT    n\n";

static int fail(const char *why)
{
    fprintf(stderr, "%s\n", why);
    return 1;
}

static int run(const c205_model *model, const struct object *object)
{
    c205_error error = { "" };
    c205 *machine = c205_new(model, &error);
    c205_stop stop;
    if (!machine || !c205_load(machine, &object->program, &error))
        return fail(error.message);
    stop = c205_run(machine, C205_NO_LIMIT);
    printf("status %d after %d clocks\n", (int)stop.status, (int)c205_clock(machine));
    c205_free(machine);
    return stop.trap != C205_TRAP_NONE;
}

int main(void)
{
    struct diagnostics found = { 0 };
    c205_error error = { "" };
    c205_model *model = c205_model_find("cyber205-2pipe", &error);
    struct object *object = assemble_text("client.s", text, NULL, &found);
    int code = 1;
    diagnostics_print(&found, stderr);
    if (!model)
        fail(error.message);
    else if (object)
        code = run(model, object);
    diagnostics_free(&found);
    object_free(object);
    c205_model_free(model);
    return code;
}
