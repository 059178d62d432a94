/* plot_axis.h - computes the range and the labels of an axis of a plot. */
#ifndef BASE_PLOT_AXIS_H
#define BASE_PLOT_AXIS_H

#include "base/plot.h"

struct axis {
    enum plot_scale scale;
    double low, high; /* empty if low > high */
};

enum { AXIS_TICS = 128, AXIS_LABEL_SIZE = 32 };

struct axis_tic {
    double at;
    char label[AXIS_LABEL_SIZE]; /* as in "16,384"; "" for a minor tic */
};

struct axis axis_new(enum plot_scale scale);
/* Returns true if the axis can show the value. A logarithmic axis shows only
 * values above 0. */
bool axis_shows(const struct axis *axis, double value);
/* Extends the axis to include the value. */
void axis_reach(struct axis *axis, double value);
/* Widens an axis that consists of a single point. */
void axis_widen(struct axis *axis);
/* Extends the axis at both ends, so that no point touches the frame. */
void axis_pad(struct axis *axis);
/* Extends both ends to the next round value. A linear axis also includes 0. */
void axis_round(struct axis *axis);

/* Returns the position of a value: 0 at the low end, 1 at the high end. */
double axis_place(const struct axis *axis, double value);
/* Returns the value at a position on the axis, the inverse of axis_place. */
double axis_value(const struct axis *axis, double place);
/* Formats a number for a label, as in "16,384". */
void axis_label(char label[AXIS_LABEL_SIZE], double value);
/* Makes the tics, with at most ten labels. Returns their number. */
size_t axis_tics(const struct axis *axis, struct axis_tic tics[AXIS_TICS]);

#endif
