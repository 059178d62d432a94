/* form.h - assembles the program that traces a scene. There are three forms. The
 * program contains only the kernels that the scene needs. */
#ifndef RT_FORM_H
#define RT_FORM_H

#include "asm/text/assemble.h"
#include "rt/trace/trace.h"

/* Returns the program, or NULL if it cannot be assembled. options->samples must be the
 * number of samples that is used, lens included. */
struct object *form_assemble(const struct trace_options *options,
                             const struct scene *scene, c205_error *error);

/* Returns the file name of the program's source, as in the line records of the
 * program. */
const char *form_program(enum trace_mode mode);

/* Assembles the program for all-hits queries (ray_query.h) of a scene, in which all
 * surfaces must have the same opaque colour. On request the program also computes
 * normals and object depths. */
struct object *form_assemble_lines(enum trace_mode mode, size_t queue, bool normals,
                                   bool bodies, const struct scene *scene,
                                   c205_error *error);

/* Assembles a program that intersects no primitives, such as "heat/faces". The source
 * is heat/faces.s, with the constant SCALAR if trace_mode_besides selects the scalar
 * form. The defines may be NULL. */
struct object *form_assemble_beside(const char *name, enum trace_mode mode,
                                    const struct asm_define *defines,
                                    c205_error *error);

#endif
