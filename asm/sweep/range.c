/* range.c - parses the range of a swept constant and computes its values. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asm/sweep/swept.h"

/* Reads an integer of at least 1 and advances *at to the text after it. */
static bool take_count(const char **at, uint64_t *count)
{
    char *end;
    if (**at < '0' || **at > '9')
        return false;
    errno = 0;
    *count = strtoull(*at, &end, strncmp(*at, "0x", 2) == 0 ? 16 : 10);
    *at = end;
    return errno == 0 && *count > 0 && *count <= SWEPT_LARGEST;
}

bool swept_take_range(const char *text, struct swept_range *range)
{
    *range = (struct swept_range){ 0 };
    if (!take_count(&text, &range->from) || *text++ != ':'
        || !take_count(&text, &range->to) || range->from >= range->to)
        return false;
    if (*text == '\0')
        return true;
    if (*text++ != ':')
        return false;
    if (*text != 'x')
        return take_count(&text, &range->step) && *text == '\0';
    text++;
    return take_count(&text, &range->factor) && range->factor > 1 && *text == '\0';
}

static size_t given_values(const struct swept_range *range,
                           uint64_t values[MAX_SWEPT_POINTS])
{
    uint64_t value = range->from;
    size_t count = 0;
    while (value <= range->to) {
        if (count == MAX_SWEPT_POINTS)
            return 0;
        values[count++] = value;
        if (range->factor > range->to / value)
            break;
        value = range->step > 0 ? value + range->step : value * range->factor;
    }
    return count;
}

static size_t usual_points(const struct swept_range *range)
{
    double octaves = log2((double)range->to / (double)range->from);
    return (size_t)fmin(25, 1 + ceil(8 * octaves));
}

static size_t spread_values(const struct swept_range *range, size_t points,
                            uint64_t values[MAX_SWEPT_POINTS])
{
    double ratio = (double)range->to / (double)range->from;
    size_t count = 0;
    for (size_t i = 0; i < points; i++) {
        double part = (double)i / (double)(points - 1);
        uint64_t value = (uint64_t)llround((double)range->from * pow(ratio, part));
        if (count == 0 || value > values[count - 1])
            values[count++] = value;
    }
    return count;
}

size_t swept_values(const struct swept_range *range, size_t points,
                    uint64_t values[MAX_SWEPT_POINTS])
{
    if (range->step > 0 || range->factor > 0)
        return given_values(range, values);
    return spread_values(range, points > 0 ? points : usual_points(range), values);
}
