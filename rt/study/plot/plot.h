/* plot.h - draws columns of a table as curves, with gnuplot.
 *
 * A plot consists of three files: the picture, NAME.svg or NAME.png; NAME.dat, its
 * numbers in full precision; and NAME.gp, the script that draws the picture from
 * the data. A user can edit the script and draw the picture again by running
 * `gnuplot NAME.gp` in their folder. The files do not depend on the time of day.
 *
 * A value that is not a finite number (NaN, an empty cell) is not drawn and leaves
 * a gap in the curve. Texts should fit: about 30 letters for names of curves and
 * marks, and about 110 for small print.
 */
#ifndef RT_PLOT_PLOT_H
#define RT_PLOT_PLOT_H

#include "base/table.h"

enum plot_scale { PLOT_LINEAR = 0, PLOT_LOG2 = 2, PLOT_LOG10 = 10 };

struct plot_axis {
    const char *title; /* with the unit */
    enum plot_scale scale;
};

/* A column of the table, from 0. All curves share one x column. */
struct plot_curve {
    size_t column;
    const char *title;
};

struct plot_mark {
    double at; /* on the axis; NaN: no mark */
    const char *label;
};

enum plot_form {
    PLOT_LINES, /* separate curves */
    PLOT_AREAS, /* stacked areas; y is linear, and no value is negative */
};

struct plot {
    const char *title;
    const char *const *subtitles; /* lines of small print below the title */
    size_t subtitle_count;
    struct plot_axis x, y;
    double y_most;   /* curves above are cut off, which the small print reports; 0:
                      * no limit */
    size_t x_column; /* its values are in order, from row to row */
    enum plot_form form;
    const struct plot_curve *curves;
    size_t curve_count;
    const struct plot_mark *marks; /* vertical lines; at is x */
    size_t mark_count;
    const struct plot_mark *levels; /* horizontal lines; at is y */
    size_t level_count;
};

/* Checks whether a plot can be written to the path. Call it before the work for a
 * plot, to reject a name that does not end in .svg or .png, or a missing folder. */
bool plot_check_path(const char *path, c205_error *error);
/* Returns true if the ending is that of a plot. */
bool plot_is_named(const char *path);

/* Writes path (NAME.svg or NAME.png), NAME.dat and NAME.gp, each completely or not
 * at all. If gnuplot fails or is not installed, which the error reports, the data
 * and the script remain. Other errors: an invalid path, no value to draw, a value
 * not above 0 on a logarithmic axis, a negative value as an area, or a table that
 * ran out of memory. */
bool plot_write(const struct plot *plot, const struct table *table, const char *path,
                c205_error *error);

#endif
