/* form.h - the program that traces a scene: in one of three forms, with those
 * kernels that the scene asks for.
 */
#ifndef RT_FORM_H
#define RT_FORM_H

#include "rt/trace/trace.h"

/* NULL: it cannot be assembled.  The options' samples are those that are taken. */
struct object *form_assemble(const struct trace_options *options,
                             const struct scene *scene, c205_error *error);

#endif
