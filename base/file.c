#include "base/file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Up to one byte more than the largest text. */
static char *read_stream(FILE *file, size_t largest, size_t *length)
{
    size_t room = 1 << 14;
    char *text = malloc(room);

    *length = 0;
    while (text) {
        *length += fread(text + *length, 1, room - *length - 1, file);
        if (*length < room - 1 || *length > largest)
            break;
        char *larger = realloc(text, room *= 2);
        if (!larger)
            free(text);
        text = larger;
    }
    if (text)
        text[*length] = '\0';
    return text;
}

/* What errno says of a reading that failed or came to its end. */
static int reason(const FILE *file, const char *text, size_t length,
                  size_t largest)
{
    if (!file || !text || errno)
        return errno ? errno : EIO;
    return length > largest ? EFBIG : 0;
}

char *file_read(const char *path, size_t largest, size_t *length,
                c205_error *error)
{
    FILE *file;
    char *text = NULL;
    int why;

    errno = 0;
    file = fopen(path, "rb");
    if (file)
        text = read_stream(file, largest, length);
    if (file && text && !ferror(file))
        errno = 0;
    why = reason(file, text, file ? *length : 0, largest);
    if (file)
        fclose(file);
    if (!why)
        return text;
    free(text);
    snprintf(error->message, sizeof error->message, "%s",
             why == EFBIG ? "this file is too large" : strerror(why));
    errno = why;
    return NULL;
}
