/* color_scale.c - draws a colour bar below a picture. */
#include "rt/heat/color_scale.h"

#include <stdio.h>
#include <string.h>

/* Lengths in dots, the squares of which letters consist. ADVANCE is the distance
 * between the starts of two letters, and LINE the distance between two lines of text.
 * From top to bottom, a scale has a margin, the bar, the lines of text from BAR_END on,
 * and a margin. */
enum {
    LETTER_WIDTH = 5,
    LETTER_HEIGHT = 7,
    ADVANCE = LETTER_WIDTH + 1,
    LINE = LETTER_HEIGHT + 2,
    MARGIN = 4,
    BAR = 8,
    BAR_END = MARGIN + BAR + 3,
    COLUMNS = 320 /* a dot has one pixel for each of these columns of the picture */
};

/* The rows of a letter from top to bottom. The left dot is the highest of five bits. */
static const struct letter {
    char letter;
    unsigned char rows[LETTER_HEIGHT];
} letters[] = {
    { '0', { 0x0E, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0E } },
    { '1', { 0x04, 0x0C, 0x04, 0x04, 0x04, 0x04, 0x0E } },
    { '2', { 0x0E, 0x11, 0x01, 0x02, 0x04, 0x08, 0x1F } },
    { '3', { 0x1F, 0x02, 0x04, 0x02, 0x01, 0x11, 0x0E } },
    { '4', { 0x02, 0x06, 0x0A, 0x12, 0x1F, 0x02, 0x02 } },
    { '5', { 0x1F, 0x10, 0x1E, 0x01, 0x01, 0x11, 0x0E } },
    { '6', { 0x06, 0x08, 0x10, 0x1E, 0x11, 0x11, 0x0E } },
    { '7', { 0x1F, 0x01, 0x02, 0x04, 0x08, 0x08, 0x08 } },
    { '8', { 0x0E, 0x11, 0x11, 0x0E, 0x11, 0x11, 0x0E } },
    { '9', { 0x0E, 0x11, 0x11, 0x0F, 0x01, 0x02, 0x0C } },
    { '-', { 0x00, 0x00, 0x00, 0x1F, 0x00, 0x00, 0x00 } },
    { '+', { 0x00, 0x04, 0x04, 0x1F, 0x04, 0x04, 0x00 } },
    { '.', { 0x00, 0x00, 0x00, 0x00, 0x00, 0x0C, 0x0C } },
    { ',', { 0x00, 0x00, 0x00, 0x00, 0x0C, 0x04, 0x08 } },
    { '/', { 0x00, 0x01, 0x02, 0x04, 0x08, 0x10, 0x00 } },
    { '^', { 0x04, 0x0A, 0x11, 0x00, 0x00, 0x00, 0x00 } },
    { 'W', { 0x11, 0x11, 0x11, 0x15, 0x15, 0x15, 0x0A } },
    { 'a', { 0x00, 0x00, 0x0E, 0x01, 0x0F, 0x11, 0x0F } },
    { 'c', { 0x00, 0x00, 0x0E, 0x10, 0x10, 0x11, 0x0E } },
    { 'e', { 0x00, 0x00, 0x0E, 0x11, 0x1F, 0x10, 0x0E } },
    { 'f', { 0x06, 0x09, 0x08, 0x1C, 0x08, 0x08, 0x08 } },
    { 'h', { 0x10, 0x10, 0x16, 0x19, 0x11, 0x11, 0x11 } },
    { 'i', { 0x04, 0x00, 0x0C, 0x04, 0x04, 0x04, 0x0E } },
    { 'l', { 0x0C, 0x04, 0x04, 0x04, 0x04, 0x04, 0x0E } },
    { 'm', { 0x00, 0x00, 0x1A, 0x15, 0x15, 0x15, 0x15 } },
    { 'n', { 0x00, 0x00, 0x16, 0x19, 0x11, 0x11, 0x11 } },
    { 'o', { 0x00, 0x00, 0x0E, 0x11, 0x11, 0x11, 0x0E } },
    { 'p', { 0x00, 0x00, 0x1E, 0x11, 0x1E, 0x10, 0x10 } },
    { 'r', { 0x00, 0x00, 0x16, 0x19, 0x10, 0x10, 0x10 } },
    { 's', { 0x00, 0x00, 0x0E, 0x10, 0x0E, 0x01, 0x1E } },
    { 't', { 0x08, 0x08, 0x1C, 0x08, 0x08, 0x09, 0x06 } },
    { 'u', { 0x00, 0x00, 0x11, 0x11, 0x11, 0x13, 0x0D } },
    { 'w', { 0x00, 0x00, 0x11, 0x11, 0x15, 0x15, 0x0A } },
};

