/* shape.h - the descriptor of a kind of primitive.
 *
 * Each kind has one descriptor, in its own file: its arguments in the scene language,
 * its bound, its words for the machine, and its routines among the kernels.
 * rt/shapes/shapes.def lists the kinds; a row without its descriptor fails to link.
 */
#ifndef RT_SHAPE_H
#define RT_SHAPE_H

#include "rt/shapes/shape_bound.h"
#include "rt/shapes/emitter.h"
#include "rt/bvh/viewpoints.h"
#include "rt/shapes/primitive.h"
#include "vm/text.h"

/* The accuracy of roots, relative to the size of the shape. */
#define ROOT_RESOLUTION 0x1p-44

/* ---- Arguments ----------------------------------------------------------- */

/* The kinds of arguments. Arguments are in order; the commas between them are
 * optional. */
enum shape_takes {
    TAKES_END,
    TAKES_NUMBER,
    TAKES_VECTOR,
    TAKES_RADIUS, /* its absolute value is used */
    TAKES_SIZE,   /* a number above 0 */
    TAKES_MORE,   /* an optional number */
    TAKES_TERMS,  /* numbers in < > */
    TAKES_WORD,   /* an optional word: a bool records whether it is there */
    TAKES_USUAL,  /* an optional word that states the default */
    TAKES_OTHER,  /* a word of POV-Ray that is not supported */
    TAKES_PATH,   /* a number of points, at least count, and the points, into a struct
                   * outline with space for twice as many */
};

struct shape_field {
    enum shape_takes takes;
    size_t offset;      /* of the destination within struct primitive */
    const char *what;   /* its name in messages; the word itself */
    size_t count;       /* of elements; 0: one */
    const char *behind; /* word before them, if they are optional; else NULL */
};
/* The offset of a member of shape.name. */
#define SHAPE_AT(name, member) offsetof(struct primitive, shape.name.member)

/* ---- Routines ------------------------------------------------------------ */

/* Names of kernels, which are the same in both forms of the program. */
struct shape_kernels {
    const char *kernel; /* the first crossing of a ray */
    const char *normal;
    size_t segments;               /* limit of a ray's segments inside; 0: a surface,
                                    * which has no inside */
    const char *solid;             /* in a tree: all crossings; NULL: kernel finds all
                                    * of them */
    const char *state;             /* in a tree, for an open shape: the segments inside
                                    * of the closed shape; else NULL */
    const char *inside;            /* in a tree, for a shape that may be a surface or a
                                    * solid: the segments of the solid; else NULL */
    const char *body;              /* in a tree, for a shape that may have an invisible
                                    * body: the segments inside of that */
    const char *historical;        /* the kernel of 1984 */
    const char *historical_normal; /* kernel of the normal with `historical`, if that
                                    * needs two parameters of a hit; else NULL */
};

/* ---- Descriptor ---------------------------------------------------------- */

enum { MAX_SHAPE_WORDS = 16, MAX_PATH = 2000 };

struct shape {
    /* Ends with TAKES_END. A shape that has its own parser has none before it. */
    const struct shape_field *fields;
    /* Converts the arguments to the form that is traced. Returns NULL, an
     * error message, or the result of shape_empty if the shape is invisible. */
    const char *(*finish)(struct primitive *primitive);
    const char *povray; /* its name in POV-Ray; NULL: none */

    /* Bounds the shape in the world, or sets bound_none. */
    void (*bound)(const struct primitive *primitive, struct bound *bound);
    bool endless; /* its inside, as trees use it, extends beyond the bound */

    /* Writes the words of P_SHAPE in the order of rt/kernels/frame/records.s: values
     * that can be computed once, such as reciprocals and axes. Returns their number. */
    size_t (*words)(const struct primitive *primitive, double *words);
    /* Writes further words, whose address is in the record, unless table is NULL.
     * Returns their number, or 0 without memory. The table may depend on the viewpoints
     * that many rays pass through; viewpoints may be NULL. NULL: no table. */
    size_t (*table)(const struct primitive *primitive,
                    const struct viewpoints *viewpoints, double *table);
    /* Sets the marks of the words of the table that are integers; all marks are clear
     * before. NULL: all are floating-point numbers. */
    void (*mark_integers)(const struct primitive *primitive,
                          const struct viewpoints *viewpoints, bool *marks);
    /* Returns true if all words are finite, by a faster method than to compute them.
     * NULL: there is no such method. */
    bool (*is_finite)(const struct primitive *primitive);
    /* Returns true if the shape needs no space of its own: its words are in the world,
     * or are converted to it. NULL: it needs one. */
    bool (*carry)(const struct primitive *primitive, double *words);

    /* Returns the limit of segments; NULL: it is kernels.segments. */
    size_t (*segments)(const struct primitive *primitive);
    /* Returns true if the primitive has an invisible body. NULL: none has. */
    bool (*has_body)(const struct primitive *primitive);
    /* Returns the limit of crossings of a ray, each of which has a triangle. NULL: hits
     * have no triangle. */
    size_t (*crossings)(const struct primitive *primitive);
    const char *region; /* of the accounts, for its kernels */
    /* A symbol that is 1 in scenes with this shape; its kernels are assembled only
     * then. NULL: they always are. */
    const char *symbol;
    struct shape_kernels kernels;
    /* Returns true if a primitive uses the second set of routines, `other`. NULL: there
     * is one set only. */
    bool (*is_other)(const struct primitive *primitive);
    struct shape_kernels other;
    /* Returns true if the kernel of 1984 supports the primitive; NULL: it does if there
     * is one. */
    bool (*is_historical)(const struct primitive *primitive);
    /* The words of that kernel; NULL: the same as `words`. */
    size_t (*historical_words)(const struct primitive *primitive, double *words);
    /* Describes how points are distributed over the surface; the caller frees the
     * emitter. Returns the reason why this is not possible, or NULL. NULL: the surface
     * is sampled by lines only. */
    const char *(*emit)(const struct primitive *primitive, struct emitter *emitter);
};

#define SHAPE(KIND, name, ...) extern const struct shape shape_##name;
#include "rt/shapes/shapes.def"

/* By primitive_kind. */
extern const struct shape *const shapes[PRIMITIVE_KINDS];
const struct shape *shape_of(const struct primitive *primitive);
/* Returns the set of routines that the primitive uses. */
const struct shape_kernels *shape_kernels_of(const struct primitive *primitive);
/* Returns true if the primitive has no inside. */
bool shape_is_surface(const struct primitive *primitive);
/* Marks the primitive as invisible. Returns the reason. */
const char *shape_empty(struct primitive *primitive, const char *reason);

/* The kernels of all shapes, as texts that a program includes:
 *
 *   shapes/every_scalar.s         shapes/NAME_scalar.s of each row of shapes.def
 *   shapes/every_vector.s         shapes/NAME_vector.s
 *   shapes/every_normal.s         shapes/normal_NAME.s, for both forms
 *
 * A row without its kernels therefore fails to assemble.
 */
extern const struct text shape_texts[];

#endif
