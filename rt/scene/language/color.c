/* color.c - parses colours.
 *
 * A colour has one of three forms: a keyword for the order of its components, then
 * their numbers (rgb, rgbf, ...); a list of components (red 1 green .5); the name of a
 * colour. Components after a colour replace its components.
 */
#include "rt/scene/elementary.h"
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/transfer.h"

#include <string.h>

enum { RED, GREEN, BLUE, FILTER, TRANSMIT };

/* The components of a colour that follow a keyword, in the order in which their numbers
 * are written. */
static const struct color_order {
    const char *word;
    int count;
    int terms[COLOR_TERMS];
    bool srgb;
} orders[] = {
    { "rgb", 3, { RED, GREEN, BLUE }, false },
    { "rgbf", 4, { RED, GREEN, BLUE, FILTER }, false },
    { "rgbt", 4, { RED, GREEN, BLUE, TRANSMIT }, false },
    { "rgbft", 5, { RED, GREEN, BLUE, FILTER, TRANSMIT }, false },
    { "srgb", 3, { RED, GREEN, BLUE }, true },
    { "srgbf", 4, { RED, GREEN, BLUE, FILTER }, true },
    { "srgbt", 4, { RED, GREEN, BLUE, TRANSMIT }, true },
    { "srgbft", 5, { RED, GREEN, BLUE, FILTER, TRANSMIT }, true },
    { "red", 1, { RED }, false },
    { "green", 1, { GREEN }, false },
    { "blue", 1, { BLUE }, false },
    { "filter", 1, { FILTER }, false },
    { "transmit", 1, { TRANSMIT }, false },
};

static bool is_color(const struct scene_token *token)
{
    return is_token(token, "color") || is_token(token, "colour");
}

bool is_color_word(const struct scene_token *token)
{
    return is_color(token) || TOKEN_ROW(token, orders);
}

bool starts_color(const struct reader *reader)
{
    const struct scene_value *value = reader_value_of(reader, VALUE_NUMBERS);
    return is_color_word(&reader->token)
           || (value && value->is.numbers.count == COLOR_TERMS);
}

/* Converts sRGB to linear light, then to the scene's assumed_gamma. */
static double from_srgb(double value, double gamma)
{
    double linear = srgb_light(value);
    return gamma > 0 && gamma != 1 && linear > 0 ? elementary_pow(linear, 1 / gamma)
                                                 : linear;
}

static bool read_ordered(struct reader *reader, const struct color_order *order,
                         struct numbers *color)
{
    struct scene_token at = reader->token;
    struct numbers given;
    if (!read_expression(reader, &given))
        return false;
    if (given.count == COLOR_TERMS && order->count > 1 && !order->srgb) {
        *color = given; /* a value that is already a colour is not reordered */
        return true;
    }
    if (given.count > order->count)
        return reader_fault(reader, &at, "'%s' takes %d components, found %d",
                            order->word, order->count, given.count);
    numbers_widen(&given, order->count);
    for (int i = 0; i < order->count; i++) {
        bool convert = order->srgb && order->terms[i] <= BLUE;
        color->n[order->terms[i]] = convert ? from_srgb(given.n[i],
                                                        reader->scene->assumed_gamma)
                                            : given.n[i];
    }
    return true;
}

/* Reads components of a colour, such as red .5, as long as their keywords follow. */
static bool read_terms(struct reader *reader, struct numbers *color)
{
    const struct color_order *order = TOKEN_ROW(&reader->token, orders);
    for (; order && order->count == 1; order = TOKEN_ROW(&reader->token, orders)) {
        reader_next(reader);
        if (!read_ordered(reader, order, color))
            return false;
    }
    return true;
}

static bool read_plain(struct reader *reader, struct numbers *color)
{
    if (!read_expression(reader, color))
        return false;
    numbers_widen(color, COLOR_TERMS);
    return true;
}

bool read_color_after(struct reader *reader, const struct scene_token *word,
                      struct numbers *color)
{
    const struct color_order *order = TOKEN_ROW(word, orders);
    *color = numbers_of(0);
    color->count = COLOR_TERMS;
    if (!order && TOKEN_ROW(&reader->token, orders)) {
        order = TOKEN_ROW(&reader->token, orders);
        reader_next(reader);
    }
    if (!(order ? read_ordered(reader, order, color) : read_plain(reader, color))
        || !read_terms(reader, color))
        return false;
    return numbers_are_finite(color)
           || reader_fault(reader, word, "the colour must be finite");
}

bool read_color(struct reader *reader, struct numbers *color)
{
    struct scene_token word = reader->token;
    if (is_color_word(&word))
        reader_next(reader);
    else if (!starts_expression(reader))
        return reader_expected(reader, "a colour");
    return read_color_after(reader, &word, color);
}

bool read_rgb(struct reader *reader, double rgb[3])
{
    struct numbers color;
    if (!read_color(reader, &color))
        return false;
    memcpy(rgb, color.n, 3 * sizeof *rgb);
    return true;
}
