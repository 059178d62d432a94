/* shape.h - what all of the house knows of a sort of primitive.
 *
 * Each has one descriptor, in its own file: what is read of it, its bound, its
 * words for the machine, its routines among the kernels.  rt/shapes/shapes.def
 * lists them; a row without its descriptor does not link.
 */
#ifndef RT_SHAPE_H
#define RT_SHAPE_H

#include "rt/shapes/bound.h"
#include "rt/shapes/emitter.h"
#include "rt/shapes/viewpoints.h"
#include "rt/shapes/primitive.h"

/* How closely roots are found, beside the size of the shape. */
#define ROOT_RESOLUTION 0x1p-44

/* ---- What is in its braces ------------------------------------------- */

/* Its arguments, one after another, with commas between them that may be left
 * out.  Messages say what it is. */
enum shape_takes {
    TAKES_END,
    TAKES_NUMBER,
    TAKES_VECTOR,
    TAKES_RADIUS, /* counts by its size */
    TAKES_SIZE,   /* a number above 0 */
    TAKES_MORE,   /* a number that may be left out */
    TAKES_TERMS,  /* numbers in < > */
    TAKES_WORD,   /* may be there: a bool says whether it does */
    TAKES_USUAL,  /* a word that may be there and says what is so anyway */
    TAKES_OTHER,  /* a word of POV-Ray's that is not supported */
    TAKES_PATH,   /* a number of points, count at least, and the points,
                     to a struct outline; there is room for twice as many */
};

struct shape_field {
    enum shape_takes takes;
    size_t offset;      /* where it goes, within struct primitive */
    const char *what;   /* its name in messages; the word itself */
    size_t count;       /* of them; 0: one */
    const char *behind; /* they may be left out, and are behind this word */
};
/* Where a member of shape.name stands. */
#define SHAPE_AT(name, member) offsetof(struct primitive, shape.name.member)

/* ---- Its routines -------------------------------------------------------- */

/* Names among the kernels, the same in both forms of the program. */
struct shape_kernels {
    const char *kernel; /* the crossing of a ray that it meets first */
    const char *normal;
    size_t segments;               /* of a ray, inside, at most; 0: a surface,
                               that has no inside */
    const char *solid;             /* of one that is in a tree: all crossings;
                               NULL: the first routine finds them all */
    const char *state;             /* in a tree, of an open shape: the segments
                               inside of the closed one; else NULL */
    const char *inside;            /* in a tree, of one that may be a surface or a
                               solid: the segments of a solid; else NULL */
    const char *body;              /* .. or may have a body that is not seen: what
                               is inside of that */
    const char *historical;        /* the kernel of 1984 */
    const char *historical_normal; /* where that notes what a normal needs:
                                      two parameters of a hit; else NULL */
};

/* ---- The descriptor ------------------------------------------------------ */

enum { MAX_SHAPE_WORDS = 16, MAX_PATH = 2000 };

struct shape {
    /* Up to TAKES_END; of a mesh, for which the language has a file, none. */
    const struct shape_field *fields;
    /* What is read becomes what is traced.  Returns what is wrong with it, or
     * NULL; shape_empty of the reason if nothing is seen of it. */
    const char *(*finish)(struct primitive *primitive);
    const char *povray; /* its name in POV-Ray; NULL: it has none */

    /* A sphere in the world that nothing of it reaches beyond, or
     * bound_none. */
    void (*bound)(const struct primitive *primitive, struct bound *bound);
    bool endless; /* its inside, which trees ask for, reaches beyond that */

    /* What a set-up program would work out once: reciprocals, axes, the words
     * of P_SHAPE in the order of rt/kernels/frame/records.s.  Returns how
     * many. */
    size_t (*words)(const struct primitive *primitive, double *words);
    /* Any number of further words, to which the record has an address: how
     * many, and, if table is not NULL, the words, or 0 if there is no memory
     * to work them out.  What is asked of it may be planned by where many
     * rays go through; eyes may be NULL.  NULL: none. */
    size_t (*table)(const struct primitive *primitive,
                    const struct viewpoints *viewpoints, double *table);
    /* Which of them are integers: marks these where no mark is.  NULL: all are
     * numbers. */
    void (*mark_integers)(const struct primitive *primitive,
                          const struct viewpoints *viewpoints, bool *marks);
    /* Whether all are finite, if that is told sooner than by working them
     * out; or NULL. */
    bool (*is_finite)(const struct primitive *primitive);
    /* Whether it needs no space of its own: its words are told, or are told
     * again, in the world.  NULL: it needs one. */
    bool (*carry)(const struct primitive *primitive, double *words);

    /* Where it is not kernels.segments; NULL: it is. */
    size_t (*segments)(const struct primitive *primitive);
    /* Whether it has such a body.  NULL: it has none. */
    bool (*has_body)(const struct primitive *primitive);
    /* A hit has a triangle: all of a ray's crossings, of which there are so many
     * at most, have theirs.  NULL: it has none. */
    size_t (*crossings)(const struct primitive *primitive);
    const char *region; /* of the accounts, in which its kernels run */
    /* Of kernels that are assembled for scenes with such a shape alone: it is 1
     * there.  NULL: they always are. */
    const char *symbol;
    struct shape_kernels kernels;
    /* Some have two sorts: when it is the other one (or NULL), and the
     * routines of that. */
    bool (*is_other)(const struct primitive *primitive);
    struct shape_kernels other;
    /* Whether the kernel of 1984 can trace it; NULL: where there is one. */
    bool (*is_historical)(const struct primitive *primitive);
    /* Its words, as above; NULL: the same. */
    size_t (*historical_words)(const struct primitive *primitive, double *words);
    /* How points are spread over its surface; what it has is freed by who
     * asks.  Returns why there is nothing of the kind, or NULL.  NULL: its
     * surface is found by lines alone. */
    const char *(*emit)(const struct primitive *primitive, struct emitter *emitter);
};

#define SHAPE(KIND, name, ...) extern const struct shape shape_##name;
#include "rt/shapes/shapes.def"

/* By PRIMITIVE_.. */
extern const struct shape *const shapes[PRIMITIVE_KINDS];
const struct shape *shape_of(const struct primitive *primitive);
/* Those of its sort. */
const struct shape_kernels *shape_kernels_of(const struct primitive *primitive);
/* Has it no inside? */
bool shape_is_surface(const struct primitive *primitive);
/* Marks it as one of which nothing is seen.  Returns the reason. */
const char *shape_empty(struct primitive *primitive, const char *reason);

#endif
