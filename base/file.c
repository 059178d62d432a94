#include "base/file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The text, its NUL, and a byte to see that the file goes on. */
static const size_t largest = (size_t)FILE_LARGEST + 2;

static char *read_stream(FILE *file, size_t *length)
{
    size_t capacity = 16384;
    char *text = malloc(capacity), *larger;

    *length = 0;
    while (text) {
        *length += fread(text + *length, 1, capacity - *length - 1, file);
        if (*length < capacity - 1 && !ferror(file))
            break;
        larger = ferror(file) || capacity >= largest
                     ? NULL
                     : realloc(text, capacity *= 2);
        if (!larger)
            free(text);
        text = larger;
    }
    if (text)
        text[*length] = '\0';
    return text;
}

char *file_read(const char *path, size_t *length, c205_error *error)
{
    FILE *file;
    char *text = NULL;

    errno = 0;
    file = fopen(path, "rb");
    if (file) {
        text = read_stream(file, length);
        fclose(file);
    }
    if (!text)
        snprintf(error->message, sizeof error->message, "%s",
                 errno ? strerror(errno) : "this file is too large");
    return text;
}
