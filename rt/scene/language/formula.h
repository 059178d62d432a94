/* formula.h - parses and evaluates the functions that a scene declares.
 *
 *     #declare Wave = function(x, y) { sin(x)*exp(-y*y) };
 *
 * The parameters (by default x, y and z) and the result are floats. The body is read
 * once, at the declaration, so names in it have the values of this time. function {
 * transform { ... } } transforms a point and returns a vector. Functions of patterns,
 * pigments and splines and the built-in functions of POV-Ray (`internal`) can be
 * declared, but not called.
 */
#ifndef RT_SCENE_FORMULA_H
#define RT_SCENE_FORMULA_H

#include "rt/scene/language/reader.h"

/* A function. All functions are in the reader's arena. */
struct formula;

/* Reads a function after the keyword `function`. Returns NULL after an error. */
const struct formula *formula_read(struct reader *reader);
/* Reads a call of the function that the current token names, and evaluates it. */
bool formula_call(struct reader *reader, const struct formula *formula,
                  struct numbers *value);
/* Evaluates a function of up to three parameters. Errors are reported at `at`. */
bool formula_value(struct reader *reader, const struct formula *formula,
                   const struct scene_token *at, const double arguments[3],
                   double *value);

#endif
