/* plot_axis.c - computes the range and the labels of an axis of a plot. */
#include "base/plot_axis.h"

#include <math.h>
#include <string.h>

enum { LABELS = 10, MAX_SMALL_TICS = 40 };

static bool is_linear(const struct axis *axis)
{
    return axis->scale == PLOT_LINEAR;
}

struct axis axis_new(enum plot_scale scale)
{
    return (struct axis){ scale, INFINITY, -INFINITY };
}

bool axis_shows(const struct axis *axis, double value)
{
    return isfinite(value) && (is_linear(axis) || value > 0);
}

void axis_reach(struct axis *axis, double value)
{
    axis->low = fmin(axis->low, value);
    axis->high = fmax(axis->high, value);
}

/* Converts a value to the linear scale of the axis: the exponent of the base, or the
 * value itself. */
static double to_ruler(const struct axis *axis, double value)
{
    if (axis->scale == PLOT_LOG2)
        return log2(value);
    return axis->scale == PLOT_LOG10 ? log10(value) : value;
}

static double from_ruler(const struct axis *axis, double place)
{
    return is_linear(axis) ? place : pow(axis->scale, place);
}

double axis_place(const struct axis *axis, double value)
{
    double low = to_ruler(axis, axis->low);
    double high = to_ruler(axis, axis->high);
    return (to_ruler(axis, value) - low) / (high - low);
}

double axis_value(const struct axis *axis, double place)
{
    double low = to_ruler(axis, axis->low);
    double high = to_ruler(axis, axis->high);
    return from_ruler(axis, low + place * (high - low));
}

void axis_widen(struct axis *axis)
{
    if (axis->high - axis->low > 1e-9 * fabs(axis->high))
        return;
    if (is_linear(axis)) {
        double more = axis->low == 0 ? 1 : fabs(axis->low) / 2;
        axis->low -= more;
        axis->high += more;
    } else {
        axis->low /= (double)axis->scale;
        axis->high *= (double)axis->scale;
    }
}

void axis_pad(struct axis *axis)
{
    double low = to_ruler(axis, axis->low);
    double high = to_ruler(axis, axis->high);
    double room = 0.02 * (high - low);
    axis->low = from_ruler(axis, low - room);
    axis->high = from_ruler(axis, high + room);
}

/* Returns the smallest number that is not below `least` and is 1, 2 or 5 times a power
 * of ten. */
static double round_above(double least)
{
    static const double digits[] = { 1, 2, 5, 10 };
    double power = pow(10, floor(log10(least)));
    size_t i = 0;
    while (i < 3 && digits[i] * power < least)
        i++;
    return digits[i] * power;
}

static double step_of(double length)
{
    return round_above(length / (LABELS - 2));
}

void axis_round(struct axis *axis)
{
    if (is_linear(axis)) {
        double step;
        axis_reach(axis, 0);
        step = step_of(axis->high - axis->low);
        axis->low = step * floor(axis->low / step);
        axis->high = step * ceil(axis->high / step);
    } else if (axis->scale == PLOT_LOG10) {
        axis->low = 1 / round_above(1 / axis->low);
        axis->high = round_above(axis->high);
    } else {
        axis->low = exp2(floor(log2(axis->low)));
        axis->high = exp2(ceil(log2(axis->high)));
    }
}

/* ---- Tics ----------------------------------------------------------------- */

struct tics {
    struct axis_tic *tics;
    size_t count;
};

/* Separates thousands, as in "65,536" for 65536. */
static void separate_thousands(char *label, const char *digits)
{
    size_t whole = strspn(digits + (*digits == '-'), "0123456789") + (*digits == '-');
    for (size_t i = 0; digits[i] != '\0'; i++) {
        bool group = i > 0 && i < whole && (whole - i) % 3 == 0;
        if (group && digits[i - 1] != '-')
            *label++ = ',';
        *label++ = digits[i];
    }
    *label = '\0';
}

/* Formats a label. Large numbers have an exponent, as in 1e+15. */
void axis_label(char label[AXIS_LABEL_SIZE], double value)
{
    char digits[20];
    bool plain = value == floor(value) && fabs(value) < 1e12;
    snprintf(digits, sizeof digits, plain ? "%.0f" : "%.6g", value);
    separate_thousands(label, digits);
}

static void add_tic(struct tics *tics, double at, bool labelled)
{
    struct axis_tic *tic = &tics->tics[tics->count];
    if (tics->count == AXIS_TICS)
        return;
    tics->count++;
    tic->at = at;
    tic->label[0] = '\0';
    if (labelled)
        axis_label(tic->label, at);
}

static void add_steps(struct tics *tics, const struct axis *axis)
{
    double step = step_of(axis->high - axis->low);
    double first = ceil(axis->low / step - 1e-6);
    double last = floor(axis->high / step + 1e-6);
    for (double n = first; n <= last; n++)
        add_tic(tics, n == 0 ? 0 : n * step, true);
}

/* Labels the powers of ten and their multiples by 2 and 5. */
static void add_decades(struct tics *tics, const struct axis *axis)
{
    static const double digits[] = { 1, 2, 5 };
    for (double n = floor(log10(axis->low)); n <= log10(axis->high); n++)
        for (size_t i = 0; i < sizeof digits / sizeof *digits; i++) {
            double at = digits[i] * pow(10, n);
            if (at >= axis->low * (1 - 1e-9) && at <= axis->high * (1 + 1e-9))
                add_tic(tics, at, true);
        }
}

/* Labels every n-th power. The stride n limits the number of labels to LABELS. */
static void add_powers(struct tics *tics, const struct axis *axis)
{
    double first = ceil(to_ruler(axis, axis->low) - 1e-9);
    double last = floor(to_ruler(axis, axis->high) + 1e-9);
    double stride = 1 + floor((last - first) / LABELS);
    for (double n = first; n <= last; n++) {
        bool labelled = fmod(n, stride) == 0;
        if (labelled || last - first <= MAX_SMALL_TICS)
            add_tic(tics, from_ruler(axis, n), labelled);
    }
}

/* Makes the tics. A logarithmic axis that spans less than one power of its base (2 or
 * 10) is labelled like a linear axis. */
size_t axis_tics(const struct axis *axis, struct axis_tic tics[AXIS_TICS])
{
    struct tics all = { tics, 0 };
    double length = to_ruler(axis, axis->high) - to_ruler(axis, axis->low);
    if (is_linear(axis) || length < 1)
        add_steps(&all, axis);
    else if (axis->scale == PLOT_LOG10 && length <= 3)
        add_decades(&all, axis);
    else
        add_powers(&all, axis);
    return all.count;
}
