/* solid_text.h - solids and other parts of random scenes in the scene language. */
#ifndef SOLID_TEXT_H
#define SOLID_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
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

/* Prints line by line; a line or a block can be removed (solid_text.h). */
void solid_print(const struct solid *solid, FILE *text);

/* Returns the text of a scene: settings, a camera, lamps, and solids, which are scaled;
 * the caller frees it. */
char *solids_text(const char *settings, const char *view, char (*lamps)[SOLID_WORDS],
                  size_t lamp_count, struct solid *const *solids, size_t count,
                  double scale);

/* --- shrinking a text that fails a test ------------------------------------- */

/* Removes lines and blocks, or the first and last line of a block, as long as the rest
 * fails, in at most `most` trials.  Frees the text; the caller frees the smaller
 * one. */
char *text_shrunk(char *text, size_t most,
                  bool (*fails)(const char *text, void *context), void *context);

/* Returns the text with indented blocks, and frees the original. */
char *text_indented(char *text);

/* --- lights with a direction, normals, closed meshes and height fields ------- */

/* For every other light, prints keywords of its beam, parallel rays and attenuation,
 * otherwise none.  The text starts with a space.  The rest of the scene does not depend
 * on it: the state is a copy of that with which the scene continues. */
void beam_words(uint64_t state, const double position[3], double size,
                char words[SOLID_WORDS]);

/* Adds a normal to one look in `in`.  The rest of the scene does not depend on it: the
 * state is a copy of that with which the scene continues. */
void bump_words(uint64_t state, size_t in, char look[SOLID_WORDS]);

/* Prints a box; each side is split by one of its diagonals. */
void mesh_box_words(uint64_t state, double corner[2][3], char words[SOLID_WORDS]);
/* Prints a star at the origin, within the radius 1: points all round, near and far, an
 * apex above and one below, so that a line may cross it many times. */
void mesh_star_words(uint64_t state, char words[SOLID_WORDS]);
/* Prints a height field of the same width, possibly with water. */
void mesh_field_words(uint64_t state, char words[SOLID_WORDS]);

#endif
