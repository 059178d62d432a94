/* compare_pictures.c - compares two frames pixel by pixel. */
#include "tests/oracle/compare_pictures.h"

#include "tests/oracle/solid_text.h"

#include <math.h>

/* A sample in a file has 24 bits, which is a relative error of 6e-8. The machine has 47
 * bits, but the exponent of a highlight multiplies the relative error. */
#define COLOR_TOLERANCE 1e-6
#define GEOMETRY_TOLERANCE 1e-6

const struct comparison with_frame[WITH_FRAME] = {
    { "colour", CHANNEL_RED, 3, INFINITY, true, COLOR_TOLERANCE, DECIDED_BY_ROUNDING },
    { "depth", CHANNEL_DEPTH, 1, INFINITY, true, GEOMETRY_TOLERANCE,
      DECIDED_BY_ROUNDING },
    { "normal", CHANNEL_NORMAL_X, 3, INFINITY, false, GEOMETRY_TOLERANCE,
      DECIDED_BY_ROUNDING },
    { "id", CHANNEL_ID, 1, INFINITY, false, 0, DECIDED_BY_ROUNDING },
};

static bool is_inner(const struct frame *frame, size_t x, size_t y)
{
    const double *id = frame->channel[CHANNEL_ID];
    double here = id[y * frame->width + x];
    for (size_t j = y ? y - 1 : 0; j <= y + 1 && j < frame->height; j++)
        for (size_t i = x ? x - 1 : 0; i <= x + 1 && i < frame->width; i++)
            if (id[j * frame->width + i] != here)
                return false;
    return true;
}

bool *inner_pixels(const struct frame *frame)
{
    bool *inner = test_room(frame->width * frame->height);
    for (size_t y = 0; y < frame->height; y++)
        for (size_t x = 0; x < frame->width; x++)
            inner[y * frame->width + x] = is_inner(frame, x, y);
    return inner;
}

/* Returns the difference of two samples. If one is NaN, the difference is infinite. */
static double difference_of(const struct comparison *comparison, double expected,
                            double found)
{
    double a = fmin(expected, comparison->ceiling);
    double b = isnan(found) ? NAN : fmin(found, comparison->ceiling);
    double unit = comparison->relative ? fmax(1, fabs(a)) : 1;
    double difference = fabs(a - b) / unit;
    return isnan(difference) ? INFINITY : difference;
}

/* Adds the differences of a pixel to the sum. Returns the largest difference. */
static double add_pixel(const struct comparison *comparison,
                        const struct frame *expected, const struct frame *found,
                        size_t pixel, double *sum)
{
    double greatest = 0;
    for (size_t i = 0; i < comparison->channels; i++) {
        size_t channel = comparison->first + i;
        double difference = difference_of(comparison, expected->channel[channel][pixel],
                                          found->channel[channel][pixel]);
        *sum += difference;
        greatest = fmax(greatest, difference);
    }
    return greatest;
}

struct picture_difference compare_pictures(const struct comparison *comparison,
                                           const struct frame *expected,
                                           const struct frame *found, const bool *inner)
{
    struct picture_difference result = { 0 };
    double sum = 0;
    for (size_t i = 0; i < expected->width * expected->height; i++) {
        if (!inner[i]) {
            result.ignored++;
            continue;
        }
        double greatest = add_pixel(comparison, expected, found, i, &sum);
        result.compared++;
        result.beyond += greatest > comparison->tolerance;
        if (greatest > result.greatest) {
            result.greatest = greatest;
            result.worst_x = i % expected->width;
            result.worst_y = i / expected->width;
        }
    }
    if (result.compared)
        result.mean = sum / (double)(result.compared * comparison->channels);
    return result;
}

/* Returns true if a difference is within the tolerances of a comparison. A comparison
 * of no pixels fails. */
bool within(const struct comparison *comparison,
            const struct picture_difference *difference)
{
    return difference->compared > 0
           && (double)difference->beyond
                  <= comparison->share * (double)difference->compared;
}
