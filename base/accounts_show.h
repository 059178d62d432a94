/* accounts_show.h - prints the clocks of runs as results of a command.
 *
 * The printed result is one matrix: the time of each cause, in all regions and in each
 * region, and figures of the vector instructions. Causes and regions without time are
 * omitted. CSV and JSON have all clocks, by cause and by region.
 */
#ifndef BASE_ACCOUNTS_SHOW_H
#define BASE_ACCOUNTS_SHOW_H

#include "base/accounts.h"
#include "base/command_output.h"

/* Prints the accounts. Returns the exit code, after an error message if it fails. */
int accounts_show(const struct accounts *accounts,
                  const struct command_output *results);

/* The rows of the matrix are causes, or regions, which is narrower if there are many of
 * them. */
enum accounts_rows { ACCOUNTS_CAUSES, ACCOUNTS_REGIONS };
/* Returns the matrix for count regions from the first one on, of those that took time.
 * Regions beyond the last are omitted. If only one region took time, the matrix has
 * only the sum of all regions. With causes as rows, the sum and its percentages are the
 * first columns of figures and are omitted if first is not 0. With regions as rows, the
 * sum is the last row. NULL: out of memory. */
struct table *accounts_matrix(const struct accounts *accounts, enum accounts_rows rows,
                              size_t first, size_t count);

#endif
