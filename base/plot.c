/* plot.c - draws columns of a table as curves in an SVG picture.
 *
 * The title and the small print are above the frame. The small print has an additional
 * line if y is cut off. The labels of marks are below the small print, each next to the
 * line of its mark, in several rows if necessary. The key is on the right. No text
 * covers a curve.
 */
#include "base/plot.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/plot_axis.h"
#include "base/svg.h"
#include "vm/error.h"

/* The layout in pixels. */
enum {
    WIDTH = 800,
    HEIGHT = 500,
    EDGE = 16,
    LETTER = 7, /* the width of most letters in pixels, slightly overestimated */
    ABOVE = 40, /* base line of the small print, below the title */
    LINE = 16,
    BELOW = 58,   /* height of labels and title of the x axis */
    BESIDE = 52,  /* width of the title of the y axis, without labels */
    MIN_KEY = 90, /* minimum room on the right for the key and labels of marks */
    MAX_KEY = 320,
    KEY_SAMPLE = 48,
    KEY_ROW = 22
};

/* Colours that colour-blind readers can distinguish: M. Okabe and K. Ito, "Color
 * Universal Design", 2008. Greys replace the black of that palette and colour further
 * curves. */
static const char *const colors[] = {
    "#0072B2", "#D55E00", "#009E73", "#E69F00", "#56B4E9",
    "#CC79A7", "#444444", "#F0E442", "#999999", "#CCCCCC",
};
enum { COLORS = sizeof colors / sizeof *colors };

static const char *const dashes[] = { "6 4", "2 3", "9 3 2 3", "1 2" };
enum { DASHES = sizeof dashes / sizeof *dashes };

/* The label of a mark. It begins at the line of the mark, or ends at the edge of the
 * picture. */
struct flag {
    const struct plot_mark *mark;
    double line, begin, end;
    int row; /* counts upwards from 0 */
};

struct plot_picture {
    const struct plot *plot;
    const struct table *table;
    const struct sink *sink;
    struct axis x, y;
    double cut_off; /* the highest value if y is limited below it, otherwise NaN */
    double left, right, top, bottom;
    size_t flag_count;
    struct flag flags[MAX_PLOT_MARKS];
};

/* ---- Values --------------------------------------------------------------- */

static double x_of(const struct plot_picture *picture, size_t row)
{
    return table_value(picture->table, row, picture->plot->x_column);
}

static double y_of(const struct plot_picture *picture, size_t row, size_t curve)
{
    return table_value(picture->table, row, picture->plot->curves[curve].column);
}

/* Returns the sum of the first `curves` curves in a row of the table. */
static double sum_of(const struct plot_picture *picture, size_t row, size_t curves)
{
    double sum = 0;
    for (size_t i = 0; i < curves; i++)
        sum += y_of(picture, row, i);
    return sum;
}

static bool reach(struct axis *axis, double value, const char *key, c205_error *error)
{
    if (!isfinite(value))
        return true;
    if (!axis_shows(axis, value))
        return error_set(error, "%.60s: %g cannot be drawn on a logarithmic axis", key,
                         value);
    axis_reach(axis, value);
    return true;
}

static bool reach_row(struct plot_picture *picture, size_t row, c205_error *error)
{
    const struct plot *plot = picture->plot;
    bool areas = plot->form == PLOT_AREAS;
    for (size_t i = 0; i < plot->curve_count; i++) {
        const char *key = table_key(picture->table, plot->curves[i].column);
        double value = y_of(picture, row, i);
        if (areas && value < 0)
            return error_set(error, "%.60s: an area of %g cannot be drawn", key, value);
        if (!reach(&picture->y, areas ? sum_of(picture, row, i + 1) : value, key,
                   error))
            return false;
    }
    return reach(&picture->x, x_of(picture, row),
                 table_key(picture->table, plot->x_column), error);
}

static bool reach_marks(struct axis *axis, const struct plot_mark *marks, size_t count,
                        c205_error *error)
{
    for (size_t i = 0; i < count; i++)
        if (!reach(axis, marks[i].at, marks[i].label, error))
            return false;
    return true;
}

static bool is_empty(const struct axis *axis)
{
    return axis->low > axis->high;
}

