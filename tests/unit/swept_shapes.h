/* swept_shapes.h - random shapes that sweep a path, in the scene language.
 *
 * Each text lacks the closing brace.  A path that is a tangle has corners anywhere;
 * others do not cross themselves.
 */
#ifndef TESTS_SWEPT_SHAPES_H
#define TESTS_SWEPT_SHAPES_H

#include "tests/unit/random_solids.h"

void add_prism(char *text, size_t size, bool tangles);
/* A prism of a quadratic spline. */
void add_quadratic_prism(char *text, size_t size, bool tangles);
void add_lathe(char *text, size_t size, bool tangles);

#endif
