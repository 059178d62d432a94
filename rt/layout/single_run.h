/* single_run.h - runs a program once on a new machine: writes its input, runs it, and
 * reads its output. */
#ifndef RT_SINGLE_RUN_H
#define RT_SINGLE_RUN_H

#include "base/accounts.h"
#include "rt/layout/record.h"

struct single_run {
    const c205_model *model;
    const struct object *program;
    struct image image;
    struct record_layout layout; /* writes the input */
    c205_error *error;
    struct accounts *accounts; /* the accounts of the run are added to these; NULL:
                                * none */
    /* Another machine model, for which the clocks of the run are projected, and the sum
     * to which these clocks are added. NULL: none. */
    const c205_model *projection;
    uint64_t *projected;
};

void single_run_begin(struct single_run *run, const struct object *program,
                      const c205_model *model, c205_error *error);
/* single_run_word writes an integer to the word with this name. single_run_number
 * writes a number to the i-th word after it. */
void single_run_word(struct single_run *run, const char *name, size_t value);
void single_run_number(struct single_run *run, const char *name, size_t i,
                       double value);
/* Reserves words, from the start of a page on. Stores their address in the word with
 * this name, and returns the address. The words are copied from `words`, or are zeros
 * if `words` is NULL. */
uint64_t single_run_room(struct single_run *run, const char *name,
                         const c205_word *words, size_t count);
/* Runs the program, reads count words from the address `from`, and adds the clocks of
 * the run to *clocks. Returns false if the layout has failed, after a trap, or if out
 * of memory. The run is freed in all cases. */
bool single_run_end(struct single_run *run, uint64_t from, c205_word *words,
                    size_t count, uint64_t *clocks);

#endif
