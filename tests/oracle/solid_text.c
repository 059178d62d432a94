/* solid_text.c - builds, copies and prints solids (solid_text.h). */
#include "tests/oracle/solid_text.h"

#include "tests/oracle/give_up.h"

#include <stdarg.h>
#include <stdlib.h>

void *test_room(size_t size)
{
    return NEEDED(calloc(1, size));
}

FILE *test_text(char **words)
{
    static size_t size;
    return NEEDED(open_memstream(words, &size));
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

static void print_line(const char *words, FILE *text)
{
    if (words[0])
        fprintf(text, "%s\n", words);
}

void solid_print(const struct solid *solid, FILE *text)
{
    static const char *const words[] = {
        [UNION] = "union {",
        [MERGE] = "merge {",
        [INTERSECTION] = "intersection {",
        [DIFFERENCE] = "difference {",
    };
    print_line(solid->joining == SHAPE ? solid->shape : words[solid->joining], text);
    for (size_t i = 0; i < solid->count; i++)
        solid_print(solid->parts[i], text);
    if (solid->clip) {
        print_line("clipped_by {", text);
        solid_print(solid->clip, text);
        print_line("}", text);
    }
    print_line(solid->look, text);
    print_line(solid->inverse ? "inverse" : "", text);
    print_line(solid->motion, text);
    print_line("}", text);
}

char *solids_text(const char *settings, const char *view, char (*lamps)[SOLID_WORDS],
                  size_t lamp_count, struct solid *const *solids, size_t count,
                  double scale)
{
    char *words;
    FILE *text = test_text(&words);
    fprintf(text, "#version 3.7;\n%s\nbackground { rgb <.3, .4, .6> }\ncamera { %s }\n",
            settings, view);
    for (size_t i = 0; i < lamp_count; i++)
        fprintf(text, "%s\n", lamps[i]);
    fprintf(text, "#default { pigment { rgb .8 } }\n");
    for (size_t i = 0; i < count; i++) {
        fprintf(text, "%s", scale != 1 ? "object {\n" : "");
        solid_print(solids[i], text);
        if (scale != 1)
            fprintf(text, "scale %g\n}\n", scale);
    }
    fclose(text);
    return words;
}
