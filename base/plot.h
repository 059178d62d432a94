/* plot.h - draws columns of a table as curves in an SVG picture.
 *
 * A value that is not finite (NaN, an empty cell) is not drawn and leaves a gap in the
 * curve. Texts should be short: up to about 30 letters for names of curves and marks,
 * and about 110 for small print.
 */
#ifndef BASE_PLOT_H
#define BASE_PLOT_H

#include "base/sink.h"
#include "base/table.h"

enum plot_scale { PLOT_LINEAR = 0, PLOT_LOG2 = 2, PLOT_LOG10 = 10 };

struct plot_axis {
    const char *title; /* includes the unit */
    enum plot_scale scale;
};

struct plot_line {
    double start, slope; /* y = start + slope x */
};

/* A curve: the values of one column of the table. Columns count from 0. All curves have
 * the same x column. */
struct plot_curve {
    size_t column;
    const char *title;
    const struct plot_line *fitted; /* drawn instead of the segments between the points;
                                       NULL: none */
};

struct plot_mark {
    double at; /* position on the axis; NaN: no mark */
    const char *label;
};

enum plot_form {
    PLOT_LINES, /* separate curves */
    PLOT_AREAS, /* stacked areas; y is linear, and no value is negative */
};

enum { MAX_PLOT_MARKS = 8 };

struct plot {
    const char *title;
    const char *const *subtitles; /* lines of small print below the title */
    size_t subtitle_count;
    struct plot_axis x, y;
    double y_most;   /* maximum y; the small print reports if curves exceed it; 0: no
                        limit */
    size_t x_column; /* its values must be in order */
    enum plot_form form;
    const struct plot_curve *curves;
    size_t curve_count;
    const struct plot_mark *marks;  /* vertical lines at x */
    size_t mark_count;              /* maximum MAX_PLOT_MARKS */
    const struct plot_mark *levels; /* horizontal lines at y */
    size_t level_count;
};

/* Draws the plot. Returns false and writes nothing if there is no value to draw, a
 * value on a logarithmic axis is not above 0, a value of an area is negative, or the
 * table is incomplete for lack of memory. The picture does not contain the time. */
bool plot_draw(const struct plot *plot, const struct table *table,
               const struct sink *sink, c205_error *error);

#endif
