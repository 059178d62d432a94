#include "asm/calculator.h"

#include <stdlib.h>
#include <string.h>

#include "asm/assemble.h"

/* Where f_x, f_y and f_r are (asm/lib/formula.s). */
enum { X = 210, Y, RESULT };

static const struct calculator_function functions[] = {
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

struct calculator {
    struct object *object;
    c205_model *model;
    c205 *machine;
};

const struct calculator_function *calculator_find(const char *name, size_t length)
{
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++)
        if (strlen(functions[i].name) == length
            && memcmp(functions[i].name, name, length) == 0)
            return &functions[i];
    return NULL;
}

struct calculator *calculator_new(void)
{
    struct calculator *calculator = calloc(1, sizeof *calculator);
    struct diagnostics errors = { 0 };
    c205_error error;

    if (!calculator)
        return NULL;
    calculator->object = assemble_text("calculator", program, NULL, &errors);
    diagnostics_free(&errors);
    calculator->model = c205_model_find(C205_DEFAULT_MODEL, &error);
    if (calculator->object && calculator->model)
        calculator->machine = c205_new(calculator->model, &error);
    if (calculator->machine
        && c205_load(calculator->machine, &calculator->object->program, &error))
        return calculator;
    calculator_free(calculator);
    return NULL;
}

void calculator_free(struct calculator *calculator)
{
    if (!calculator)
        return;
    c205_free(calculator->machine);
    c205_model_free(calculator->model);
    object_free(calculator->object);
    free(calculator);
}

c205_word calculator_compute(struct calculator *calculator,
                             const struct calculator_function *function, c205_word x,
                             c205_word y)
{
    c205 *machine = calculator->machine;

    c205_set_register(machine, X, x);
    c205_set_register(machine, Y, y);
    c205_set_pc(machine,
                (uint64_t)object_symbol(calculator->object, function->label)->value);
    c205_run(machine, C205_NO_LIMIT);
    return c205_register(machine, RESULT);
}
