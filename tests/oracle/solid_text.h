/* solid_text.h - solids in the scene language. */
#ifndef SOLID_TEXT_H
#define SOLID_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { SOLID_WORDS = 800 };

enum solid_joining { SHAPE, UNION, MERGE, INTERSECTION, DIFFERENCE };

/* A shape, or an operation on parts. */
struct solid {
    enum solid_joining joining;
    char shape[SOLID_WORDS]; /* up to its modifiers */
    char look[SOLID_WORDS], motion[SOLID_WORDS];
    bool inverse;
    size_t count;
    struct solid **parts;
    struct solid *clip; /* clips this solid before its motion; or NULL */
};

/* Allocates zeros; exits if memory is short. */
void *test_room(size_t size);
/* Opens a stream whose output is in words after it is closed. */
FILE *test_text(char **words);
/* Prints to a text of a solid. */
void solid_words(char words[SOLID_WORDS], const char *format, ...);

/* Freeing a solid frees its parts. */
struct solid *solid_new(enum solid_joining joining, size_t count);
struct solid *solid_copy(const struct solid *solid);
void solid_free(struct solid *solid);

/* Prints line by line; a line or a block can be removed (text_shrink.h). */
void solid_print(const struct solid *solid, FILE *text);

/* Returns the text of a scene: settings, a camera, lamps, and solids, which are scaled;
 * the caller frees it. */
char *solids_text(const char *settings, const char *view, char (*lamps)[SOLID_WORDS],
                  size_t lamp_count, struct solid *const *solids, size_t count,
                  double scale);

#endif
