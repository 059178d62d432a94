/* query.h - functions of the language that return floats about strings, names, arrays
 * and random numbers. */
#ifndef RT_SCENE_QUERY_H
#define RT_SCENE_QUERY_H

#include "rt/scene/language/reader.h"

bool is_query_word(const struct scene_token *token);
/* Reads a call; the current token is the word of such a function. */
bool query_read(struct reader *reader, double *value);
/* Reads the argument of `defined` between the brackets, without interpreting it: a
 * name, or an element of an array. */
bool read_defined(struct reader *reader, double *value);
double string_order(const char *a, const char *b);
void queries_free(struct reader *reader);

#endif
