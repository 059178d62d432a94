/* plot.c - draws a sweep: clocks against the constant, on logarithmic axes.
 *
 * A line start-up + value / rate is a curve on these axes: flat while the start-up
 * dominates, and steep from n-half on, where the clocks are twice the start-up.
 */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "asm/sweep/swept.h"
#include "base/accounts.h"
#include "base/plural.h"
#include "base/svg.h"

/* Pixels. */
enum {
    LEFT = 90,
    WIDTH = 760,
    RIGHT = 30,
    KEY = 38, /* y of the first row of the key */
    ROW = 18,
    HEIGHT = 400,
    BELOW = 52
};
/* Most ticks with labels on an axis. */
enum { MAX_TICKS = 14, LABEL = 32 };
/* Marks: half lengths, and as many crossings as fit. */
enum { MAX_MARKS = SWEPT_PROGRAMS + 4 };

static const char *const colors[SWEPT_PROGRAMS] = { "#2f6fb0", "#c0561c" };

struct log_axis {
    double low, high;     /* shown range */
    double begin, length; /* pixels; length < 0: upwards */
};

struct swept_picture {
    const struct program_sweep *sweep;
    const struct sink *sink;
    struct swept_line lines[SWEPT_PROGRAMS];
    struct log_axis x, y;
    int top;
    int mark_count;
    struct swept_mark {
        double x, y;
        const char *color;
        char label[3 * LABEL];
    } marks[MAX_MARKS];
};

static double place_on(const struct log_axis *axis, double value)
{
    return axis->begin
           + axis->length * log(value / axis->low) / log(axis->high / axis->low);
}

static double clocks_of(const struct swept_point *point, size_t which)
{
    return (double)accounts_clocks(&point->runs[which]);
}

/* ---- Axes ------------------------------------------------------------------ */

/* Sets the range of the axes: a little more than that of the points, with room below
 * for the labels of the marks. */
static void set_axes(struct swept_picture *picture)
{
    const struct program_sweep *sweep = picture->sweep;
    double low = INFINITY, high = 0, room;

    for (size_t i = 0; i < sweep->count; i++)
        for (size_t k = 0; k < sweep->program_count; k++) {
            double clocks = clocks_of(&sweep->points[i], k);

            low = fmin(low, clocks);
            high = fmax(high, clocks);
        }
    picture->top = KEY + ROW * (int)sweep->program_count;
    room = pow(fmax(high / low, 1.2), .04);
    picture->y = (struct log_axis){ low / pow(room, 5), high * room,
                                    picture->top + HEIGHT, -HEIGHT };
    low = (double)sweep->range.from;
    high = (double)sweep->range.to;
    room = pow(high / low, .02);
    picture->x = (struct log_axis){ low / room, high * room, LEFT, WIDTH };
}

/* Writes "16,384". */
static void label_of(uint64_t value, char label[LABEL])
{
    char digits[LABEL];
    int length = snprintf(digits, sizeof digits, "%" PRIu64, value);

    for (int i = 0; i <= length; i++) {
        if (i > 0 && i < length && (length - i) % 3 == 0)
            *label++ = ',';
        *label++ = digits[i];
    }
}

static void put_tick(const struct swept_picture *picture, bool upright, uint64_t value,
                     bool labelled)
{
    const struct log_axis *axis = upright ? &picture->x : &picture->y;
    double at = place_on(axis, (double)value);
    int bottom = picture->top + HEIGHT;
    char label[LABEL];

    label_of(value, label);
    sink_print(picture->sink, "<path d=\"M%.1f %.1f%c%d\" class=\"tick\"/>",
               upright ? at : LEFT, upright ? bottom : at, upright ? 'V' : 'H',
               upright ? picture->top : LEFT + WIDTH);
    if (labelled && upright)
        sink_print(picture->sink, "<text x=\"%.1f\" y=\"%d\" class=\"at\">%s</text>",
                   at, bottom + 17, label);
    else if (labelled)
        sink_print(picture->sink, "<text x=\"%d\" y=\"%.1f\" class=\"up\">%s</text>",
                   LEFT - 8, at + 4, label);
    sink_put(picture->sink, "\n");
}

/* Writes evenly spaced ticks, for an axis of less than two octaves. */
static void put_even_ticks(const struct swept_picture *picture, bool upright,
                           const struct log_axis *axis)
{
    uint64_t step = svg_round_step((uint64_t)(axis->high - axis->low), 8);
    uint64_t value = ((uint64_t)axis->low / step + 1) * step;

    for (; (double)value <= axis->high; value += step)
        put_tick(picture, upright, value, true);
}

