/* gnuplot.h - gnuplot as a process that draws a picture.
 *
 * No shell is between, so names are as they are; and no settings of the
 * user's come in, so that a script draws the same everywhere.
 */
#ifndef RT_PLOT_GNUPLOT_H
#define RT_PLOT_GNUPLOT_H

#include <stdio.h>

#include "vm/c205.h"

/* Run the script, a name in the folder, there; what it draws goes to picture.
 * The script is to write to its standard output where its variable piped
 * exists.  The error has the last line of gnuplot's own, or the package that
 * gnuplot is in when it is not found. */
bool gnuplot_draw(const char *folder, char *script, FILE *picture, c205_error *error);

#endif
