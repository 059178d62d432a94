/* single_run.h - runs a program once on a machine of its own: writes its input,
 * runs it, and reads its output. */
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
    struct accounts *accounts; /* receives the accounts of the run; NULL: none */
    /* Another machine model, on which the run is projected, and the sum to which the
     * projected clocks are added; NULL: none. */
    const c205_model *projection;
    uint64_t *projected;
};

void single_run_begin(struct single_run *run, const struct object *program,
                      const c205_model *model, c205_error *error);
/* Write an integer to the place with this name, and a number to the i-th word
 * after it. */
void single_run_word(struct single_run *run, const char *name, size_t value);
void single_run_number(struct single_run *run, const char *name, size_t i,
                       double value);
/* Reserves words at a new page and writes the address to the place with this name.
 * The words are copied, or zeros if NULL. */
uint64_t single_run_room(struct single_run *run, const char *name,
                         const c205_word *words, size_t count);
/* Runs the program, reads count words from the address on, and adds its clocks to
 * *clocks. Returns false after a failed layout, a trap, or if out of memory. Ends
 * the run in any case. */
bool single_run_end(struct single_run *run, uint64_t from, c205_word *words,
                    size_t count, uint64_t *clocks);

#endif
