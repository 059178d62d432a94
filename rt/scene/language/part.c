/* part.c - parses the statement that names a part and sets its physical values.
 *
 *   part { "NAME" density F emissivity F temperature F }
 *
 * in an object gives the object a name for the computation of masses and heat. It also
 * sets values, like the floats NAME_Density, NAME_Emissivity and NAME_Temperature
 * (rt/scene/named_values.h). POV-Ray has no such word: `#ifdef (part)` distinguishes
 * the two programs.
 */
#include "rt/scene/language/scene_statement.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/string_value.h"

enum { MAX_NAME = 200 };

/* Stores a float of the scene. Its name consists of the name of the part and the
 * keyword, such as Lid_Density. */
static bool read_value(struct reader *reader, const struct item *item)
{
    const char *part = item->subject, *word = item->at.text;
    char name[MAX_NAME + 20];
    double value;
    if (!read_number(reader, &value))
        return false;
    snprintf(name, sizeof name, "%s_%c%.*s", part, toupper((int)word[0]),
             (int)item->at.length - 1, word + 1);
    return reader_keep_float(reader, name, strlen(name), value)
           || reader_no_memory(reader);
}

static const struct keyword words[] = {
    { "density emissivity temperature", read_value, 0 },
    { NULL, NULL, 0 },
};
static const struct grammar grammar = { "a keyword of part", .tables = { words } };

static bool read_name(struct reader *reader, char name[MAX_NAME + 1])
{
    struct scene_token at = reader->token;
    char *string;
    bool good;
    if (!starts_string(reader))
        return reader_expected(reader, "the name of the part as a string");
    if (!string_read(reader, &string))
        return false;
    good = (*string && strlen(string) <= MAX_NAME)
           || reader_fault(reader, &at,
                           "the name of a part must have between 1 and %d characters",
                           MAX_NAME);
    if (good)
        strcpy(name, string);
    free(string);
    return good;
}

bool part_read(struct reader *reader, const struct item *item)
{
    struct scene_object *object = item->subject;
    struct block block;
    char name[MAX_NAME + 1] = "";
    bool good;
    if (!block_open(reader, &block, '{'))
        return false;
    good = read_name(reader, name);
    if (good) {
        object->name = arena_text(&reader->scene->kept, name, strlen(name));
        if (!object->name)
            return reader_no_memory(reader);
        object->named = true;
    }
    return block_items(reader, &block, &grammar, name, good);
}
