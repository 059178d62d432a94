/* solid_text.c - see solid_text.h. */
#include "tests/oracle/solid_text.h"

#include <stdarg.h>
#include <stdlib.h>

void *test_room(size_t size)
{
    void *made = calloc(1, size);
    if (!made) {
        fputs("no memory left\n", stderr);
        exit(2);
    }
    return made;
}

FILE *test_text(char **words)
{
    static size_t size;
    FILE *text = open_memstream(words, &size);
    if (!text) {
        fputs("no memory left\n", stderr);
        exit(2);
    }
    return text;
}

void solid_words(char words[SOLID_WORDS], const char *format, ...)
{
    va_list values;
    va_start(values, format);
    vsnprintf(words, SOLID_WORDS, format, values);
    va_end(values);
}

struct solid *solid_new(enum solid_joining joining, size_t count)
{
    struct solid *solid = test_room(sizeof *solid);
    solid->joining = joining;
    solid->count = count;
    solid->parts = test_room((count + 1) * sizeof *solid->parts);
    return solid;
}

void solid_free(struct solid *solid)
{
    for (size_t i = 0; i < solid->count; i++)
        solid_free(solid->parts[i]);
    if (solid->clip)
        solid_free(solid->clip);
    free(solid->parts);
    free(solid);
}

struct solid *solid_copy(const struct solid *solid)
{
    struct solid *copy = solid_new(solid->joining, solid->count);
    struct solid **parts = copy->parts;
    *copy = *solid;
    copy->parts = parts;
    for (size_t i = 0; i < solid->count; i++)
        parts[i] = solid_copy(solid->parts[i]);
    if (solid->clip)
        copy->clip = solid_copy(solid->clip);
    return copy;
}

void solid_print(const struct solid *solid, int depth, FILE *text)
{
    static const char *const words[] = {
        [UNION] = "union",
        [MERGE] = "merge",
        [INTERSECTION] = "intersection",
        [DIFFERENCE] = "difference",
    };
    fprintf(text, "%*s", 4 * depth, "");
    if (solid->joining == SHAPE)
        fprintf(text, "%s", solid->shape);
    else
        fprintf(text, "%s {\n", words[solid->joining]);
    for (size_t i = 0; i < solid->count; i++)
        solid_print(solid->parts[i], depth + 1, text);
    if (solid->count > 0)
        fprintf(text, "%*s", 4 * depth, "");
    if (solid->clip) {
        fprintf(text, "clipped_by {\n");
        solid_print(solid->clip, depth + 1, text);
        fprintf(text, "%*s} ", 4 * depth, "");
    }
    fprintf(text, "%s%s%s}\n", solid->look, solid->inverse ? "inverse " : "",
            solid->motion);
}

/* --- with something left out ---------------------------------------------- */

bool solid_is_next(size_t *way)
{
    return (*way)-- == 0;
}

void solid_take_out(struct solid **solids, size_t *count, size_t i)
{
    solid_free(solids[i]);
    for (*count -= 1; i < *count; i++)
        solids[i] = solids[i + 1];
}

static bool leave_out_words(char *words, size_t *way)
{
    if (words[0] == '\0' || !solid_is_next(way))
        return false;
    words[0] = '\0';
    return true;
}

static bool leave_out_whole(struct solid **place, size_t *way)
{
    struct solid *solid = *place;
    for (size_t i = 0; i < solid->count; i++)
        if (solid_is_next(way)) {
            *place = solid_copy(solid->parts[i]);
            solid_free(solid);
            return true;
        }
    return false;
}

bool solid_leave_out(struct solid **place, size_t *way)
{
    if (leave_out_whole(place, way))
        return true;
    struct solid *solid = *place;
    for (size_t i = 0; solid->count > 2 && i < solid->count; i++)
        if (solid_is_next(way)) {
            solid_take_out(solid->parts, &solid->count, i);
            return true;
        }
    for (size_t i = 0; i < solid->count; i++)
        if (solid_leave_out(&solid->parts[i], way))
            return true;
    if (leave_out_words(solid->look, way) || leave_out_words(solid->motion, way))
        return true;
    if (solid->inverse && solid_is_next(way)) {
        solid->inverse = false;
        return true;
    }
    if (!solid->clip || !solid_is_next(way))
        return false;
    solid_free(solid->clip);
    solid->clip = NULL;
    return true;
}
