/* program.c - assembles kernels and runs them on a machine. */
#include "rt/layout/program.h"

#include <stdio.h>

#include "vm/error.h"
#include "rt/shapes/shape.h"

struct object *program_assemble(const char *kernel, const struct asm_define *defines,
                                c205_error *error)
{
    const struct text *const texts[] = { kernel_texts, shape_texts, NULL };
    struct asm_options how = { .defines = defines,
                               .texts = texts,
                               .warnings = { .errors = true } };
    struct diagnostics errors = { 0 };
    char start[64];
    struct object *object;
    snprintf(start, sizeof start, "        .include \"%s\"\n", kernel);
    object = assemble_text(kernel, start, &how, &errors);
    if (!object && errors.count > 0)
        error_set(error, "%s:%zu: %s", errors.items[0].file, errors.items[0].line,
                  errors.items[0].message);
    else if (!object)
        error_set(error, "out of memory");
    diagnostics_free(&errors);
    return object;
}

bool program_run(c205 *machine, bool (*go_on)(void *context, const c205 *machine),
                 void *context, bool *stopped, c205_error *error)
{
    enum { SLICE = 5000000 }; /* number of clocks between two calls of go_on */
    for (;;) {
        uint64_t limit = !go_on ? C205_NO_LIMIT : c205_clock(machine) + SLICE;
        c205_stop stop = c205_run(machine, limit);
        if (stop.trap == C205_TRAP_NONE)
            return true;
        if (stop.trap != C205_TRAP_CLOCK_LIMIT) {
            c205_describe_stop(machine, &stop, error);
            return false;
        }
        if (!go_on(context, machine)) {
            *stopped = true;
            return false;
        }
    }
}

uint64_t program_round_up(uint64_t address)
{
    uint64_t page = UINT64_C(64) * C205_PAGE_WORDS;
    return (address + page - 1) / page * page;
}

uint64_t program_end(const struct object *program)
{
    uint64_t end = 0;
    for (size_t i = 0; i < program->program.segment_count; i++) {
        const c205_segment *segment = &program->program.segments[i];
        uint64_t last = segment->address + UINT64_C(64) * segment->length;
        end = last > end ? last : end;
    }
    return program_round_up(end);
}
