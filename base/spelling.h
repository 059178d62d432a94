/* spelling.h - suggests the intended name for a misspelt word.
 *
 * An error is a letter omitted, inserted, replaced, or swapped with its neighbour (the
 * distance of Damerau and Levenshtein, computed by the table of Wagner and Fischer). A
 * name is suggested if at most a third of the word's letters are wrong.
 *
 *   struct spelling nearest = { .word = "rnu" };
 *   spelling_try(&nearest, "run");
 *   nearest.name is "run", or NULL if no name is close
 */
#ifndef BASE_SPELLING_H
#define BASE_SPELLING_H

#include <stddef.h>

/* Returns the number of errors between two words, or a large number for words of more
 * than 40 letters. Case is ignored. */
size_t spelling_distance(const char *a, size_t a_length, const char *b,
                         size_t b_length);

struct spelling {
    const char *word;
    const char *name; /* the closest name so far; of equally close names, the first with
                         the length of the word, or else the first */
    size_t distance;
};

/* Replaces spelling->name by this name if it is closer to the word. Case is ignored.
 * The name must remain valid. */
void spelling_try(struct spelling *spelling, const char *name);

#endif
