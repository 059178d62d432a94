/* gnuplot.h - runs gnuplot as a process that draws a picture.
 *
 * No shell is involved, so file names need no quoting. The user's settings are
 * ignored, so that a script draws the same picture everywhere.
 */
#ifndef RT_PLOT_GNUPLOT_H
#define RT_PLOT_GNUPLOT_H

#include <stdio.h>

#include "vm/c205.h"

/* Runs the script, a file name in the folder, with the folder as working
 * directory, and writes its output to picture. The script must write to its
 * standard output if its variable `piped` exists. On failure the error is
 * gnuplot's last message, or names the package that contains gnuplot if it is not
 * found. */
bool gnuplot_draw(const char *folder, char *script, FILE *picture, c205_error *error);

#endif
