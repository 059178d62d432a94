/* function.c - evaluates the functions of floats and vectors in expressions, such as
 * sin and vcross.
 *
 * For an argument outside of its domain, a function returns NaN or infinity. The
 * expression parser then reports an error.
 */
#include "rt/scene/elementary.h"
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/vector3.h"

#include <string.h>

#define MAX_WHOLE 2147483648. /* limit of integers in POV-Ray */

static double degrees(double radians)
{
    return radians * (180 / PI);
}

static double radians(double degree)
{
    return degree * (PI / 180);
}

static void give(struct numbers *result, double value)
{
    *result = numbers_of(value);
}

/* Truncates a value. Adding 0 turns -0 into 0; otherwise the sign would be visible when
 * the number is printed. */
static double whole(double value)
{
    return trunc(value) + 0.0;
}

static double div_whole(double a, double b)
{
    return whole(a / b);
}

/* Returns a power, or NaN for 0 to the power of 0, which is an error in POV-Ray. */
static double power(double base, double exponent)
{
    return base == 0 && exponent == 0 ? (double)NAN : elementary_pow(base, exponent);
}

/* Truncates a value to an integer for the bitwise functions. Returns 0 if it is out of
 * range. */
static long bits_of(const struct numbers *number)
{
    double value = number->n[0];
    return value > -MAX_WHOLE && value < MAX_WHOLE ? (long)value : 0;
}

static void apply_bitwise_and(const struct numbers *a, size_t n, struct numbers *r)
{
    long bits = bits_of(&a[0]);
    for (size_t i = 1; i < n; i++)
        bits &= bits_of(&a[i]);
    give(r, (double)bits);
}

static void apply_bitwise_or(const struct numbers *a, size_t n, struct numbers *r)
{
    long bits = bits_of(&a[0]);
    for (size_t i = 1; i < n; i++)
        bits |= bits_of(&a[i]);
    give(r, (double)bits);
}

static void apply_bitwise_xor(const struct numbers *a, size_t n, struct numbers *r)
{
    long bits = bits_of(&a[0]);
    for (size_t i = 1; i < n; i++)
        bits ^= bits_of(&a[i]);
    give(r, (double)bits);
}

/* select(A, B, C) is B if A < 0, else C. select(A, B, C, D) is B if A < 0, C if A = 0,
 * and D if A > 0. */
static void apply_select(const struct numbers *a, size_t n, struct numbers *r)
{
    *r = a[a[0].n[0] < 0 ? 1 : a[0].n[0] > 0 && n > 3 ? 3 : 2];
}

static void give_vector(struct numbers *result, const double vector[3])
{
    *result = numbers_of(0);
    result->count = 3;
    memcpy(result->n, vector, 3 * sizeof *vector);
}

static void apply_vcross(const struct numbers *a, size_t n, struct numbers *r)
{
    double product[3];
    (void)n;
    cross3(a[0].n, a[1].n, product);
    give_vector(r, product);
}

static void apply_vdot(const struct numbers *a, size_t n, struct numbers *r)
{
    (void)n;
    give(r, dot3(a[0].n, a[1].n));
}

static void apply_vlength(const struct numbers *a, size_t n, struct numbers *r)
{
    (void)n;
    give(r, length3(a[0].n));
}

/* Normalises a vector. A zero vector is returned unchanged. */
static void apply_vnormalize(const struct numbers *a, size_t n, struct numbers *r)
{
    double length = length3(a[0].n);
    (void)n;
    give_vector(r, a[0].n);
    if (length > 0)
        scale3(1 / length, r->n);
}

static void apply_vrotate(const struct numbers *a, size_t n, struct numbers *r)
{
    struct placement rotation = placement_rotation(a[1].n);
    (void)n;
    give_vector(r, a[0].n);
    transform_direction(&rotation.to_world, r->n);
}

/* Rotates v about k by Rodrigues' formula: v cos + (k x v) sin + k (k.v)(1 - cos). */
static void apply_vaxis_rotate(const struct numbers *a, size_t n, struct numbers *r)
{
    double angle = radians(a[2].n[0]), c = elementary_cos(angle),
           s = elementary_sin(angle);
    double axis[3], across[3], along, length = length3(a[1].n);
    (void)n;
    give_vector(r, a[0].n);
    memcpy(axis, a[1].n, sizeof axis);
    if (length == 0)
        return;
    scale3(1 / length, axis);
    cross3(axis, a[0].n, across);
    along = dot3(axis, a[0].n);
    for (int i = 0; i < 3; i++)
        r->n[i] = a[0].n[i] * c + across[i] * s + axis[i] * along * (1 - c);
}

static const struct function functions[] = {
    { "abs", "f", .plain = fabs },
    { "acos", "f", .plain = elementary_acos },
    { "acosh", "f", .plain = elementary_acosh },
    { "asin", "f", .plain = elementary_asin },
    { "asinh", "f", .plain = elementary_asinh },
    { "atan", "f", .plain = elementary_atan },
    { "atan2", "ff", .pair = elementary_atan2 },
    { "atanh", "f", .plain = elementary_atanh },
    { "bitwise_and", "ff+", .apply = apply_bitwise_and },
    { "bitwise_or", "ff+", .apply = apply_bitwise_or },
    { "bitwise_xor", "ff+", .apply = apply_bitwise_xor },
    { "ceil", "f", .plain = ceil },
    { "cos", "f", .plain = elementary_cos },
    { "cosh", "f", .plain = elementary_cosh },
    { "degrees", "f", .plain = degrees },
    { "div", "ff", .pair = div_whole },
    { "exp", "f", .plain = elementary_exp },
    { "floor", "f", .plain = floor },
    { "int", "f", .plain = whole },
    { "ln", "f", .plain = elementary_log },
    { "log", "f", .plain = elementary_log10 },
    { "max", "f+", .pair = fmax },
    { "min", "f+", .pair = fmin },
    { "mod", "ff", .pair = fmod },
    { "pow", "ff", .pair = power },
    { "radians", "f", .plain = radians },
    { "select", "fff?", .apply = apply_select },
    { "sin", "f", .plain = elementary_sin },
    { "sinh", "f", .plain = elementary_sinh },
    { "sqrt", "f", .plain = sqrt },
    { "tan", "f", .plain = elementary_tan },
    { "tanh", "f", .plain = elementary_tanh },
    { "vaxis_rotate", "vvf", .apply = apply_vaxis_rotate },
    { "vcross", "vv", .apply = apply_vcross },
    { "vdot", "vv", .apply = apply_vdot },
    { "vlength", "v", .apply = apply_vlength },
    { "vnormalize", "v", .apply = apply_vnormalize },
    { "vrotate", "vv", .apply = apply_vrotate },
};

const struct function *function_find(const struct scene_token *token)
{
    return TOKEN_ROW(token, functions);
}

void function_apply(const struct function *function, const struct numbers *arguments,
                    size_t count, struct numbers *result)
{
    double value = arguments[0].n[0];
    if (function->apply) {
        function->apply(arguments, count, result);
        return;
    }
    if (function->plain)
        value = function->plain(value);
    for (size_t i = 1; i < count; i++)
        value = function->pair(value, arguments[i].n[0]);
    *result = numbers_of(value);
}
