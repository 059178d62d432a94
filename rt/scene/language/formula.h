/* formula.h - functions that a scene declares.
 *
 *     #declare Wave = function(x, y) { sin(x)*exp(-y*y) };
 *
 * Parameters (x, y, z unless they are named) and result are floats.  The body
 * is read once, where it is declared: names in it keep the values that they
 * have there.  function { transform { ... } }
 * moves a point, and makes a vector.  Functions of patterns, pigments, splines and those
 * that POV-Ray has built in (`internal`) can be declared, but not called.
 */
#ifndef RT_SCENE_FORMULA_H
#define RT_SCENE_FORMULA_H

#include "rt/scene/language/reader.h"

/* All formulas live in the reader's arena. */
struct formula;

/* Behind the word `function`; NULL after an error. */
const struct formula *formula_read(struct reader *reader);
/* The next token is its name: the call, and its value. */
bool formula_call(struct reader *reader, const struct formula *formula,
                  struct numbers *value);
/* The float that it makes of its parameters, of which it has three at most; an
 * error is `at`. */
bool formula_value(struct reader *reader, const struct formula *formula,
                   const struct scene_token *at, const double arguments[3],
                   double *value);

#endif
