/* script.h - the gnuplot script of a plot.
 *
 * The title and small print stand above the frame, with a line more where y is
 * cut off; then the labels of the marks, each beside its line and as many rows
 * as they need; the key is at the right.  So no text covers a curve.
 */
#ifndef RT_PLOT_SCRIPT_H
#define RT_PLOT_SCRIPT_H

#include "rt/study/plot/axis.h"

/* In the data file: x in column 1, the curves from column 2. */
struct plot_axes {
    struct axis x, y;
    double cut_off; /* the highest value, where y ends below it; else NaN */
};

/* The script that draws a picture, NAME.svg or NAME.png, from NAME.dat; the
 * writing may fail as that of any file, which the file then knows.  False: no
 * memory. */
bool plot_script_write(const struct plot *plot, const struct plot_axes *axes,
                       const char *name, FILE *file);

#endif
