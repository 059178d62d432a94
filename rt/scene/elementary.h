/* elementary.h - elementary functions, rounded to the nearest double.
 *
 * C libraries differ in the last bit of these functions, even on hosts of the same
 * type. The numbers of a scene must not differ between hosts, so these functions have
 * the same result on every host. If the distance of a result from the midpoint of two
 * doubles is less than 2^-40 of their distance, it counts as the midpoint and rounds to
 * the even double.
 *
 * Errors are as in C: an undefined result is NaN, a result that is too large is
 * infinite.
 */
#ifndef RT_SCENE_ELEMENTARY_H
#define RT_SCENE_ELEMENTARY_H

/* Results above e^700 or below e^-700 are computed by the C library. This is also true
 * of powers and hyperbolic functions. */
double elementary_exp(double x);
double elementary_log(double x);
double elementary_log10(double x);
double elementary_pow(double x, double y);

/* Angles are in radians. Angles above 2^30 are handled by the C library. */
double elementary_sin(double x);
double elementary_cos(double x);
double elementary_tan(double x);
double elementary_asin(double x);
double elementary_acos(double x);
double elementary_atan(double x);
double elementary_atan2(double y, double x);

double elementary_sinh(double x);
double elementary_cosh(double x);
double elementary_tanh(double x);
double elementary_asinh(double x);
double elementary_acosh(double x);
double elementary_atanh(double x);

double elementary_hypot(double x, double y);

#endif
