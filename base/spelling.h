/* spelling.h - which name somebody meant who wrote it wrongly.
 *
 * Letters left out, put in, exchanged or swapped with their neighbour count
 * one each (the distance of Damerau and Levenshtein, of which Wagner and
 * Fischer's table is the method).  A name is meant when a third of the word's
 * letters or fewer are wrong.
 *
 *   struct spelling nearest = { .word = "rnu" };
 *   spelling_try(&nearest, "run");
 *   nearest.name is "run", or NULL if nothing is near
 */
#ifndef BASE_SPELLING_H
#define BASE_SPELLING_H

#include <stddef.h>

/* How many letters make one of the other; a long way for words of more than 40.
 * Capitals do not count. */
size_t spelling_distance(const char *a, size_t a_length, const char *b,
                         size_t b_length);

struct spelling {
    const char *word;
    const char *name; /* the nearest so far; of equals one that is as long as
                         the word, or else the first */
    size_t distance;
};

/* The name must outlive its use; capitals do not count. */
void spelling_try(struct spelling *spelling, const char *name);

#endif
