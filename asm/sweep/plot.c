/* plot.c - draws the clocks of a sweep over the constant, on logarithmic axes.
 *
 * On these axes a line start-up + value / rate is a curve. It is flat where the
 * start-up dominates. It is steep from n-half on, where the clocks are twice the
 * start-up.
 */
#include <stdio.h>

#include "asm/sweep/swept.h"
#include "base/plot.h"
#include "base/plot_axis.h"

enum { LABEL = 80, FORMULA = 240 };

struct swept_plot {
    const struct program_sweep *sweep;
    struct plot_curve curves[SWEPT_PROGRAMS];
    struct plot_line lines[SWEPT_PROGRAMS];
    char formulas[SWEPT_PROGRAMS][FORMULA];
    const char *subtitles[SWEPT_PROGRAMS];
    size_t mark_count;
    struct plot_mark marks[MAX_PLOT_MARKS];
    char labels[MAX_PLOT_MARKS][LABEL];
};

/* Adds a mark to the axis of the plot. The caller writes its label to the returned
 * buffer. */
static char *new_mark(struct swept_plot *plot, double at)
{
    char *label = plot->labels[plot->mark_count];
    plot->marks[plot->mark_count++] = (struct plot_mark){ at, label };
    return label;
}

/* Writes the name of a program and the formula of its line. */
static void write_formula(struct swept_plot *plot, int which,
                          const struct swept_line *line)
{
    const struct program_sweep *sweep = plot->sweep;
    char formula[LABEL];
    if (line->good)
        snprintf(formula, sizeof formula, "%.1f + %.4g", line->clocks.at_zero,
                 line->clocks.slope);
    else
        snprintf(formula, sizeof formula, "%s",
                 line->grows ? "no straight line in" : "does not grow with");
    snprintf(plot->formulas[which], FORMULA, "%s, %.80s: %s %.40s%s",
             swept_names[which], sweep->programs[which].path, formula, sweep->constant,
             line->good ? " clocks" : "");
    plot->subtitles[which] = plot->formulas[which];
}

static void add_program(struct swept_plot *plot, int which)
{
    const struct swept_range *range = &plot->sweep->range;
    struct swept_line line = swept_line_of(plot->sweep, which);
    double half = swept_half_length(&line);
    plot->lines[which] = (struct plot_line){ line.clocks.at_zero, line.clocks.slope };
    plot->curves[which] = (struct plot_curve){ swept_clocks_column(which),
                                               swept_names[which],
                                               line.good ? &plot->lines[which] : NULL };
    write_formula(plot, which, &line);
    if (line.good && half >= (double)range->from && half <= (double)range->to)
        snprintf(new_mark(plot, half), LABEL, "%s: n-half %.1f", swept_names[which],
                 half);
}

/* Marks crossings until there is no room for more. */
static void mark_crossings(struct swept_plot *plot)
{
    const struct program_sweep *sweep = plot->sweep;
    for (size_t i = 0; i < sweep->crossing_count && plot->mark_count < MAX_PLOT_MARKS;
         i++) {
        double at = (double)sweep->crossings[i].at.value;
        char value[AXIS_LABEL_SIZE];

        axis_label(value, at);
        snprintf(new_mark(plot, at), LABEL, "from %s on the second is %s", value,
                 sweep->crossings[i].faster ? "faster" : "not faster any more");
    }
}

void swept_title(const struct program_sweep *sweep, char title[SWEPT_TITLE])
{
    snprintf(title, SWEPT_TITLE, "Clocks against %.40s on %.80s", sweep->constant,
             c205_model_name(sweep->model));
}

bool swept_svg(const struct program_sweep *sweep, const char *title,
               const struct sink *sink, c205_error *error)
{
    struct swept_plot swept = { .sweep = sweep };
    struct plot plot = { .title = title,
                         .subtitles = swept.subtitles,
                         .subtitle_count = sweep->program_count,
                         .x = { sweep->constant, PLOT_LOG10 },
                         .y = { "clocks", PLOT_LOG10 },
                         .curves = swept.curves,
                         .curve_count = sweep->program_count,
                         .marks = swept.marks };
    struct table *points = swept_points(sweep);
    bool good;
    for (size_t i = 0; i < sweep->program_count; i++)
        add_program(&swept, (int)i);
    mark_crossings(&swept);
    plot.mark_count = swept.mark_count;
    good = plot_draw(&plot, points, sink, error);
    table_free(points);
    return good;
}