/* Extends the axes to all values that are drawn. */
static bool find_axes(struct plot_picture *picture, c205_error *error)
{
    const struct plot *plot = picture->plot;
    struct axis *x = &picture->x, *y = &picture->y;
    double highest;
    *x = axis_new(plot->x.scale);
    *y = axis_new(plot->form == PLOT_AREAS ? PLOT_LINEAR : plot->y.scale);
    for (size_t row = 0; row < table_rows(picture->table); row++)
        if (!reach_row(picture, row, error))
            return false;
    if (is_empty(x) || is_empty(y))
        return error_set(error, "%.180s: nothing to draw", plot->title);
    highest = y->high;
    if (plot->y_most > y->low)
        y->high = fmin(y->high, plot->y_most);
    if (!reach_marks(x, plot->marks, plot->mark_count, error)
        || !reach_marks(y, plot->levels, plot->level_count, error))
        return false;
    axis_widen(x);
    axis_widen(y);
    axis_round(y);
    picture->cut_off = highest > y->high ? highest : NAN;
    if (plot->form == PLOT_LINES)
        axis_pad(x);
    return true;
}

/* ---- Layout --------------------------------------------------------------- */

/* Returns the width of a text in pixels. */
static double text_width(const char *text)
{
    size_t letters = 0;
    for (; *text != '\0'; text++)
        letters += ((unsigned char)*text & 0xC0) != 0x80;
    return LETTER * (double)letters;
}

static double widest_label(const struct axis *axis)
{
    struct axis_tic tics[AXIS_TICS];
    size_t count = axis_tics(axis, tics);
    double widest = 0;
    for (size_t i = 0; i < count; i++)
        widest = fmax(widest, text_width(tics[i].label));
    return widest;
}

static double key_width(const struct plot *plot)
{
    double widest = 0;
    for (size_t i = 0; i < plot->curve_count; i++)
        widest = fmax(widest, text_width(plot->curves[i].title));
    for (size_t i = 0; i < plot->level_count; i++)
        widest = fmax(widest, text_width(plot->levels[i].label));
    return fmax(MIN_KEY, fmin(MAX_KEY, KEY_SAMPLE + widest));
}

static double across(const struct plot_picture *picture, double x)
{
    return picture->left
           + axis_place(&picture->x, x) * (picture->right - picture->left);
}

static double up(const struct plot_picture *picture, double y)
{
    return picture->bottom
           - axis_place(&picture->y, y) * (picture->bottom - picture->top);
}

static int from_right(const void *left, const void *right)
{
    double a = ((const struct flag *)left)->line;
    double b = ((const struct flag *)right)->line;
    return (a < b) - (a > b);
}

/* Returns a row for a label. It is above all labels to the right that the label would
 * cover or whose lines it would cross. */
static int row_of(const struct flag *flags, size_t i)
{
    int row = 0;
    for (size_t j = 0; j < i; j++)
        if (flags[j].begin < flags[i].end + LETTER && flags[j].row >= row)
            row = flags[j].row + 1;
    return row;
}

/* Places the labels of the marks. Returns the number of rows. */
static int place_flags(struct plot_picture *picture)
{
    const struct plot *plot = picture->plot;
    struct flag *flags = picture->flags;
    size_t count = 0;
    int rows = 0;
    for (size_t i = 0; i < plot->mark_count; i++) {
        const struct plot_mark *mark = &plot->marks[i];
        double line = across(picture, mark->at);
        double width = LETTER + text_width(mark->label);
        double begin = fmin(line, WIDTH - EDGE - width);
        if (isfinite(mark->at))
            flags[count++] = (struct flag){ mark, line, begin, begin + width, 0 };
    }
    qsort(flags, count, sizeof *flags, from_right);
    for (size_t i = 0; i < count; i++) {
        flags[i].row = row_of(flags, i);
        rows = flags[i].row >= rows ? flags[i].row + 1 : rows;
    }
    picture->flag_count = count;
    return rows;
}

