/* constant_folder.c - computes floating-point operations of expressions on a
 * machine. */
#include "asm/text/constant_folder.h"

#include <stdlib.h>
#include <string.h>

#include "asm/text/assemble.h"

/* Numbers of the registers f_x, f_y and f_r of asm/lib/functions.s. */
enum { X = 210, Y, RESULT };

static const struct constant_folder_function functions[] = {
    { "+", 2, false, "plus" },         { "-", 2, false, "minus" },
    { "*", 2, false, "times" },        { "/", 2, false, "over" },
    { "<", 2, true, "less" },          { ">=", 2, true, "not_less" },
    { "==", 2, true, "equal" },        { "!=", 2, true, "not_equal" },
    { "sqrt", 1, false, "root" },      { "exp", 1, false, "do_exp" },
    { "log", 1, false, "do_log" },     { "sin", 1, false, "do_sin" },
    { "cos", 1, false, "do_cos" },     { "atan2", 2, false, "do_atan2" },
    { "power", 2, false, "do_power" }, { "floor", 1, true, "whole" },
    { "float", 1, false, "real" },
};

static const char program[] = "        .include \"atan2.s\"\n"
                              "        .include \"power.s\"\n"
                              "        .include \"log.s\"\n"
                              "        .include \"sin.s\"\n"
                              "        .macro  do routine\n"
                              "do_\\routine: call \\routine, f_link, f_target\n"
                              "        EXIT\n"
                              "        .endm\n"
                              "plus:   ADDN    f_x, f_y, f_r\n"
                              "        EXIT\n"
                              "minus:  SUBN    f_x, f_y, f_r\n"
                              "        EXIT\n"
                              "times:  MPYS    f_x, f_y, f_r\n"
                              "        EXIT\n"
                              "over:   DIVS    f_x, f_y, f_r\n"
                              "        EXIT\n"
                              "        .macro  compare name, branch\n"
                              "\\name:  ES      f_r, 1\n"
                              "        \\branch f_x, f_y, done\n"
                              "        ES      f_r, 0\n"
                              "        EXIT\n"
                              "        .endm\n"
                              "        compare less, CFPLT\n"
                              "        compare not_less, CFPGE\n"
                              "        compare equal, CFPEQ\n"
                              "        compare not_equal, CFPNE\n"
                              "done:   EXIT\n"
                              "root:   SQRT    f_x, f_r\n"
                              "        EXIT\n"
                              "whole:  FLR     f_x, f_r\n"
                              "        EXIT\n"
                              "real:   ADDN    f_x, r0, f_r\n"
                              "        EXIT\n"
                              "        do      exp\n"
                              "        do      log\n"
                              "        do      sin\n"
                              "        do      cos\n"
                              "        do      atan2\n"
                              "        do      power\n";

struct constant_folder {
    struct object *object;
    c205_model *model;
    c205 *machine;
};

const struct constant_folder_function *constant_folder_find(const char *name,
                                                            size_t length)
{
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++)
        if (strlen(functions[i].name) == length
            && memcmp(functions[i].name, name, length) == 0)
            return &functions[i];
    return NULL;
}

struct constant_folder *constant_folder_new(void)
{
    struct constant_folder *constant_folder = calloc(1, sizeof *constant_folder);
    struct diagnostics errors = { 0 };
    c205_error error;
    if (!constant_folder)
        return NULL;
    constant_folder->object = assemble_text("constant_folder", program, NULL, &errors);
    diagnostics_free(&errors);
    constant_folder->model = c205_model_find(C205_DEFAULT_MODEL, &error);
    if (constant_folder->object && constant_folder->model)
        constant_folder->machine = c205_new(constant_folder->model, &error);
    if (constant_folder->machine
        && c205_load(constant_folder->machine, &constant_folder->object->program,
                     &error))
        return constant_folder;
    constant_folder_free(constant_folder);
    return NULL;
}

void constant_folder_free(struct constant_folder *constant_folder)
{
    if (!constant_folder)
        return;
    c205_free(constant_folder->machine);
    c205_model_free(constant_folder->model);
    object_free(constant_folder->object);
    free(constant_folder);
}

c205_word constant_folder_compute(struct constant_folder *constant_folder,
                                  const struct constant_folder_function *function,
                                  c205_word x, c205_word y)
{
    c205 *machine = constant_folder->machine;
    c205_set_register(machine, X, x);
    c205_set_register(machine, Y, y);
    c205_set_pc(machine,
                (uint64_t)object_symbol(constant_folder->object, function->label)
                    ->value);
    c205_run(machine, C205_NO_LIMIT);
    return c205_register(machine, RESULT);
}
