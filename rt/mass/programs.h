/* programs.h - a program of rt/kernels/mass/ in a machine: what it is given, what it
 * gives. */
#ifndef RT_MASS_PROGRAMS_H
#define RT_MASS_PROGRAMS_H

#include "rt/layout/record.h"

/* One run of a program. */
struct mass_run {
    const c205_model *model;
    const struct object *program;
    struct image image;
    struct record_layout layout; /* of what it is given */
    c205_error *error;
};

void mass_run_begin(struct mass_run *run, const struct object *program,
                    const c205_model *model, c205_error *error);
/* To the place of that name. */
void mass_give(struct mass_run *run, const char *name, size_t value);
void mass_give_number(struct mass_run *run, const char *name, size_t i,
                      double value);
/* Room from a page of its own on, whose address goes to the place of that name: these
 * words, or zeros (NULL). */
uint64_t mass_give_room(struct mass_run *run, const char *name,
                        const c205_word *words, size_t count);
/* Runs it, reads so many words from the address on, adds its clocks.  False: a
 * layout that failed, a trap.  Ends the run in any case. */
bool mass_run_end(struct mass_run *run, uint64_t from, c205_word *words,
                  size_t count, uint64_t *clocks);

#endif