static void lay_out_plot(struct plot_picture *picture)
{
    const struct plot *plot = picture->plot;
    size_t small_print = plot->subtitle_count + (isfinite(picture->cut_off) ? 1 : 0);
    picture->left = BESIDE + widest_label(&picture->y);
    picture->right = WIDTH - key_width(plot);
    picture->bottom = HEIGHT - BELOW;
    picture->top = ABOVE + LINE * ((double)small_print + place_flags(picture));
}

/* ---- Text ----------------------------------------------------------------- */

static void put_svg_text(const struct plot_picture *picture, double x, double y,
                         const char *kind, const char *text)
{
    sink_print(picture->sink, "<text x=\"%.1f\" y=\"%.1f\" class=\"%s\">", x, y, kind);
    svg_put_escaped(picture->sink, text);
    sink_put(picture->sink, "</text>\n");
}

static void put_small_print(const struct plot_picture *picture)
{
    const struct plot *plot = picture->plot;
    char end[AXIS_LABEL_SIZE], highest[AXIS_LABEL_SIZE], text[128];
    double line = ABOVE;
    for (size_t i = 0; i < plot->subtitle_count; i++, line += LINE)
        put_svg_text(picture, picture->left, line, "small", plot->subtitles[i]);
    if (!isfinite(picture->cut_off))
        return;
    axis_label(end, picture->y.high);
    axis_label(highest, picture->cut_off);
    snprintf(text, sizeof text, "cut off at %s; the highest value is %s", end, highest);
    put_svg_text(picture, picture->left, line, "small", text);
}

/* ---- Axes ----------------------------------------------------------------- */

/* Draws a tic, its label and a line of the grid. */
static void put_x_tic(const struct plot_picture *picture, const struct axis_tic *tic)
{
    double at = across(picture, tic->at);
    bool labelled = tic->label[0] != '\0';
    if (labelled)
        sink_print(picture->sink, "<path d=\"M%.1f %.1fV%.1f\" class=\"grid\"/>", at,
                   picture->bottom, picture->top);
    sink_print(picture->sink, "<path d=\"M%.1f %.1fv%d\" class=\"axis\"/>\n", at,
               picture->bottom, labelled ? 5 : 3);
    if (labelled)
        put_svg_text(picture, at, picture->bottom + 19, "at", tic->label);
}

static void put_y_tic(const struct plot_picture *picture, const struct axis_tic *tic)
{
    double at = up(picture, tic->at);
    bool labelled = tic->label[0] != '\0';
    if (labelled)
        sink_print(picture->sink, "<path d=\"M%.1f %.1fH%.1f\" class=\"grid\"/>",
                   picture->left, at, picture->right);
    sink_print(picture->sink, "<path d=\"M%.1f %.1fh%d\" class=\"axis\"/>\n",
               picture->left, at, labelled ? -5 : -3);
    if (labelled)
        put_svg_text(picture, picture->left - 9, at + 4, "up", tic->label);
}

static void put_axes(const struct plot_picture *picture)
{
    struct axis_tic tics[AXIS_TICS];
    size_t count = axis_tics(&picture->x, tics);
    for (size_t i = 0; i < count; i++)
        put_x_tic(picture, &tics[i]);
    count = axis_tics(&picture->y, tics);
    for (size_t i = 0; i < count; i++)
        put_y_tic(picture, &tics[i]);
    sink_print(picture->sink, "<path d=\"M%.1f %.1fV%.1fH%.1f\" class=\"axis\"/>\n",
               picture->left, picture->top, picture->bottom, picture->right);
    put_svg_text(picture, (picture->left + picture->right) / 2, picture->bottom + 40,
                 "at", picture->plot->x.title);
    sink_print(picture->sink,
               "<text transform=\"translate(18 %.1f) rotate(-90)\" class=\"at\">",
               (picture->top + picture->bottom) / 2);
    svg_put_escaped(picture->sink, picture->plot->y.title);
    sink_put(picture->sink, "</text>\n");
}

/* ---- Curves --------------------------------------------------------------- */

/* Adds a point to a path. A point that is not finite ends the line. */
static void put_vertex(const struct plot_picture *picture, double x, double y,
                       bool *joined)
{
    bool finite = isfinite(x) && axis_shows(&picture->y, y);
    if (finite)
        sink_print(picture->sink, "%c%.1f %.1f", *joined ? 'L' : 'M',
                   across(picture, x), up(picture, y));
    *joined = finite;
}

