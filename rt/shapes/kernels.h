/* kernels.h - the kernels of all shapes, as texts that a program includes.
 *
 *   shapes/every_scalar.s         shapes/NAME_scalar.s of each row of shapes.def
 *   shapes/every_vector.s         shapes/NAME_vector.s
 *   shapes/every_normal_scalar.s  shapes/normal_NAME_scalar.s
 *   shapes/every_normal_vector.s  shapes/normal_NAME_vector.s
 *
 * A row without its kernels therefore fails to assemble.
 */
#ifndef RT_KERNELS_H
#define RT_KERNELS_H

#include "vm/text.h"

extern const struct text shape_texts[];

#endif
