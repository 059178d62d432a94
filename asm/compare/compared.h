/* compared.h - two runs side by side, and what makes the difference.
 *
 * All figures are those of the machines' accounts.
 */
#ifndef ASM_COMPARED_H
#define ASM_COMPARED_H

#include "base/accounts.h"

enum { COMPARED_FIRST, COMPARED_SECOND, COMPARED_RUNS };

struct compared_run {
    struct accounts accounts;
    c205_account all; /* of all regions together */
};

/* What a machine has done, on its model, which outlives it.  Begin with zero.  False: no
 * memory. */
bool compared_take(struct compared_run *run, const c205 *machine);
void compared_free(struct compared_run *run);

/* Clocks by cause, and by region: those of the first, then those that the second alone
 * has; milliseconds, Mflop/s and the like.  NULL: no memory. */
struct table *compared_causes(const struct compared_run runs[COMPARED_RUNS]);
struct table *compared_regions(const struct compared_run runs[COMPARED_RUNS]);
struct table *compared_figures(const struct compared_run runs[COMPARED_RUNS]);

/* The one or two causes that make the difference, in a sentence. */
enum { COMPARED_SENTENCE = 256 };
void compared_sentence(const struct compared_run runs[COMPARED_RUNS],
                       char text[COMPARED_SENTENCE]);

#endif