/* Draws a fitted line between the first and the last x. It is a polygon, because a
 * straight line is curved on logarithmic axes. */
static void put_fitted(const struct plot_picture *picture, const struct plot_line *line)
{
    enum { PARTS = 120 };
    double first = axis_place(&picture->x, x_of(picture, 0));
    double last = axis_place(&picture->x,
                             x_of(picture, table_rows(picture->table) - 1));
    bool joined = false;
    for (int i = 0; i <= PARTS; i++) {
        double x = axis_value(&picture->x, first + (last - first) * i / PARTS);
        put_vertex(picture, x, line->start + line->slope * x, &joined);
    }
}

/* Draws the points, each with a tooltip. */
static void put_points(const struct plot_picture *picture, size_t curve)
{
    for (size_t row = 0; row < table_rows(picture->table); row++) {
        double x = x_of(picture, row), y = y_of(picture, row, curve);
        char x_label[AXIS_LABEL_SIZE], y_label[AXIS_LABEL_SIZE];
        if (!isfinite(x) || !isfinite(y))
            continue;
        axis_label(x_label, x);
        axis_label(y_label, y);
        sink_print(picture->sink,
                   "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2.5\" fill=\"%s\"><title>",
                   across(picture, x), up(picture, y), colors[curve % COLORS]);
        svg_put_escaped(picture->sink, picture->plot->curves[curve].title);
        sink_print(picture->sink, ": %s, %s</title></circle>\n", x_label, y_label);
    }
}

static void put_line(const struct plot_picture *picture, size_t curve)
{
    const struct plot_line *fitted = picture->plot->curves[curve].fitted;
    bool joined = false;
    sink_print(picture->sink,
               "<path fill=\"none\" stroke=\"%s\" stroke-width=\"1.8\" d=\"",
               colors[curve % COLORS]);
    if (fitted)
        put_fitted(picture, fitted);
    for (size_t row = 0; !fitted && row < table_rows(picture->table); row++)
        put_vertex(picture, x_of(picture, row), y_of(picture, row, curve), &joined);
    sink_put(picture->sink, "\"/>\n");
    put_points(picture, curve);
}

static bool has_area(const struct plot_picture *picture, size_t row)
{
    return isfinite(x_of(picture, row))
           && isfinite(sum_of(picture, row, picture->plot->curve_count));
}

/* Draws the area of a curve in a stack. Its lower edge is the sum of the curves before
 * it, its upper edge the sum with this curve. An empty cell ends an area, and the next
 * row with values begins another. */
static void put_area(const struct plot_picture *picture, size_t curve)
{
    size_t rows = table_rows(picture->table);
    sink_print(picture->sink, "<path fill=\"%s\" d=\"", colors[curve % COLORS]);
    for (size_t first = 0, end; first < rows; first = end + 1) {
        bool joined = false;
        for (end = first; end < rows && has_area(picture, end); end++)
            put_vertex(picture, x_of(picture, end), sum_of(picture, end, curve + 1),
                       &joined);
        for (size_t row = end; row > first; row--)
            put_vertex(picture, x_of(picture, row - 1), sum_of(picture, row - 1, curve),
                       &joined);
        sink_put(picture->sink, joined ? "Z" : "");
    }
    sink_put(picture->sink, "\"/>\n");
}

/* Draws the curves in a nested picture, which clips them at the frame. */
static void put_curves(const struct plot_picture *picture)
{
    double width = picture->right - picture->left;
    double height = picture->bottom - picture->top;
    sink_print(picture->sink,
               "<svg x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" "
               "viewBox=\"%.1f %.1f %.1f %.1f\" overflow=\"%s\">\n",
               picture->left, picture->top, width, height, picture->left, picture->top,
               width, height, isfinite(picture->cut_off) ? "hidden" : "visible");
    for (size_t i = 0; i < picture->plot->curve_count; i++)
        (picture->plot->form == PLOT_AREAS ? put_area : put_line)(picture, i);
    sink_put(picture->sink, "</svg>\n");
}

/* ---- Marks and the key ---------------------------------------------------- */