/* Writes ticks at 1, 2 and 5 times the powers of ten. All have labels if these fit;
 * otherwise only the powers of ten have. */
static void put_ticks(const struct swept_picture *picture, bool upright)
{
    const struct log_axis *axis = upright ? &picture->x : &picture->y;
    static const unsigned parts[] = { 1, 2, 5 };
    bool all = 3 * log10(axis->high / axis->low) <= MAX_TICKS;

    if (axis->high < 4 * axis->low) {
        put_even_ticks(picture, upright, axis);
        return;
    }
    for (uint64_t power = 1; (double)power <= axis->high; power *= 10)
        for (int i = 0; i < 3; i++) {
            uint64_t value = power * parts[i];

            if ((double)value >= axis->low && (double)value <= axis->high)
                put_tick(picture, upright, value, all || i == 0);
        }
}

static void put_axes(const struct swept_picture *picture)
{
    int bottom = picture->top + HEIGHT;

    put_ticks(picture, true);
    put_ticks(picture, false);
    sink_print(picture->sink,
               "<path d=\"M%d %dV%dH%d\" class=\"axis\"/>\n"
               "<text x=\"%d\" y=\"%d\" class=\"at\">",
               LEFT, picture->top, bottom, LEFT + WIDTH, LEFT + WIDTH / 2, bottom + 40);
    svg_put_escaped(picture->sink, picture->sweep->constant);
    sink_print(picture->sink,
               "</text>\n<text transform=\"translate(18 %d) rotate(-90)\" "
               "class=\"at\">clocks</text>\n",
               picture->top + HEIGHT / 2);
}

/* ---- Programs -------------------------------------------------------------- */

/* Writes the name of a program and the formula of its line. */
static void put_key(const struct swept_picture *picture, size_t which)
{
    const struct swept_line *line = &picture->lines[which];
    int y = KEY + ROW * (int)which;

    sink_print(picture->sink,
               "<circle cx=\"%d\" cy=\"%d\" r=\"4\" fill=\"%s\"/>"
               "<text x=\"%d\" y=\"%d\">",
               LEFT + 6, y, colors[which], LEFT + 18, y + 4);
    svg_put_escaped(picture->sink, picture->sweep->programs[which].path);
    if (line->good)
        sink_print(picture->sink, ": %.1f + %.4g ", line->clocks.at_zero,
                   line->clocks.slope);
    else
        sink_put(picture->sink,
                 line->grows ? ": no straight line in " : ": does not grow with ");
    svg_put_escaped(picture->sink, picture->sweep->constant);
    sink_print(picture->sink, "%s</text>\n", line->good ? " clocks" : "");
}

/* Draws the fitted line, or the polygon of the points if there is no line. */
static void put_curve(const struct swept_picture *picture, size_t which)
{
    enum { PARTS = 120 };
    const struct program_sweep *sweep = picture->sweep;
    const struct swept_line *line = &picture->lines[which];
    const struct swept_range *range = &sweep->range;
    size_t parts = line->good ? PARTS : sweep->count - 1;

    sink_print(picture->sink,
               "<path fill=\"none\" stroke=\"%s\" stroke-width=\"%s\" d=\"",
               colors[which], line->good ? "1.6" : ".7");
    for (size_t i = 0; i <= parts; i++) {
        double value = line->good ? (double)range->from
                                        * pow((double)range->to / (double)range->from,
                                              (double)i / (double)parts)
                                  : (double)sweep->points[i].value;
        double clocks = line->good ? straight_line_at(&line->clocks, value)
                                   : clocks_of(&sweep->points[i], which);

        sink_print(picture->sink, "%s%.1f %.1f", i > 0 ? "L" : "M",
                   place_on(&picture->x, value), place_on(&picture->y, clocks));
    }
    sink_put(picture->sink, "\"/>\n");
}

/* Draws the points, each with a tooltip. */
static void put_points(const struct swept_picture *picture, size_t which)
{
    const struct program_sweep *sweep = picture->sweep;

    for (size_t i = 0; i < sweep->count; i++) {
        const struct swept_point *point = &sweep->points[i];
        double clocks = clocks_of(point, which);

        sink_print(picture->sink,
                   "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%s\" fill=\"%s\">"
                   "<title>",
                   place_on(&picture->x, (double)point->value),
                   place_on(&picture->y, clocks), sweep->count > 60 ? "2" : "3",
                   colors[which]);
        svg_put_escaped(picture->sink, sweep->constant);
        sink_print(picture->sink, " = %" PRIu64 ": %.0f clock%s</title></circle>\n",
                   point->value, clocks, plural((uint64_t)clocks));
    }
}

