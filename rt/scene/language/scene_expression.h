/* scene_expression.h - parses and evaluates the expressions of a scene: floats, vectors
 * and colours. */
#ifndef RT_SCENE_EXPRESSION_H
#define RT_SCENE_EXPRESSION_H

#include "rt/scene/language/reader.h"

/* Returns true if the current token can begin an expression. */
bool starts_expression(const struct reader *reader);
/* Returns true if the current token is a keyword of colours such as rgb or red, or the
 * name of a colour. */
bool starts_color(const struct reader *reader);
/* The keywords that can begin a colour. */
#define COLOR_WORDS \
    "color colour rgb rgbf rgbt rgbft srgb srgbf srgbt srgbft red green blue"
bool is_color_word(const struct scene_token *token);
/* Returns true if the token is a constant or a function of the language. */
bool is_expression_word(const struct scene_token *token);

/* Reads a sum. Comparisons, logic and ?: need parentheses. */
bool read_expression(struct reader *reader, struct numbers *value);
bool read_number(struct reader *reader, double *value);
/* Reads an expression that may contain comparisons, logic and ?: without parentheses
 * around them. */
bool read_full(struct reader *reader, struct numbers *value);
bool read_full_number(struct reader *reader, double *value);
/* Two floats are equal if they differ by less than EXPRESSION_SAME. A float is false if
 * its absolute value is less than EXPRESSION_SAME. */
#define EXPRESSION_SAME 1e-10
/* Reads a vector. A float is expanded to three equal components. A zero is added to a
 * vector of two components. */
bool read_vector(struct reader *reader, double vector[3]);
/* Reads vectors with optional commas in between. */
bool read_vectors(struct reader *reader, double (*vectors)[3], size_t count);
/* Reads a colour in any form, and returns its five components. */
bool read_color(struct reader *reader, struct numbers *color);
/* Like read_color, after the first word of the colour has been read. */
bool read_color_after(struct reader *reader, const struct scene_token *word,
                      struct numbers *color);
/* Reads the red, green and blue of a light or a background. */
bool read_rgb(struct reader *reader, double rgb[3]);

/* ---- Functions about strings, files, names, arrays and random numbers ---- */

bool is_query_word(const struct scene_token *token);
/* Evaluates a call of a function that returns a float, such as strlen. The current
 * token is the keyword of the function. */
bool query_read(struct reader *reader, double *value);
/* Reads a name or an element of an array, the argument of `defined`. Sets *value to 1
 * if it is defined, else to 0. */
bool read_defined(struct reader *reader, double *value);
double string_order(const char *a, const char *b);
void queries_free(struct reader *reader);

/* ---- Operands ------------------------------------------------------------ */

/* Reads primary { "." component } of the grammar in scene_expression.c. */
bool operand_read(struct reader *reader, struct numbers *value);
/* Reads NAME(t) or NAME(t, kind), a call of the spline that the current token names. */
bool spline_call(struct reader *reader, struct numbers *value);

/* operand_float reports an error if the value is not a float. Both functions report an
 * error if the value is not finite, because of an overflow or an argument outside of a
 * function's domain. */
bool operand_float(struct reader *reader, const struct scene_token *at,
                   const struct numbers *value);
bool operand_finite(struct reader *reader, const struct scene_token *at,
                    const struct numbers *value);
/* Reports that a value has too many components. Returns false. */
bool operand_found_vector(struct reader *reader, const struct scene_token *at,
                          const char *expected, const struct numbers *value);

/* ---- Functions of floats and vectors ------------------------------------- */

/* A function that expressions of a scene can call, such as sin or vcross. */
struct function {
    const char *name;
    const char *takes; /* kinds of its arguments: f a float, v a vector, ? an optional
                        * float, + any number of further arguments */
    double (*plain)(double);        /* a function of one float */
    double (*pair)(double, double); /* a function of two floats; with more floats it is
                                     * applied from the left */
    void (*apply)(const struct numbers *arguments, size_t count,
                  struct numbers *result); /* a function of any arguments */
};
enum { MAX_ARGUMENTS = 32 };
const struct function *function_find(const struct scene_token *token);
void function_apply(const struct function *function, const struct numbers *arguments,
                    size_t count, struct numbers *result);

#endif