static void put_flag(const struct plot_picture *picture, const struct flag *flag)
{
    double base = picture->top - 5 - LINE * flag->row;
    bool moved = flag->begin < flag->line;
    sink_print(picture->sink, "<path d=\"M%.1f %.1fV%.1f\" class=\"mark\"/>",
               flag->line, picture->bottom, base + (moved ? 4 : -10));
    put_svg_text(picture, moved ? WIDTH - EDGE : flag->line + 4, base,
                 moved ? "end" : "name", flag->mark->label);
}

static void put_level(const struct plot_picture *picture, size_t level, double left,
                      double right, double y)
{
    sink_print(picture->sink,
               "<path d=\"M%.1f %.1fH%.1f\" class=\"level\" "
               "stroke-dasharray=\"%s\"/>\n",
               left, y, right, dashes[level % DASHES]);
}

/* Draws a sample of a curve at the base line of its name. */
static void put_sample(const struct plot_picture *picture, size_t curve, double y)
{
    double x = picture->right + 10;
    const char *color = colors[curve % COLORS];
    if (picture->plot->form == PLOT_AREAS)
        sink_print(picture->sink, "<path d=\"M%.1f %.1fh26v10h-26z\" fill=\"%s\"/>\n",
                   x, y - 9, color);
    else
        sink_print(picture->sink,
                   "<path d=\"M%.1f %.1fh26\" stroke=\"%s\" stroke-width=\"1.8\"/>"
                   "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2.5\" fill=\"%s\"/>\n",
                   x, y - 4, color, x + 13, y - 4, color);
}

/* Draws the horizontal lines of plot->levels, and the key. In a plot of stacked areas,
 * the order of the key is the order of the areas from top to bottom. */
static void put_key(const struct plot_picture *picture)
{
    const struct plot *plot = picture->plot;
    double y = picture->top + LINE, x = picture->right + 10;
    for (size_t i = 0; i < plot->curve_count; i++, y += KEY_ROW) {
        size_t curve = plot->form == PLOT_AREAS ? plot->curve_count - 1 - i : i;
        put_sample(picture, curve, y);
        put_svg_text(picture, x + 34, y, "name", plot->curves[curve].title);
    }
    for (size_t i = 0; i < plot->level_count; i++) {
        double at = plot->levels[i].at;
        if (!isfinite(at))
            continue;
        put_level(picture, i, picture->left, picture->right, up(picture, at));
        put_level(picture, i, x, x + 26, y - 4);
        put_svg_text(picture, x + 34, y, "name", plot->levels[i].label);
        y += KEY_ROW;
    }
}

#define PLOT_STYLE \
    ".axis{stroke:#555;fill:none}.small{font-size:11px;fill:#555}" \
    ".at{text-anchor:middle;fill:#444}.up,.end{text-anchor:end}.up{fill:#444}" \
    ".mark{stroke:#444}.level{stroke:#000;stroke-width:1.5}"

/* Draws the parts of a picture. The grid comes after the areas, because they would
 * cover it. */
static void put_picture(const struct plot_picture *picture)
{
    bool areas = picture->plot->form == PLOT_AREAS;
    const struct svg_sheet sheet = {
        .width = WIDTH,
        .height = HEIGHT,
        .left = (int)picture->left,
        .style = areas ? ".grid{stroke:#fff;stroke-opacity:.35}" PLOT_STYLE
                       : ".grid{stroke:#e0e0e0}" PLOT_STYLE
    };
    svg_begin(picture->sink, &sheet, picture->plot->title);
    put_small_print(picture);
    if (areas)
        put_curves(picture);
    put_axes(picture);
    if (!areas)
        put_curves(picture);
    put_key(picture);
    for (size_t i = 0; i < picture->flag_count; i++)
        put_flag(picture, &picture->flags[i]);
    svg_end(picture->sink);
}

bool plot_draw(const struct plot *plot, const struct table *table,
               const struct sink *sink, c205_error *error)
{
    struct plot_picture picture = { .plot = plot, .table = table, .sink = sink };
    if (!table || !table_is_whole(table))
        return error_set(error, "%.180s: out of memory", plot->title);
    if (!find_axes(&picture, error))
        return false;
    lay_out_plot(&picture);
    put_picture(&picture);
    return true;
}
