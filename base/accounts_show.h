/* accounts_show.h - where the clocks of runs went, as results of a command.
 *
 * For the reader one matrix: the time of each cause in all regions and in each
 * of them, and how well their vectors did.  What nobody spent time on has no
 * row and no column.  CSV and JSON have all clocks, by cause and by region.
 */
#ifndef BASE_ACCOUNTS_SHOW_H
#define BASE_ACCOUNTS_SHOW_H

#include "base/accounts.h"
#include "base/command_output.h"

/* The exit code, after telling what is wrong. */
int accounts_show(const struct accounts *accounts,
                  const struct command_output *results);

/* The matrix; causes are rows, or regions are, which is narrower where there
 * are many of them. */
enum accounts_rows { ACCOUNTS_CAUSES, ACCOUNTS_REGIONS };
/* With so many regions from the first one on, of those that took time, before
 * them, if that is 0, all (beyond
 * the last of them there are none); where only one took time, its figures are
 * those of all.  NULL: no memory. */
struct table *accounts_matrix(const struct accounts *accounts, enum accounts_rows rows,
                              size_t first, size_t count);

#endif
