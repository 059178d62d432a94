#include "rt/mass/programs.h"

#include "rt/layout/program.h"

void mass_run_begin(struct mass_run *run, const struct object *program,
                    const c205_model *model, c205_error *error)
{
    *run = (struct mass_run){ .model = model,
                              .program = program,
                              .error = error };
    run->layout = (struct record_layout){ .image = &run->image,
                                          .program = program,
                                          .error = error,
                                          .free = program_end(program) };
}

void mass_give(struct mass_run *run, const char *name, size_t value)
{
    layout_word(&run->layout, name, c205_from_integer((int64_t)value));
}

void mass_give_number(struct mass_run *run, const char *name, size_t i,
                      double value)
{
    uint64_t address = layout_symbol(&run->layout, name) + 64 * i;
    c205_word word = c205_from_double(value);

    layout_words(&run->layout, address, &word, 1);
}

uint64_t mass_give_room(struct mass_run *run, const char *name,
                        const c205_word *words, size_t count)
{
    uint64_t address = layout_reserve(&run->layout, count);

    if (words)
        layout_words(&run->layout, address, words, count);
    layout_word(&run->layout, name, address);
    return address;
}

static bool run_on(struct mass_run *run, c205 *machine, uint64_t from,
                   c205_word *words, size_t count)
{
    bool stopped = false;

    return c205_load(machine, &run->program->program, run->error)
           && image_load(&run->image, machine, run->error)
           && program_run(machine, NULL, NULL, &stopped, run->error)
           && c205_read(machine, from, words, count);
}

bool mass_run_end(struct mass_run *run, uint64_t from, c205_word *words,
                  size_t count, uint64_t *clocks)
{
    c205 *machine = run->layout.failed ? NULL
                                       : c205_new(run->model, run->error);
    bool good = machine && run_on(run, machine, from, words, count);

    if (good)
        *clocks += c205_clock(machine);
    c205_free(machine);
    image_free(&run->image);
    return good;
}
