/* svg.c - draws a timeline: a lane of the charged causes, and the lanes of the units
 * below it.
 *
 * Each box has a tooltip. The box contains its name if there is room.
 */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "asm/timeline/timeline_lanes.h"
#include "base/svg.h"
#include "base/plural.h"

/* Sizes in pixels. */
enum {
    LEFT = 130,
    WIDTH = 1200,
    RIGHT = 20,
    TOP = 60,
    ROW = 20,
    GAP = 8, /* space between lanes */
    LETTER = 7,
    KEY = 24 /* height of a row of the key */
};

static const char *const colors[C205_CAUSES] = {
    [C205_ISSUE] = "#8c8c8c",
    [C205_OPERAND_WAIT] = "#e0a030",
    [C205_UNIT_BUSY] = "#c07818",
    [C205_BRANCH] = "#b04a9a",
    [C205_MEMORY_WAIT] = "#d8503c",
    [C205_VECTOR_STARTUP] = "#5b9bd5",
    [C205_VECTOR_STREAM] = "#3f9b5f",
    [C205_BANK_CONFLICT] = "#8a6d3b",
    [C205_TRANSLATION_MISS] = "#7a5ac8",
    [C205_PAGE_FAULT] = "#4b3a8f",
};
static const char scalar_color[] = "#b9c4d0";

struct timeline_picture {
    const struct timeline *timeline;
    const struct sink *sink;
    struct lanes lanes;
    double scale;        /* pixels per clock */
    unsigned top[LANES]; /* the y coordinate of each lane */
    unsigned bottom;
};

static double x_of(const struct timeline_picture *picture, uint64_t clock)
{
    return LEFT + picture->scale * (double)(clock - picture->timeline->from);
}

static void place_lanes(struct timeline_picture *picture)
{
    unsigned at = TOP;
    for (int lane = 0; lane < LANES; lane++) {
        picture->top[lane] = at;
        if (picture->lanes.rows[lane] > 0)
            at += picture->lanes.rows[lane] * ROW + GAP;
    }
    picture->bottom = at;
}

/* ---- Axis and names -------------------------------------------------------- */

static void put_axis(const struct timeline_picture *picture)
{
    const struct timeline *timeline = picture->timeline;
    uint64_t step = svg_round_step(timeline->to - timeline->from, 12);
    uint64_t clock = (timeline->from + step - 1) / step * step;
    for (; clock <= timeline->to; clock += step)
        sink_print(picture->sink,
                   "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%d\" y2=\"%u\" "
                   "class=\"tick\"/><text x=\"%.1f\" y=\"%d\" "
                   "class=\"clock\">%" PRIu64 "</text>\n",
                   x_of(picture, clock), x_of(picture, clock), TOP - 6, picture->bottom,
                   x_of(picture, clock), TOP - 10, clock);
}

static void put_names(const struct timeline_picture *picture)
{
    for (int lane = 0; lane < LANES; lane++)
        if (picture->lanes.rows[lane] > 0)
            sink_print(picture->sink,
                       "<text x=\"%d\" y=\"%u\" class=\"lane\">%s</text>\n", LEFT - 8,
                       picture->top[lane] + 14, lane_name((enum lane)lane));
}

static void put_key(const struct timeline_picture *picture)
{
    unsigned y = picture->bottom + 6;
    int x = LEFT;
    for (int i = 0; i < C205_CAUSES; i++) {
        const char *name = c205_cause_name((c205_cause)i);
        int wide = 24 + LETTER * (int)strlen(name) + 12;
        if (x + wide > LEFT + WIDTH) {
            x = LEFT;
            y += KEY;
        }
        sink_print(picture->sink,
                   "<rect x=\"%d\" y=\"%u\" width=\"16\" height=\"14\" "
                   "fill=\"%s\"/><text x=\"%d\" y=\"%u\">%s</text>\n",
                   x, y, colors[i], x + 22, y + 12, name);
        x += wide;
    }
}

/* ---- Spans ----------------------------------------------------------------- */

static const char *label_of(const struct timed_span *span)
{
    return span->lane == LANE_CHARGED ? c205_cause_name(span->piece->cause)
                                      : span->insn->insn->mnemonic;
}

static void put_title(const struct timeline_picture *picture,
                      const struct timed_span *span)
{
    const struct timed_insn *insn = span->insn;
    sink_put(picture->sink, "<title>");
    if (span->piece)
        sink_print(picture->sink, "%s, ", c205_cause_name(span->piece->cause));
    sink_print(picture->sink,
               "%" PRIu64 " clock%s, %" PRIu64 " .. %" PRIu64 "\n%" PRIX64 ": ",
               span->end - span->begin, plural(span->end - span->begin), span->begin,
               span->end, insn->pc);
    svg_put_escaped(picture->sink, insn->text);
    if (*insn->line)
        sink_put(picture->sink, "\n");
    svg_put_escaped(picture->sink, insn->line);
    sink_print(picture->sink,
               "\narrived %" PRIu64 ", issued %" PRIu64 ", result %" PRIu64,
               insn->arrived, insn->issued, insn->ready);
    if (insn->elements > 0)
        sink_print(picture->sink, ", %zu element%s", insn->elements,
                   plural(insn->elements));
    sink_put(picture->sink, "</title>");
}

static void put_span(const struct timeline_picture *picture,
                     const struct timed_span *span)
{
    double x = x_of(picture, span->begin);
    double wide = x_of(picture, span->end) - x;
    unsigned y = picture->top[span->lane] + span->row * ROW;
    const char *label = label_of(span);
    sink_print(picture->sink,
               "<g><rect x=\"%.2f\" y=\"%u\" width=\"%.2f\" height=\"%d\" "
               "fill=\"%s\"/>",
               x, y, wide > .3 ? wide : .3, ROW - 3,
               span->piece ? colors[span->piece->cause] : scalar_color);
    put_title(picture, span);
    if (wide > LETTER * (double)strlen(label) + 6)
        sink_print(picture->sink, "<text x=\"%.1f\" y=\"%u\" class=\"%s\">%s</text>",
                   x + wide / 2, y + 13, span->piece ? "on" : "in", label);
    sink_put(picture->sink, "</g>\n");
}

static void put_head(const struct timeline_picture *picture, const char *title)
{
    struct svg_sheet sheet = {
        .width = LEFT + WIDTH + RIGHT,
        .height = (int)picture->bottom + 2 * KEY + 10,
        .left = LEFT,
        .style = "g rect{stroke:#fff;stroke-width:.6}"
                 ".tick{stroke:#ddd}.clock{text-anchor:middle;fill:#555}"
                 ".lane{text-anchor:end}.on{text-anchor:middle;fill:#fff}"
                 ".in{text-anchor:middle;fill:#222}"
                 "g:hover rect{stroke:#000}"
    };
    svg_begin(picture->sink, &sheet, title);
}

bool timeline_svg(const struct timeline *timeline, const char *title,
                  const struct sink *sink)
{
    struct arena arena = { NULL, false };
    struct timeline_picture picture = { .timeline = timeline, .sink = sink };
    bool good = lanes_make(timeline, &arena, &picture.lanes);
    picture.scale = WIDTH / (double)(timeline->to - timeline->from);
    place_lanes(&picture);
    put_head(&picture, title);
    put_axis(&picture);
    put_names(&picture);
    for (size_t i = 0; good && i < picture.lanes.count; i++)
        put_span(&picture, &picture.lanes.spans[i]);
    put_key(&picture);
    svg_end(sink);
    arena_free(&arena);
    return good;
}
