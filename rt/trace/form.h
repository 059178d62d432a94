/* form.h - the program that traces a scene: in one of three forms, with those
 * kernels that the scene asks for.
 */
#ifndef RT_FORM_H
#define RT_FORM_H

#include "rt/trace/trace.h"

/* NULL: it cannot be assembled.  The options' samples are those that are taken. */
struct object *form_assemble(const struct trace_options *options,
                             const struct scene *scene, c205_error *error);

/* The name of its text, as lines of it have it. */
const char *form_program(enum trace_mode mode);

/* .. that finds all that is seen along lines (lines.h), of a scene whose surfaces are
 * plain; with normals, and with counts of bodies, if asked. */
struct object *form_assemble_lines(enum trace_mode mode, size_t queue, bool normals,
                                   bool bodies, const struct scene *scene,
                                   c205_error *error);

/* .. that meets no primitives and is called beside those that do: "heat/faces" is
 * heat/faces_scalar.s or heat/faces_vector.s (trace_mode_besides).  The defines may be
 * NULL. */
struct object *form_assemble_beside(const char *name, enum trace_mode mode,
                                    const struct asm_define *defines,
                                    c205_error *error);

#endif
