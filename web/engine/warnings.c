/* warnings.c - checks the program while it runs, and writes the warnings and the trap of
 * the run. */
#include <stdlib.h>

#include "asm/view/trap_report.h"
#include "base/array.h"
#include "web/engine/engine_internal.h"

/* Records the number of checked steps for each new warning. */
static void record_steps(struct run_checks *checks)
{
    size_t found = runtime_found(checks->checker)->count;
    while (checks->count < found)
        if (!array_add(&checks->steps, &checks->count, &checks->checked,
                       sizeof checks->checked)) {
            runtime_forget(checks->checker, checks->count);
            return;
        }
}

bool warnings_begin(struct engine *engine, c205_error *error)
{
    static const struct warning_choice all;
    struct run_checks *checks = &engine->checks;
    checks->checker = runtime_new(engine->object, engine->name, &all, NULL);
    if (!checks->checker)
        return error_set(error, "out of memory");
    runtime_begin(checks->checker, engine_machine(engine));
    record_steps(checks);
    return true;
}

void warnings_drop(struct engine *engine)
{
    runtime_free(engine->checks.checker);
    free(engine->checks.steps);
    engine->checks = (struct run_checks){ .checker = NULL };
}

/* Goes back to a step from which the run differs, because the user has changed the
 * state. Drops the warnings of later steps. */
static void go_back(struct run_checks *checks, uint64_t step)
{
    while (checks->count > 0 && checks->steps[checks->count - 1] > step)
        checks->count--;
    runtime_forget(checks->checker, checks->count);
    checks->checked = step;
}

void warnings_listen(void *context, const c205 *machine, const c205_event *event)
{
    struct engine *engine = context;
    struct run_checks *checks = &engine->checks;
    uint64_t step;
    if (!checks->checker
        || (event->kind != C205_EVENT_INSTRUCTION && event->kind != C205_EVENT_REQUEST))
        return;
    step = debugger_step(engine->debugger);
    if (step < checks->checked && step >= debugger_known(engine->debugger))
        go_back(checks, step);
    if (step != checks->checked)
        return;
    runtime_listen(checks->checker, machine, event);
    checks->checked++;
    record_steps(checks);
}

/* Writes the trap as an error. Its message has a line for each operand. */
static bool put_trap(const struct engine *engine, const c205_stop *stop,
                     struct json *reply, c205_error *error)
{
    struct text_buffer text = { .text = NULL };
    struct sink sink = text_buffer_sink(&text);
    struct diagnostics diagnostics = { 0 };
    bool good;
    trap_diagnose(engine->object, engine->name, engine_machine(engine), stop,
                  &diagnostics);
    good = diagnostics.count == 1;
    if (good) {
        struct diagnostic trap = diagnostics.items[0];
        sink_print(&sink, "%s\n", trap.message);
        if (stop->insn)
            trap_report_operands(engine->object, engine_machine(engine), stop->pc,
                                 &sink);
        good = !text.failed;
        if (good) {
            text.text[text.length - 1] = '\0';
            trap.message = text.text;
            put_diagnostic(&trap, reply);
        }
    }
    text_buffer_free(&text);
    diagnostics_free(&diagnostics);
    return good || error_set(error, "out of memory");
}

bool put_warnings(const struct engine *engine, struct json *reply, c205_error *error)
{
    const struct diagnostics *found = runtime_found(engine->checks.checker);
    const c205_stop *halt = debugger_halt(engine->debugger);
    uint64_t step = debugger_step(engine->debugger);
    bool good = true;
    json_array(reply, "diagnostics");
    for (size_t i = 0; i < found->count && engine->checks.steps[i] <= step; i++)
        put_diagnostic(&found->items[i], reply);
    if (halt && halt->trap != C205_TRAP_NONE)
        good = put_trap(engine, halt, reply, error);
    json_end(reply);
    return good;
}
