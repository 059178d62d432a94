/* script.h - writes the gnuplot script of a plot.
 *
 * The title and the small print are above the frame, with one more line if y is
 * cut off. Below them are the labels of the marks, each next to its line, in as
 * many rows as they need. The key is on the right. No text covers a curve.
 */
#ifndef RT_PLOT_SCRIPT_H
#define RT_PLOT_SCRIPT_H

#include "rt/study/plot/plot_axis.h"

/* The axes. The data file has x in column 1 and the curves from column 2 on. */
struct plot_axes {
    struct axis x, y;
    double cut_off; /* the highest value if y ends below it; else NaN */
};

/* Writes the script that draws a picture, NAME.svg or NAME.png, from NAME.dat. A
 * failed write is recorded in the file, as for any file. Returns false if out of
 * memory. */
bool plot_script_write(const struct plot *plot, const struct plot_axes *axes,
                       const char *name, FILE *file);

#endif
