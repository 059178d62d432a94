/* value.h - what a name of a scene file can stand for. */
#ifndef RT_SCENE_VALUE_H
#define RT_SCENE_VALUE_H

#include "rt/scene/language/note.h"
#include "rt/scene/language/object.h"
#include "rt/scene/language/token.h"

/* A float (1), a vector (2 to 5) or a colour (5: red, green, blue, filter,
 * transmit). */
enum { COLOR_TERMS = 5 };
struct numbers {
    int count;
    double n[COLOR_TERMS]; /* 0 from count on */
};

struct numbers numbers_of(double value);
/* To at least `count` terms: a float in all of them, a vector with zeros. */
void numbers_widen(struct numbers *numbers, int count);
bool numbers_are_finite(const struct numbers *numbers);

/* A camera as its vectors are before and after look_at. */
struct camera_setting {
    struct camera camera;
    double sky[3];
    bool spanned; /* an orthographic one shows as much as it has to */
};

/* Of its pigments the lowest. */
struct sky_setting {
    struct pigment pigment;
    size_t pigments;
};

struct fog_setting {
    struct fog fog;
    bool grounded; /* of another type than the constant one */
};

enum scene_value_kind {
    VALUE_NUMBERS,
    VALUE_PIGMENT,
    VALUE_FINISH,
    VALUE_TEXTURE,
    VALUE_COLOR_MAP,   /* a pigment with it */
    VALUE_PIGMENT_MAP, /* the same */
    VALUE_TEXTURE_MAP, /* its first texture */
    VALUE_NORMAL,
    VALUE_NORMAL_MAP, /* a normal with it */
    VALUE_SLOPE_MAP,  /* the same */
    VALUE_LOOK,       /* nothing of it is drawn */
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
    VALUE_FAULTY /* its declaration has an error, reported there */
};

/* A row of values of one kind, of one dimension or more. */
enum { MAX_DIMENSIONS = 5 };
#define MAX_CELLS 100000
struct array {
    size_t dimensions, sizes[MAX_DIMENSIONS];
    size_t count;               /* the product of the sizes */
    bool typed;                 /* by the first value: */
    enum scene_value_kind kind; /* all are of its kind, */
    int terms;                  /* numbers of as many terms */
    size_t *cells;              /* of all arrays, with these */
    struct scene_value *cell[]; /* the last index runs fastest; NULL: not set */
};

/* The body of a macro, as it is in its source. */
enum { MAX_PARAMETERS = 56 };
struct scene_macro {
    const struct scene_source *source;
    struct text_place body;
    size_t end; /* offset */
    size_t count;
    struct {
        const char *text;
        size_t length;
    } parameters[MAX_PARAMETERS];
};

/* What #fopen opens. */
struct data_file {
    bool reads;                        /* and does not write */
    const struct scene_source *source; /* that is read; NULL: to its end */
    struct text_place place;           /* of what is read next */
};

struct formula;
struct spline;
struct scene_value {
    enum scene_value_kind kind;
    union {
        struct numbers numbers;
        struct pigment pigment; /* of maps, too */
        struct finish finish;
        struct texture texture;
        struct bumps bumps; /* of maps, too */
        struct sky_setting sky;
        struct fog_setting fog;
        double interior;              /* its index of refraction */
        struct scene_object material; /* without parts */
        struct placement transform;
        struct camera_setting camera;
        struct scene_object object;
        char *string;
        struct array *array;
        struct scene_macro *macro;
        const struct formula *formula;
        struct spline *spline; /* held */
        struct data_file file;
    } is;
    struct notes *notes; /* of its text */
};

void value_free(struct scene_value *value);
/* A copy; NULL, or why there is none. */
const char *value_copy(struct scene_value *copy, const struct scene_value *value);

/* The functions that return text return why they failed, or NULL. */
extern const char no_memory[];

/* NULL: there are more than MAX_CELLS cells in all, or no memory. */
struct array *array_new(size_t dimensions, const size_t *sizes, size_t *cells);
const char *array_copy(struct array **copy, const struct array *array);
void array_free(struct array *array);
/* Takes the value over in any case. */
const char *array_set(struct array *array, size_t element, struct scene_value *value);
/* The arrays within each other, this one counted. */
size_t array_nesting(const struct array *array);
/* Primitives and lights in all objects. */
size_t array_primitives(const struct array *array);

#endif
