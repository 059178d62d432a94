/* solid_text.h - solids in the scene language. */
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

/* Line by line: what may be left out is a line or a block. */
void solid_print(const struct solid *solid, FILE *text);

#endif
