/* query.h - functions of floats that ask for something: about strings, names,
 * arrays, random numbers. */
#ifndef RT_SCENE_QUERY_H
#define RT_SCENE_QUERY_H

#include "rt/scene/language/reader.h"

bool is_query_word(const struct scene_token *token);
/* The token is such a word. */
bool query_read(struct reader *reader, double *value);
/* Between the brackets, as it is: a name, or an element of an array. */
bool read_defined(struct reader *reader, double *value);
double string_order(const char *a, const char *b);
void queries_free(struct reader *reader);

#endif
