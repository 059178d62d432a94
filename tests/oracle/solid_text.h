/* solid_text.h - solids and other parts of random scenes as scene texts. */
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
    char shape[SOLID_WORDS]; /* the text of the shape up to its modifiers */
    char look[SOLID_WORDS], motion[SOLID_WORDS];
    bool inverse;
    size_t count;
    struct solid **parts;
    struct solid *clip; /* clips this solid before its motion; NULL: no clipping */
};

/* Allocates zeroed memory. If out of memory, ends the program. */
void *test_room(size_t size);
/* Opens a stream. When it is closed, *words is its output. */
FILE *test_text(char **words);
/* Prints a formatted text to the words of a solid. */
void solid_words(char words[SOLID_WORDS], const char *format, ...);

/* Freeing a solid also frees its parts. */
struct solid *solid_new(enum solid_joining joining, size_t count);
struct solid *solid_copy(const struct solid *solid);
void solid_free(struct solid *solid);

/* Prints the solid so that each line or block can be removed (text_shrunk). */
void solid_print(const struct solid *solid, FILE *text);

/* Returns the text of a scene, which contains settings, a camera, lamps and solids. The
 * solids are scaled. The caller frees the text. */
char *solids_text(const char *settings, const char *view, char (*lamps)[SOLID_WORDS],
                  size_t lamp_count, struct solid *const *solids, size_t count,
                  double scale);

/* --- shrinking a text that fails a test ------------------------------------- */

/* Removes lines, blocks, and first and last lines of blocks while the rest still fails.
 * Makes at most `most` trials. Frees the text. The caller frees the smaller text. */
char *text_shrunk(char *text, size_t most,
                  bool (*fails)(const char *text, void *context), void *context);

/* Returns the text with indented blocks. Frees the original. */
char *text_indented(char *text);

/* --- lights with a direction, normals, closed meshes and height fields ------- */

/* Prints keywords for the beam, parallel rays and attenuation of every second light.
 * The text starts with a space. The rest of the scene does not depend on it. */
void beam_words(uint64_t state, const double position[3], double size,
                char words[SOLID_WORDS]);

/* Adds a normal to one in `in` looks. The rest of the scene does not change. */
void bump_words(uint64_t state, size_t in, char look[SOLID_WORDS]);

/* Prints a box of triangles. A diagonal divides each face into two triangles. */
void mesh_box_words(uint64_t state, double corner[2][3], char words[SOLID_WORDS]);
/* Prints a star around the origin with radius 1. It has near and far points, and an
 * apex above and below, so that a line can cross it many times. */
void mesh_star_words(uint64_t state, char words[SOLID_WORDS]);
/* Prints a height field with the same width, which may have a water level. */
void mesh_field_words(uint64_t state, char words[SOLID_WORDS]);

#endif
