/* model_find.c - loads machine models by name. Built-in models are texts of the
 * program, and others are files. */
#include "vm/time/model_parts.h"
#include "vm/error.h"
#include "vm/text.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool c205_model_is_file(const char *name)
{
    size_t length = strlen(name);
    return !strcmp(name, "-") || strchr(name, '/')
           || (length >= 6 && !strcmp(name + length - 6, ".model"));
}

static char *join_lines(const char *const *lines)
{
    size_t size = 1;
    for (size_t i = 0; lines[i]; i++)
        size += strlen(lines[i]);
    char *text = malloc(size), *end = text;
    if (!text)
        return NULL;
    for (size_t i = 0; lines[i]; i++) {
        size_t length = strlen(lines[i]);
        memcpy(end, lines[i], length);
        end += length;
    }
    *end = '\0';
    return text;
}

/* Returns the content of a file, or NULL with a message. */
static char *read_file(const char *path, c205_error *error)
{
    errno = 0;
    FILE *file = strcmp(path, "-") ? fopen(path, "rb") : stdin;
    size_t size = 0, room = 1 << 16;
    char *text = file ? malloc(room) : NULL;
    while (text) {
        size += fread(text + size, 1, room - size - 1, file);
        if (size + 1 < room)
            break;
        char *larger = realloc(text, room *= 2);
        if (!larger)
            free(text);
        text = larger;
    }
    const char *fault = text && !ferror(file) ? c205_plain_text(text, &size)
                                              : strerror(errno);
    if (!fault && memchr(text, '\0', size))
        fault = "not a text file";
    if (file && file != stdin)
        fclose(file);
    if (!fault)
        return text;
    free(text);
    error_set(error, "cannot read the machine model %.160s: %s", path, fault);
    return NULL;
}

static char *built_in_text(const char *name, c205_error *error)
{
    for (size_t i = 0; model_texts_names[i]; i++)
        if (!strcmp(model_texts_names[i], name)) {
            char *text = join_lines(model_texts[i].lines);
            return text ? text : model_out_of_memory(error);
        }
    error_set(error, "unknown machine model '%.100s'", name);
    return NULL;
}

c205_model *c205_model_find(const char *name, c205_error *error)
{
    char *text = c205_model_is_file(name) ? read_file(name, error)
                                          : built_in_text(name, error);
    c205_model *model = text ? c205_model_parse(name, text, error) : NULL;
    free(text);
    return model;
}

const char *const *c205_model_names(void)
{
    return model_texts_names;
}
