/* accounts_show.h - prints the clocks of runs as results of a command.
 *
 * The printed result is one matrix. It contains the time of each cause, in all regions
 * and in each region, and figures of the vector instructions. It omits causes and
 * regions without time. CSV and JSON contain all clocks, by cause and by region.
 */
#ifndef BASE_ACCOUNTS_SHOW_H
#define BASE_ACCOUNTS_SHOW_H

#include "base/accounts.h"
#include "base/command_output.h"

/* Prints the accounts in the format of the results. Returns the exit code, after an
 * error message if memory is exhausted. */
int accounts_show(const struct accounts *accounts,
                  const struct command_output *results);

/* The rows of the matrix are causes or regions. If there are many regions, a matrix
 * with regions as rows is narrower. */
enum accounts_rows { ACCOUNTS_CAUSES, ACCOUNTS_REGIONS };
/* Returns the matrix for up to `count` regions that took time, from index `first` on.
 * If only one region took time, it is omitted, because it equals the sum of all
 * regions. If causes are rows, the sum and its percentages are columns, but only if
 * first is 0. If regions are rows, the sum is the last row. NULL: out of memory. */
struct table *accounts_matrix(const struct accounts *accounts, enum accounts_rows rows,
                              size_t first, size_t count);

#endif