/* ---- Layout ---------------------------------------------------------------- */

enum { NUMBER_SIZE = 32 };

struct scale_layout {
    const struct color_scale *scale;
    struct frame *frame;
    size_t dot;        /* size of a dot in pixels */
    size_t first;      /* first row of the scale in the frame */
    size_t width;      /* width in dots */
    double begin, end; /* shares at both ends of the bar */
    char least[NUMBER_SIZE], most[NUMBER_SIZE];
    bool apart; /* each number needs a line of its own */
};

static size_t text_width(const char *text)
{
    return strlen(text) * ADVANCE;
}

static struct scale_layout layout_of(const struct color_scale *scale, size_t width)
{
    struct scale_layout layout = { .scale = scale };
    layout.dot = width < 2 * COLUMNS ? 1 : width / COLUMNS;
    layout.width = width / layout.dot;
    layout.begin = scale->least < 0 ? -1 : 0;
    layout.end = scale->most > 0 || scale->least >= 0 ? 1 : 0;
    snprintf(layout.least, NUMBER_SIZE, "%g", layout.begin < 0 ? scale->least : 0);
    snprintf(layout.most, NUMBER_SIZE, "%g", layout.end > 0 ? scale->most : 0);
    layout.apart = text_width(layout.least) + text_width(layout.most) + 2 * MARGIN
                   > layout.width;
    return layout;
}

size_t color_scale_rows(const struct color_scale *scale, size_t width)
{
    struct scale_layout layout = layout_of(scale, width);
    size_t lines = layout.apart ? 3 : 2;
    return layout.dot * (BAR_END + lines * LINE + MARGIN);
}

/* ---- Drawing --------------------------------------------------------------- */

/* Draws a dot as a square of pixels. Pixels outside of the frame are skipped. */
static void put_dot(const struct scale_layout *layout, size_t x, size_t y,
                    const double color[3])
{
    const struct frame *frame = layout->frame;
    for (size_t i = 0; i < layout->dot * layout->dot; i++) {
        size_t column = x * layout->dot + i % layout->dot;
        size_t row = layout->first + y * layout->dot + i / layout->dot;
        for (int k = 0; column < frame->width && row < frame->height && k < 3; k++)
            frame->channel[k][row * frame->width + column] = color[k];
    }
}

static void draw_text(const struct scale_layout *layout, size_t x, size_t y,
                      const char *text)
{
    static const double white[3] = { .9, .9, .9 };
    for (; *text; text++, x += ADVANCE)
        for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
            for (size_t dot = 0;
                 letters[i].letter == *text && dot < LETTER_WIDTH * LETTER_HEIGHT;
                 dot++)
                if (letters[i].rows[dot / LETTER_WIDTH]
                        >> (LETTER_WIDTH - 1 - dot % LETTER_WIDTH)
                    & 1)
                    put_dot(layout, x + dot % LETTER_WIDTH, y + dot / LETTER_WIDTH,
                            white);
}

/* Returns the column at which a text of this width begins if it ends at `column`. */
static size_t before(size_t column, size_t width)
{
    return column > width ? column - width : 0;
}

static void put_bar(const struct scale_layout *layout)
{
    const struct color_scale *scale = layout->scale;
    double reach = layout->end - layout->begin;
    for (size_t x = MARGIN; x + MARGIN < layout->width; x++) {
        double at = ((double)(x - MARGIN) + .5) / (double)(layout->width - 2 * MARGIN);
        double color[3];
        scale->color(scale->context, layout->begin + at * reach, color);
        for (size_t y = 0; y < BAR; y++)
            put_dot(layout, x, MARGIN + y, color);
    }
}

static void put_numbers(const struct scale_layout *layout)
{
    size_t end = before(layout->width, MARGIN), zero = layout->width / 2;
    size_t least = MARGIN + text_width(layout->least) + ADVANCE;
    size_t most = before(end + 1, text_width(layout->most));
    draw_text(layout, MARGIN, BAR_END, layout->least);
    draw_text(layout, most, BAR_END + (layout->apart ? LINE : 0), layout->most);
    if (layout->begin < 0 && layout->end > 0 && zero > least && zero + ADVANCE < most)
        draw_text(layout, zero - LETTER_WIDTH / 2, BAR_END, "0");
}

void color_scale_draw(const struct color_scale *scale, struct frame *frame,
                      size_t first)
{
    struct scale_layout layout = layout_of(scale, frame->width);
    size_t line = BAR_END + (layout.apart ? 2 : 1) * LINE;
    layout.frame = frame;
    layout.first = first;
    put_bar(&layout);
    put_numbers(&layout);
    draw_text(&layout, before(layout.width / 2, text_width(scale->title) / 2), line,
              scale->title);
}
