/* query.c - evaluates the functions of strings, files, names, arrays and random
 * streams, whose value is a float. */
#include "rt/scene/language/scene_expression.h"

#include "base/array.h"
#include "rt/scene/language/array_element.h"
#include "rt/scene/language/string_value.h"
#include "rt/shapes/shape.h"

#include <stdlib.h>
#include <string.h>

/* ---- Strings ------------------------------------------------------------- */

typedef double string_measure(const char *string);

static bool read_measure(struct reader *reader, string_measure *measure, double *value)
{
    char *string;
    if (!string_read(reader, &string))
        return false;
    *value = measure(string);
    free(string);
    return true;
}

static double first_code(const char *string)
{
    return (unsigned char)string[0];
}

static double length_of(const char *string)
{
    return (double)strlen(string);
}

static double number_in(const char *string)
{
    return strtod(string, NULL);
}

double string_order(const char *a, const char *b)
{
    while (*a && *a == *b) {
        a++;
        b++;
    }
    return (unsigned char)*a - (unsigned char)*b;
}

static bool read_strcmp(struct reader *reader, double *value)
{
    char *a, *b;
    bool done;
    if (!string_read(reader, &a))
        return false;
    done = reader_expect_sign(reader, ',') && string_read(reader, &b);
    if (done) {
        *value = string_order(a, b);
        free(b);
    }
    free(a);
    return done;
}

static bool read_file_exists(struct reader *reader, double *value)
{
    struct scene_token at = reader->token;
    struct source_request request = {
        .from = at.source,
        .search = reader->options ? reader->options->search : NULL,
    };
    c205_error error;
    char *name;
    if (!string_read(reader, &name))
        return false;
    if (reader->includes++ >= MAX_INCLUDE) {
        free(name);
        return reader_fault(reader, &at, "more than %d files are read", MAX_INCLUDE);
    }
    request.name = name;
    *value = source_include(&reader->sources, &request, &error) != NULL;
    free(name);
    return true;
}

/* ---- Names and arrays ---------------------------------------------------- */

/* Returns true if the token is a keyword that POV-Ray does not have: part, or some of
 * the shapes. */
static bool is_own_word(const struct scene_token *token)
{
    if (is_token(token, "part"))
        return true;
    for (int kind = 0; kind < PRIMITIVE_KINDS; kind++)
        if (!shapes[kind]->povray
            && is_token(token, primitive_kind_name((enum primitive_kind)kind)))
            return true;
    return false;
}

/* Sets *value to 1 if the name is declared. Keywords that only this program has count
 * as declared, so that a scene can test for them. As in POV-Ray, the keywords of
 * POV-Ray do not. */
bool read_defined(struct reader *reader, double *value)
{
    if (reader->token.kind != TOKEN_WORD)
        return reader_expected(reader, "a name");
    *value = is_own_word(&reader->token);
    if (reader_look_up(reader, &reader->token)) {
        if (reader->token.value->kind == VALUE_ARRAY && !element_read_place(reader))
            return false;
        *value = reader->token.value != NULL;
    }
    reader_step(reader);
    reader_resolve(reader);
    return true;
}

/* Returns the array at the current token. If it is not an array, reports an error and
 * returns NULL. */
static const struct array *expect_array(struct reader *reader)
{
    const struct scene_value *value = reader_value_of(reader, VALUE_ARRAY);
    if (!value)
        reader_expected(reader, "an array");
    return value ? value->is.array : NULL;
}

static bool read_dimensions(struct reader *reader, double *value)
{
    const struct array *array = expect_array(reader);
    if (!array)
        return false;
    *value = (double)array->dimensions;
    reader_next(reader);
    return true;
}

/* Reads the arguments of dimension_size, an array and the number of a dimension. The
 * value is 0 if the array does not have this dimension. */
static bool read_dimension_size(struct reader *reader, double *value)
{
    const struct array *array = expect_array(reader);
    size_t sizes[MAX_DIMENSIONS] = { 0 }, count;
    double dimension;
    if (!array)
        return false;
    count = array->dimensions;
    memcpy(sizes, array->sizes, count * sizeof *sizes);
    reader_next(reader);
    if (!reader_expect_sign(reader, ',') || !read_full_number(reader, &dimension))
        return false;
    *value = dimension >= 1 && dimension < (double)count + 1
                 ? (double)sizes[(size_t)dimension - 1]
                 : 0;
    return true;
}

/* ---- Random numbers ------------------------------------------------------ */

/* Starts a random stream and returns its index. */
static bool read_seed(struct reader *reader, double *value)
{
    double most = 2147483648.;
    struct scene_token at = reader->token;
    uint32_t state;
    double seed;
    if (!read_full_number(reader, &seed))
        return false;
    if (!(seed > -most && seed < most))
        return reader_fault(reader, &at, "the seed %g is out of range", seed);
    if (reader->seed_count == MAX_SEEDS)
        return reader_fault(reader, &at, "more than %d random streams", MAX_SEEDS);
    state = (uint32_t)(int32_t)seed;
    *value = (double)reader->seed_count;
    return array_add(&reader->seeds, &reader->seed_count, &state, sizeof state)
           || reader_no_memory(reader);
}

/* Evaluates rand(stream) with POV-Ray's generator, which is linear congruential modulo
 * 2^32. */
static bool read_rand(struct reader *reader, double *value)
{
    struct scene_token at = reader->token;
    double stream;
    uint32_t *seed;
    if (!read_full_number(reader, &stream))
        return false;
    if (!(stream >= 0 && stream < (double)reader->seed_count))
        return reader_fault(reader, &at, "unknown random stream %g", stream);
    seed = &reader->seeds[(size_t)stream];
    *seed = *seed * 1812433253u + 12345u;
    *value = (double)*seed / 4294967295.;
    return true;
}

void queries_free(struct reader *reader)
{
    free(reader->seeds);
}

/* ---- The table of functions ---------------------------------------------- */

static const struct query {
    const char *words;
    bool (*read)(struct reader *reader, double *value);
    string_measure *measure; /* for functions of one string; without `read` and
                              * `measure` the function is not supported */
    bool raw;                /* macros in its argument are not called */
} queries[] = {
    { "asc", .measure = first_code },
    { "defined", .read = read_defined, .raw = true },
    { "dimension_size", .read = read_dimension_size },
    { "dimensions", .read = read_dimensions },
    { "file_exists", .read = read_file_exists },
    { .words = "inside max_extent min_extent now trace vturbulence" },
    { "rand", .read = read_rand },
    { "seed", .read = read_seed },
    { "strcmp", .read = read_strcmp },
    { "strlen", .measure = length_of },
    { "val", .measure = number_in },
};

bool is_query_word(const struct scene_token *token)
{
    return TOKEN_ROW(token, queries);
}

static bool read_brackets(struct reader *reader, const struct query *query,
                          double *value)
{
    if (!reader_require_sign(reader, '('))
        return false;
    if (query->raw)
        reader_step(reader);
    else
        reader_next(reader);
    return (query->measure ? read_measure(reader, query->measure, value)
                           : query->read(reader, value))
           && reader_require_sign(reader, ')');
}

bool query_read(struct reader *reader, double *value)
{
    const struct query *query = TOKEN_ROW(&reader->token, queries);
    size_t hold = reader_nest(reader);
    bool done;
    if (!query->read && !query->measure) {
        reader->hold = hold;
        return reader_fault(reader, &reader->token, "'%.*s' is not supported",
                            TOKEN_TEXT(&reader->token));
    }
    reader_next(reader);
    done = read_brackets(reader, query, value);
    reader->hold = hold;
    if (done)
        reader_next(reader);
    return done;
}
