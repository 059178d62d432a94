/* elementary.h - elementary functions, rounded to the nearest double.
 *
 * The C libraries of hosts round the last bit now so, now so, even from one
 * processor to the next.  What a scene's numbers come to must not depend on that: of
 * these functions there is one value, so a scene is the same words everywhere.  What
 * is nearer to the middle of two doubles than 2^-40 of their distance counts as that
 * middle, and goes to the even one.
 *
 * Errors as in C: what has no value is NaN, what is too large infinite.
 */
#ifndef RT_SCENE_ELEMENTARY_H
#define RT_SCENE_ELEMENTARY_H

/* Here, and of powers and hyperbolic functions: beyond e^700 and e^-700 as the C library has
 * it. */
double elementary_exp(double x);
double elementary_log(double x);
double elementary_log10(double x);
double elementary_pow(double x, double y);

/* Radians; beyond 2^30 of them as the C library has it. */
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
