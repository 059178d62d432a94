/* compared.h - compares the accounts of two runs, and finds the main causes of the
 * difference between their clocks.
 */
#ifndef ASM_COMPARED_H
#define ASM_COMPARED_H

#include "base/accounts.h"

enum { COMPARED_FIRST, COMPARED_SECOND, COMPARED_RUNS };

struct compared_run {
    struct accounts accounts;
    c205_account all; /* sum over all regions */
};

/* Stores the accounts of a machine that has run. The struct must be zeroed, and the
 * model must outlive it. Returns false if memory is exhausted. */
bool compared_take(struct compared_run *run, const c205 *machine);
void compared_free(struct compared_run *run);

/* Return tables of the clocks by cause, of the clocks by region, and of figures such as
 * milliseconds and Mflop/s. Regions of the first run come first, then the regions that
 * only the second run has. They return NULL if memory is exhausted. */
struct table *compared_causes(const struct compared_run runs[COMPARED_RUNS]);
struct table *compared_regions(const struct compared_run runs[COMPARED_RUNS]);
struct table *compared_figures(const struct compared_run runs[COMPARED_RUNS]);

/* Writes a sentence that names the one or two causes with the largest part of the
 * difference between the clocks. */
enum { COMPARED_SENTENCE = 256 };
void compared_sentence(const struct compared_run runs[COMPARED_RUNS],
                       char text[COMPARED_SENTENCE]);

#endif
