/* solid_text.h - solids in the scene language, and smaller ones. */
#ifndef SOLID_TEXT_H
#define SOLID_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { SOLID_WORDS = 800 };

enum solid_joining { SHAPE, UNION, MERGE, INTERSECTION, DIFFERENCE };

/* A shape, or parts that are joined. */
struct solid {
    enum solid_joining joining;
    char shape[SOLID_WORDS]; /* up to its modifiers */
    char look[SOLID_WORDS], motion[SOLID_WORDS];
    bool inverse;
    size_t count;
    struct solid **parts;
    struct solid *clip; /* what it is clipped by, before its motion; or NULL */
};

/* Zeros.  Without memory the test ends. */
void *test_room(size_t size);
/* What is printed to it is the words, once it is closed. */
FILE *test_text(char **words);
/* Into words of a solid. */
void solid_words(char words[SOLID_WORDS], const char *format, ...);

/* All are freed with the whole that they are part of. */
struct solid *solid_new(enum solid_joining joining, size_t count);
struct solid *solid_copy(const struct solid *solid);
void solid_free(struct solid *solid);

void solid_print(const struct solid *solid, int depth, FILE *text);

void solid_take_out(struct solid **solids, size_t *count, size_t i);

/* Ways to leave something out are counted as the solid is walked through: at
 * 0 it is this one. */
bool solid_is_next(size_t *way);
/* False: the solid has no such way, and the way is less by those it has. */
bool solid_leave_out(struct solid **place, size_t *way);

#endif
