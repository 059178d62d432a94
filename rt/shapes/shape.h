/* shape.h - the descriptor of a kind of primitive, through which all other code handles
 * the primitive.
 *
 * Each kind has one descriptor, in its own file. The descriptor lists the arguments in
 * the scene language and the names of the kernels. Its functions compute the bound and
 * the words that the kernels read. rt/shapes/shapes.def lists the kinds. If a row has
 * no descriptor, the program does not link.
 */
#ifndef RT_SHAPE_H
#define RT_SHAPE_H

#include "rt/shapes/shape_bound.h"
#include "rt/shapes/emitter.h"
#include "rt/bvh/viewpoints.h"
#include "rt/shapes/primitive.h"
#include "vm/text.h"

/* The accuracy of a root, relative to the size of the shape. */
#define ROOT_RESOLUTION 0x1p-44

/* ---- Arguments ----------------------------------------------------------- */

/* The kinds of arguments, which have a fixed order. The commas between them are
 * optional. */
enum shape_takes {
    TAKES_END,
    TAKES_NUMBER,
    TAKES_VECTOR,
    TAKES_RADIUS, /* its absolute value is used */
    TAKES_SIZE,   /* a number above 0 */
    TAKES_MORE,   /* an optional number */
    TAKES_TERMS,  /* numbers in < > */
    TAKES_WORD,   /* an optional keyword, whose presence is stored in a bool */
    TAKES_USUAL,  /* an optional keyword that selects the default */
    TAKES_OTHER,  /* a keyword of POV-Ray that is not supported */
    TAKES_PATH,   /* A number of points, which is at least `count`, then the points. The
                   * destination is a struct outline with space for twice as many
                   * points. */
};

struct shape_field {
    enum shape_takes takes;
    size_t offset;      /* offset of the destination in struct primitive */
    const char *what;   /* name of the argument in messages; for a keyword, the
                         * keyword */
    size_t count;       /* number of elements; 0: one */
    const char *behind; /* keyword before the elements if they are optional; else
                         * NULL */
};
/* The offset of a member of shape.name in struct primitive. */
#define SHAPE_AT(name, member) offsetof(struct primitive, shape.name.member)

/* ---- Routines ------------------------------------------------------------ */

/* Names of kernels. Both forms of the program use the same names. */
struct shape_kernels {
    const char *kernel; /* finds the first crossing of a ray */
    const char *normal;
    size_t segments;               /* largest number of segments of a ray inside; 0: a
                                    * surface, which has no inside */
    const char *solid;             /* in a tree: finds all crossings; NULL: `kernel`
                                    * finds all of them */
    const char *state;             /* in a tree, for an open shape: finds the segments
                                    * inside the closed shape; else NULL */
    const char *inside;            /* in a tree, for a shape that can be a surface or a
                                    * solid: finds the segments of the solid; else
                                    * NULL */
    const char *body;              /* in a tree, for a shape that can have an invisible
                                    * body: finds the segments inside the body */
    const char *historical;        /* the kernel of 1984 */
    const char *historical_normal; /* computes the normal for `historical`, if this
                                    * needs two parameters of a hit; else NULL */
};

/* ---- Descriptor ---------------------------------------------------------- */

enum { MAX_SHAPE_WORDS = 16, MAX_PATH = 2000 };

struct face_search;

struct shape {
    /* A list that ends with TAKES_END. It is empty for a shape that has its own
     * parser. */
    const struct shape_field *fields;
    /* Converts the arguments to the form that is traced. Returns NULL, an error
     * message, or the result of shape_empty if the shape is invisible. */
    const char *(*finish)(struct primitive *primitive);
    bool povray; /* POV-Ray has this keyword */

    /* Computes the bound in world space, or sets it to bound_none if the shape is
     * unbounded. */
    void (*bound)(const struct primitive *primitive, struct bound *bound);
    bool endless; /* the inside that trees use extends beyond the bound */

