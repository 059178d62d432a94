/* value.h - what a name of a scene file can stand for. */
#ifndef RT_SCENE_VALUE_H
#define RT_SCENE_VALUE_H

#include "rt/scene/object.h"

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

/* A camera as its vectors stand before and after look_at. */
struct camera_setting {
    struct camera camera;
    double sky[3];
};

enum value_kind {
    VALUE_NUMBERS,
    VALUE_PIGMENT,
    VALUE_FINISH,
    VALUE_TEXTURE,
    VALUE_TRANSFORM,
    VALUE_CAMERA,
    VALUE_OBJECT,
    VALUE_FAULTY /* its declaration has an error, reported there */
};
const char *value_kind_name(enum value_kind kind);

struct value {
    enum value_kind kind;
    union {
        struct numbers numbers;
        struct pigment pigment;
        struct finish finish;
        struct texture texture;
        struct placement transform;
        struct camera_setting camera;
        struct object object;
    } is;
};

void value_free(struct value *value);

/* Names and their values.  Level 0 holds what #declare makes; level n what
 * #local makes in the n-th open file, the main file being the first. */
enum { SYMBOL_BUCKETS = 1024 };
struct symbols {
    struct symbol *buckets[SYMBOL_BUCKETS];
};

/* The value of the innermost level that has the name, or NULL. */
const struct value *symbols_find(const struct symbols *symbols,
                                 const char *name, size_t length);
/* Takes the value over, also when it returns false: out of memory. */
bool symbols_set(struct symbols *symbols, size_t level, const char *name,
                 size_t length, struct value *value);
/* Forget the innermost value of a name; false: there is none. */
bool symbols_remove(struct symbols *symbols, const char *name, size_t length);
/* Forget all names of the levels above. */
void symbols_leave(struct symbols *symbols, size_t level);
void symbols_free(struct symbols *symbols);

#endif
