/* expression.h - floats, vectors and colours, and what makes them. */
#ifndef RT_SCENE_EXPRESSION_H
#define RT_SCENE_EXPRESSION_H

#include "rt/scene/language/reader.h"

/* Whether the next token can begin one. */
bool starts_expression(const struct reader *reader);
/* A word like rgb or red, or the name of a colour. */
bool starts_color(const struct reader *reader);
bool is_color_word(const struct scene_token *token);
/* A constant or a function of the language. */
bool is_expression_word(const struct scene_token *token);

/* Sums; comparisons, logic and ?: stand only in parentheses. */
bool read_expression(struct reader *reader, struct numbers *value);
bool read_number(struct reader *reader, double *value);
/* What is in brackets: comparisons, logic and ?: too. */
bool read_full(struct reader *reader, struct numbers *value);
bool read_full_number(struct reader *reader, double *value);
/* Closer floats are equal, and a float closer to 0 is false. */
#define EXPRESSION_SAME 1e-10
/* A float stands for three equal components, two numbers have a zero third. */
bool read_vector(struct reader *reader, double vector[3]);
/* All five terms. */
bool read_color(struct reader *reader, struct numbers *color);
/* The same after its first word, which is a colour word. */
bool read_color_after(struct reader *reader, const struct scene_token *word,
                      struct numbers *color);
/* The three that a light or a background has. */
bool read_rgb(struct reader *reader, double rgb[3]);

/* A function of the language and what it makes of its arguments. */
struct function {
    const char *name;
    const char *takes; /* f a float, v a vector; ? one more
                          float or none, + any number more */
    void (*apply)(const struct numbers *arguments, size_t count,
                  struct numbers *result);
    double (*plain)(double); /* instead, for one float */
};
enum { MAX_ARGUMENTS = 32 };
const struct function *function_find(const struct scene_token *token);

#endif