    /* Adds the flat faces of the surface (flat_faces.h), which may coincide with faces
     * of other shapes. Returns true if the surface also has curved faces. NULL: all
     * faces are curved. */
    bool (*flat_faces)(const struct primitive *primitive, struct face_search *search);
    /* Adds the matrix of the quadric that contains the curved faces, in world space
     * (quadric_face.h), to a matrix of zeros. NULL: there is no such quadric. */
    void (*quadric)(const struct primitive *primitive, double (*matrix)[4]);

    /* Writes the words of P_SHAPE, in the order that rt/kernels/shapes/name.s states,
     * and returns their number. They are values that can be computed once, such as
     * reciprocals and axes. */
    size_t (*words)(const struct primitive *primitive, double *words);
    /* Writes further words, whose address is in the record, and returns their number,
     * or 0 if out of memory. If `table` is NULL, it only returns the number. The words
     * may depend on the viewpoints; `viewpoints` may be NULL. NULL: the shape has no
     * table. */
    size_t (*table)(const struct primitive *primitive,
                    const struct viewpoints *viewpoints, double *table);
    /* Sets the marks of the words of the table that are integers. All marks are clear
     * before the call. NULL: all words are floating-point numbers. */
    void (*mark_integers)(const struct primitive *primitive,
                          const struct viewpoints *viewpoints, bool *marks);
    /* Returns true if all words are finite, faster than by computing them. NULL: there
     * is no faster method. */
    bool (*is_finite)(const struct primitive *primitive);
    /* Converts the words to world space, unless they already are in it. Returns false
     * if this is impossible; the shape then keeps an object space. NULL: it is never
     * possible. */
    bool (*carry)(const struct primitive *primitive, double *words);

    /* Returns the largest number of segments of a ray inside the shape. NULL: it is
     * kernels.segments. */
    size_t (*segments)(const struct primitive *primitive);
    /* Returns true if the primitive is a surface whose inside is defined by an
     * invisible body. NULL: it has no body. */
    bool (*has_body)(const struct primitive *primitive);
    /* For a shape that consists of triangles: returns the largest number of crossings
     * of a ray. NULL: hits of the shape have no triangle. */
    size_t (*crossings)(const struct primitive *primitive);
    const char *region; /* name of the region of its kernels in accounts */
    /* A symbol that is 1 in scenes with this shape. The kernels of the shape are
     * assembled only if it is 1. NULL: they are always assembled. */
    const char *symbol;
    struct shape_kernels kernels;
    /* Returns true if a primitive uses the second set of routines, `other`. NULL: there
     * is only one set. */
    bool (*is_other)(const struct primitive *primitive);
    struct shape_kernels other;
    /* Returns true if the kernel of 1984 supports the primitive. NULL: it supports all,
     * if there is such a kernel. */
    bool (*is_historical)(const struct primitive *primitive);
    /* Writes the words for the kernel of 1984. NULL: they are the same as those of
     * `words`. */
    size_t (*historical_words)(const struct primitive *primitive, double *words);
    /* Describes the surface for the kernels that choose random points of it. The caller
     * frees the emitter. Returns NULL, or the reason why this is not possible. The
     * member is NULL if random points can only be found by intersecting lines with the
     * surface. */
    const char *(*emit)(const struct primitive *primitive, struct emitter *emitter);
};

#define SHAPE(KIND, name, ...) extern const struct shape shape_##name;
#include "rt/shapes/shapes.def"

/* The descriptors, indexed by enum primitive_kind. */
extern const struct shape *const shapes[PRIMITIVE_KINDS];
const struct shape *shape_of(const struct primitive *primitive);
/* Returns the set of routines that the primitive uses. */
const struct shape_kernels *shape_kernels_of(const struct primitive *primitive);
/* Returns true if the primitive has no inside. */
bool shape_is_surface(const struct primitive *primitive);
/* Marks the primitive as invisible, and returns the reason. */
const char *shape_empty(struct primitive *primitive, const char *reason);

/* The kernels of all shapes, as texts that a program includes:
 *
 *   shapes/every.s                shapes/NAME.s of each row of shapes.def
 *   shapes/every_normal.s         shapes/normal_NAME.s
 *
 * If a row has no kernels, the program therefore does not assemble.
 */
extern const struct text shape_texts[];

#endif
