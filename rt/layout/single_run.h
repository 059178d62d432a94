/* single_run.h - one run of a program in a machine of its own: what it is given, what it
 * gives. */
#ifndef RT_SINGLE_RUN_H
#define RT_SINGLE_RUN_H

#include "base/accounts.h"
#include "rt/layout/record.h"

struct single_run {
    const c205_model *model;
    const struct object *program;
    struct image image;
    struct record_layout layout; /* of what it is given */
    c205_error *error;
    struct accounts *accounts; /* what it took is added to; NULL: to none */
    /* Another machine, on which the run is projected, and where the clocks are
     * added; NULL: none. */
    const c205_model *projection;
    uint64_t *projected;
};

void single_run_begin(struct single_run *run, const struct object *program,
                      const c205_model *model, c205_error *error);
/* An integer to the place of that name; a number, so many words behind it. */
void single_run_word(struct single_run *run, const char *name, size_t value);
void single_run_number(struct single_run *run, const char *name, size_t i,
                       double value);
/* Room from a page of its own on, whose address goes to the place of that name: these
 * words, or zeros (NULL). */
uint64_t single_run_room(struct single_run *run, const char *name,
                         const c205_word *words, size_t count);
/* Runs it, reads so many words from the address on, adds its clocks.  False: a layout
 * that failed, a trap, no memory.  Ends the run in any case. */
bool single_run_end(struct single_run *run, uint64_t from, c205_word *words,
                    size_t count, uint64_t *clocks);

#endif
