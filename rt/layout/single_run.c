/* single_run.c - runs a program once on a new machine. */
#include "rt/layout/single_run.h"

#include "vm/error.h"
#include "rt/layout/program.h"

void single_run_begin(struct single_run *run, const struct object *program,
                      const c205_model *model, c205_error *error)
{
    *run = (struct single_run){ .model = model, .program = program, .error = error };
    run->layout = (struct record_layout){ .image = &run->image,
                                          .program = program,
                                          .error = error,
                                          .free = program_end(program) };
}

void single_run_word(struct single_run *run, const char *name, size_t value)
{
    layout_word(&run->layout, name, c205_from_integer((int64_t)value));
}

void single_run_number(struct single_run *run, const char *name, size_t i, double value)
{
    uint64_t address = layout_symbol(&run->layout, name) + 64 * i;
    c205_word word = c205_from_double(value);
    layout_words(&run->layout, address, &word, 1);
}

uint64_t single_run_room(struct single_run *run, const char *name,
                         const c205_word *words, size_t count)
{
    uint64_t address = layout_reserve(&run->layout, count);
    if (words)
        layout_words(&run->layout, address, words, count);
    layout_word(&run->layout, name, address);
    return address;
}

static bool run_on(struct single_run *run, c205 *machine, uint64_t from,
                   c205_word *words, size_t count)
{
    bool stopped = false;
    return c205_load(machine, &run->program->program, run->error)
           && image_load(&run->image, machine, run->error)
           && program_run(machine, NULL, NULL, &stopped, run->error)
           && c205_read(machine, from, words, count);
}

/* Adds the clocks of all accounts, projected for the other machine model, to
 * *run->projected. */
static bool add_projected(const struct single_run *run, const c205 *machine,
                          const c205_projection *projection)
{
    if (!c205_projection_holds(projection, run->error))
        return false;
    for (size_t i = 0; i < c205_account_count(machine); i++)
        *run->projected += c205_projected_clocks(projection, i);
    return true;
}

static bool run_projected(struct single_run *run, c205 *machine, uint64_t from,
                          c205_word *words, size_t count)
{
    c205_projection *projection = c205_projection_new(run->projection, run->error);
    bool good = projection && c205_listen(machine, c205_project, projection)
                && run_on(run, machine, from, words, count)
                && add_projected(run, machine, projection);
    c205_projection_free(projection);
    return good;
}

bool single_run_end(struct single_run *run, uint64_t from, c205_word *words,
                    size_t count, uint64_t *clocks)
{
    c205 *machine = run->layout.failed ? NULL : c205_new(run->model, run->error);
    bool good = machine
                && (run->projection ? run_projected(run, machine, from, words, count)
                                    : run_on(run, machine, from, words, count));
    if (good)
        *clocks += c205_clock(machine);
    if (good && run->accounts && !accounts_add(run->accounts, machine))
        good = error_set(run->error, "out of memory");
    c205_free(machine);
    image_free(&run->image);
    return good;
}
