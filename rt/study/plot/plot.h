/* plot.h - columns of a table as curves, drawn by gnuplot.
 *
 * A plot leaves three files: the picture, NAME.svg or NAME.png; NAME.dat, its
 * numbers in full precision; and NAME.gp, the script that makes the one from
 * the other, for who would like another look: `gnuplot NAME.gp`, run in their
 * folder, draws the picture again.  Nothing in them depends on the time of day.
 *
 * What is no finite number (NaN, an empty cell) is not drawn, and a curve has
 * a gap there.  Texts should fit: names of curves and marks of some 30 letters
 * at most, small print of some 110.
 */
#ifndef RT_PLOT_PLOT_H
#define RT_PLOT_PLOT_H

#include "base/table.h"

enum plot_scale { PLOT_LINEAR = 0, PLOT_LOG2 = 2, PLOT_LOG10 = 10 };

struct plot_axis {
    const char *title; /* with the unit */
    enum plot_scale scale;
};

/* A column of the table, from 0; the plot's curves have one x column. */
struct plot_curve {
    size_t column;
    const char *title;
};

struct plot_mark {
    double at; /* on the axis; NaN: there is none */
    const char *label;
};

enum plot_form {
    PLOT_LINES, /* each curve by itself */
    PLOT_AREAS, /* each on top of those before it; y is linear, none < 0 */
};

struct plot {
    const char *title;
    const char *const *subtitles; /* lines of small print below the title */
    size_t subtitle_count;
    struct plot_axis x, y;
    double y_most;   /* curves above are cut off, which the small print then
                        tells; 0: none is */
    size_t x_column; /* its values in order, from row to row */
    enum plot_form form;
    const struct plot_curve *curves;
    size_t curve_count;
    const struct plot_mark *marks; /* upright lines: at is x */
    size_t mark_count;
    const struct plot_mark *levels; /* lines across: at is y */
    size_t level_count;
};

/* Could a plot be written there?  Tells a name that does not end in .svg or .png, or a
 * missing folder before the work for a plot is done. */
bool plot_check_path(const char *path, c205_error *error);
/* Is the ending that of a plot? */
bool plot_is_named(const char *path);

/* Write path (NAME.svg or NAME.png) and beside it NAME.dat and NAME.gp, each whole or not
 * at all.  Where gnuplot fails or is not installed, which the error tells,
 * the data and the script stay.  Other errors: a path as above, no value to
 * draw, a value not above 0 on a logarithmic axis, one below 0 as an area, a
 * table for which memory ran short. */
bool plot_write(const struct plot *plot, const struct table *table, const char *path,
                c205_error *error);

#endif
