/* spelling.c - computes the edit distance with transpositions. */
#include "base/spelling.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>

#include "vm/min_max.h"

/* Words with more letters than this get no suggestion. */
enum { MAX_LETTERS = 40 };

static bool equal(char a, char b)
{
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/* Computes the distance of two words. rows[i][k] is the distance between the first i
 * letters of a and the first k of b. */
static size_t distance(const char *a, size_t a_length, const char *b, size_t b_length)
{
    size_t rows[MAX_LETTERS + 1][MAX_LETTERS + 1];
    for (size_t i = 0; i <= a_length; i++) {
        for (size_t k = 0; k <= b_length; k++) {
            if (i == 0 || k == 0) {
                rows[i][k] = i + k;
                continue;
            }
            rows[i][k] = min_size(rows[i - 1][k - 1] + !equal(a[i - 1], b[k - 1]),
                                  1 + min_size(rows[i - 1][k], rows[i][k - 1]));
            if (i > 1 && k > 1 && equal(a[i - 1], b[k - 2])
                && equal(a[i - 2], b[k - 1]))
                rows[i][k] = min_size(rows[i][k], 1 + rows[i - 2][k - 2]);
        }
    }
    return rows[a_length][b_length];
}

size_t spelling_distance(const char *a, size_t a_length, const char *b, size_t b_length)
{
    return a_length > MAX_LETTERS || b_length > MAX_LETTERS
               ? 2 * MAX_LETTERS
               : distance(a, a_length, b, b_length);
}

void spelling_try(struct spelling *spelling, const char *name)
{
    size_t length = strlen(spelling->word), name_length = strlen(name);
    if (length > MAX_LETTERS || name_length > MAX_LETTERS)
        return;
    size_t wrong = distance(spelling->word, length, name, name_length);
    bool better = !spelling->name || wrong < spelling->distance
                  || (wrong == spelling->distance && name_length == length
                      && strlen(spelling->name) != length);
    if (wrong <= (length + 2) / 3 && better) {
        spelling->name = name;
        spelling->distance = wrong;
    }
}