/* ---- Marks ----------------------------------------------------------------- */

/* Adds a mark, whose label the caller writes. Returns NULL if there is no room. */
static struct swept_mark *new_mark(struct swept_picture *picture, double value,
                                   double clocks, const char *color)
{
    struct swept_mark *mark = &picture->marks[picture->mark_count];

    if (picture->mark_count == MAX_MARKS)
        return NULL;
    picture->mark_count++;
    mark->x = place_on(&picture->x, value);
    mark->y = place_on(&picture->y, clocks);
    mark->color = color;
    return mark;
}

static void mark_half(struct swept_picture *picture, size_t which)
{
    const struct swept_range *range = &picture->sweep->range;
    const struct swept_line *line = &picture->lines[which];
    double half = swept_half_length(line);
    struct swept_mark *mark;

    if (!line->good || half < (double)range->from || half > (double)range->to)
        return;
    mark = new_mark(picture, half, straight_line_at(&line->clocks, half),
                    colors[which]);
    snprintf(mark->label, sizeof mark->label, "n-half %.1f", half);
}

static void mark_crossing(struct swept_picture *picture,
                          const struct swept_crossing *crossing)
{
    struct swept_mark *mark = new_mark(picture, (double)crossing->at.value,
                                       clocks_of(&crossing->at, SWEPT_SECOND), "#333");
    char value[LABEL];

    if (!mark)
        return;
    label_of(crossing->at.value, value);
    snprintf(mark->label, sizeof mark->label, "from %s on the second is %s", value,
             crossing->faster ? "faster" : "not faster any more");
}

static void find_marks(struct swept_picture *picture)
{
    for (size_t i = 0; i < picture->sweep->program_count; i++)
        mark_half(picture, i);
    for (size_t i = 0; i < picture->sweep->crossing_count; i++)
        mark_crossing(picture, &picture->sweep->crossings[i]);
}

/* Draws a ring for each mark and a line from it down to the axis. The labels are drawn
 * after all lines, each in its own row, on the side with more room. */
static void put_marks(const struct swept_picture *picture)
{
    int bottom = picture->top + HEIGHT;

    for (int i = 0; i < picture->mark_count; i++) {
        const struct swept_mark *mark = &picture->marks[i];

        sink_print(picture->sink,
                   "<path d=\"M%.1f %.1fV%d\" stroke=\"%s\" "
                   "class=\"mark\"/><circle cx=\"%.1f\" cy=\"%.1f\" r=\"6\" "
                   "fill=\"none\" stroke=\"%s\"/>\n",
                   mark->x, mark->y + 6, bottom, mark->color, mark->x, mark->y,
                   mark->color);
    }
    for (int i = 0; i < picture->mark_count; i++) {
        const struct swept_mark *mark = &picture->marks[i];
        bool right = mark->x < LEFT + WIDTH / 2;

        sink_print(picture->sink,
                   "<text x=\"%.1f\" y=\"%d\" text-anchor=\"%s\" "
                   "fill=\"%s\" class=\"label\">%s</text>\n",
                   right ? mark->x + 6 : mark->x - 6, bottom - 8 - 15 * i,
                   right ? "start" : "end", mark->color, mark->label);
    }
}

void swept_title(const struct program_sweep *sweep, char title[SWEPT_TITLE])
{
    snprintf(title, SWEPT_TITLE, "Clocks against %.40s on %.80s", sweep->constant,
             c205_model_name(sweep->model));
}

void swept_svg(const struct program_sweep *sweep, const char *title,
               const struct sink *sink)
{
    struct swept_picture picture = { .sweep = sweep, .sink = sink };
    struct svg_sheet sheet = {
        .width = LEFT + WIDTH + RIGHT,
        .left = LEFT,
        .style = ".tick{stroke:#e4e4e4}.axis{stroke:#555;fill:none}"
                 ".at{text-anchor:middle;fill:#333}"
                 ".up{text-anchor:end;fill:#333}"
                 ".mark{stroke-dasharray:4 3;fill:none}"
                 ".label{paint-order:stroke;stroke:#fff;stroke-width:4}"
    };

    set_axes(&picture);
    sheet.height = picture.top + HEIGHT + BELOW;
    svg_begin(sink, &sheet, title);
    put_axes(&picture);
    for (size_t i = 0; i < sweep->program_count; i++) {
        picture.lines[i] = swept_line_of(sweep, (int)i);
        put_key(&picture, i);
        put_curve(&picture, i);
        put_points(&picture, i);
    }
    find_marks(&picture);
    put_marks(&picture);
    svg_end(sink);
}
