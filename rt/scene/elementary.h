/* elementary.h - elementary functions, rounded to the nearest double.
 *
 * C libraries differ in the last bit of these functions, even between two processors of
 * one type of host. The numbers of a scene must not depend on that: these functions
 * have one result on every host, so a scene yields the same words everywhere. A result
 * that is closer to the midpoint of two doubles than 2^-40 of their distance counts as
 * that midpoint, and rounds to the even double.
 *
 * Errors are as in C: a result without a value is NaN, one that is too large is
 * infinite.
 */
#ifndef RT_SCENE_ELEMENTARY_H
#define RT_SCENE_ELEMENTARY_H

/* Beyond e^700 and e^-700 the result is that of the C library. This is also true of
 * powers and hyperbolic functions. */
double elementary_exp(double x);
double elementary_log(double x);
double elementary_log10(double x);
double elementary_pow(double x, double y);

/* Angles are in radians. Beyond 2^30 radians the result is that of the C library. */
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
