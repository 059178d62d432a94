/* swept_shapes.h - random shapes that sweep a path, in the scene language.
 *
 * The texts have no closing brace. If `tangles` is set, paths may have corners at
 * random positions. Otherwise they do not intersect themselves.
 */
#ifndef TESTS_SWEPT_SHAPES_H
#define TESTS_SWEPT_SHAPES_H

#include "tests/unit/random_solids.h"

void add_prism(char *text, size_t size, bool tangles);
/* Writes a prism with a quadratic spline. */
void add_quadratic_prism(char *text, size_t size, bool tangles);
void add_lathe(char *text, size_t size, bool tangles);

#endif
