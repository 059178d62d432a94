/* value.h - the values that a name in a scene file can have, from floats to cameras,
 * and operations on them. */
#ifndef RT_SCENE_VALUE_H
#define RT_SCENE_VALUE_H

#include "rt/scene/language/deduplicated_warnings.h"
#include "rt/scene/language/scene_object.h"
#include "rt/scene/language/token.h"

/* A float (1 component), a vector (2 to 5) or a colour (5: red, green, blue, filter,
 * transmit). */
enum { COLOR_TERMS = 5 };
struct numbers {
    int count;
    double n[COLOR_TERMS]; /* components from `count` on are 0 */
};

struct numbers numbers_of(double value);
/* Extends numbers to at least `count` components. A float is copied to all components;
 * a vector is filled with zeros. */
void numbers_widen(struct numbers *numbers, int count);
bool numbers_are_finite(const struct numbers *numbers);

/* A camera: the value of a name, or a camera whose block is being read. After its
 * block, look_at and the transforms have been applied to its vectors. */
struct camera_setting {
    struct camera camera;
    double sky[3];
    bool spanned; /* an orthographic camera whose size has been computed */
};

/* A sky_sphere: its lowest pigment, and the number of its pigments. */
struct sky_setting {
    struct pigment pigment;
    size_t pigments;
};

struct fog_setting {
    struct fog fog;
    bool grounded; /* a fog of another type than constant fog, which is not supported */
};

enum scene_value_kind {
    VALUE_NUMBERS,
    VALUE_PIGMENT,
    VALUE_FINISH,
    VALUE_TEXTURE,
    VALUE_COLOR_MAP,   /* stored as a pigment with the map */
    VALUE_PIGMENT_MAP, /* stored as a pigment with the map */
    VALUE_TEXTURE_MAP, /* stored as its first texture */
    VALUE_NORMAL,
    VALUE_NORMAL_MAP,
    VALUE_SLOPE_MAP, /* stored as a bump with the map */
    VALUE_LOOK,      /* a feature that is not supported */
    VALUE_SKY,
    VALUE_FOG,
    VALUE_INTERIOR,
    VALUE_MATERIAL,
    VALUE_TRANSFORM,
    VALUE_CAMERA,
    VALUE_OBJECT,
    VALUE_STRING,
    VALUE_ARRAY,
    VALUE_MACRO,
    VALUE_FUNCTION,
    VALUE_SPLINE,
    VALUE_FILE,
    VALUE_FAULTY /* the declaration has an error that has been reported */
};

/* An array of values of one kind, with one or more dimensions. */
enum { MAX_DIMENSIONS = 5 };
#define MAX_CELLS 100000
struct array {
    size_t dimensions, sizes[MAX_DIMENSIONS];
    size_t count;               /* product of the sizes */
    bool typed;                 /* the first value has determined the type */
    enum scene_value_kind kind; /* kind of all values */
    int terms;                  /* number of components of all values, if they are
                                 * numbers */
    size_t *cells;              /* number of cells in all arrays, including this one */
    struct scene_value *cell[]; /* in row-major order; NULL: not set */
};

/* A macro. Its body is a range of its source. */
enum { MAX_PARAMETERS = 56 };
struct scene_macro {
    const struct scene_source *source;
    struct text_place body;
    size_t end; /* offset of the body's end */
    size_t count;
    struct {
        const char *text;
        size_t length;
    } parameters[MAX_PARAMETERS];
};

/* A file that #fopen has opened. */
struct data_file {
    bool reads; /* true: open for reading; false: open for writing */
    const struct scene_source *source; /* NULL: all values have been read */
    struct text_place place;           /* position of the next value */
};

struct formula;
struct spline;
struct scene_value {
    enum scene_value_kind kind;
    union {
        struct numbers numbers;
        struct pigment pigment; /* also the value of some maps */
        struct finish finish;
        struct texture texture;
        struct bumps bumps;
        struct bump_list bump_list;
        struct bump bump;
        struct sky_setting sky;
        struct fog_setting fog;
        double interior;              /* refractive index */
        struct scene_object material; /* an object without parts */
        struct placement transform;
        struct camera_setting camera;
        struct scene_object object;
        char *string;
        struct array *array;
        struct scene_macro *macro;
        const struct formula *formula;
        struct spline *spline; /* held by the value */
        struct data_file file;
    } is;
    struct value_warnings *value_warnings; /* warnings about its text */
};

void value_free(struct scene_value *value);
/* Copies a value. Returns the reason of the failure, or NULL. */
const char *value_copy(struct scene_value *copy, const struct scene_value *value);

/* In this file, a function that returns a string returns the reason of a failure, or
 * NULL if there was none. no_memory is one of these reasons. */
extern const char no_memory[];

/* Returns an array without values. Returns NULL if all arrays together would have more
 * than MAX_CELLS cells, or if out of memory. */
struct array *array_new(size_t dimensions, const size_t *sizes, size_t *cells);
const char *array_copy(struct array **copy, const struct array *array);
void array_free(struct array *array);
/* Sets an element of the array. Takes ownership of the value even after a failure. */
const char *array_set(struct array *array, size_t element, struct scene_value *value);
/* Returns the depth of nested arrays, including this one. */
size_t array_nesting(const struct array *array);
/* Returns the number of primitives and lights in all objects of the array. */
size_t array_primitives(const struct array *array);

#endif
