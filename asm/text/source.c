/* source.c - finds the files that .include names, in built-in tables and in folders. */
#include "asm/text/source.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "base/text_file.h"
#include "vm/text.h"

static bool join_lines(struct assembler *assembler, const struct text *text,
                       struct asm_source *source)
{
    struct text_buffer buffer = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&buffer);
    text_put(text, &sink);
    source->name = text->name;
    source->text = buffer.failed
                       ? NULL
                       : arena_text(assembler->arena, buffer.text, buffer.length);
    if (source->text)
        source->end = source->text + buffer.length;
    text_buffer_free(&buffer);
    return source->text != NULL;
}

static const struct text *find_carried(const struct asm_options *options,
                                       const char *name)
{
    const struct text *const *table = options ? options->texts : NULL;
    const struct text *found = NULL;
    for (; table && *table && !found; table++)
        found = text_find(*table, name);
    return found ? found : text_find(library_texts, name);
}

static bool is_missing(int reason)
{
    return reason == ENOENT || reason == ENOTDIR;
}

/* Reads a file. Returns false if it does not exist or cannot be read. The error is set
 * only if the file exists. */
static bool read_source(struct assembler *assembler, const char *path,
                        struct asm_source *source, c205_error *error)
{
    c205_error why;
    size_t length;
    char *text = text_file_read(path, FILE_LARGEST, &length, &why);
    if (!text && !is_missing(errno))
        *error = why;
    if (!text)
        return false;
    source->name = arena_text(assembler->arena, path, strlen(path));
    source->text = arena_text(assembler->arena, text, length);
    free(text);
    if (!source->name || !source->text)
        return false;
    source->end = source->text + length;
    return true;
}

/* Reads the file `name` of a folder. The folder's path is given by its length and need
 * not end with a NUL. */
static bool read_from(struct assembler *assembler, const char *folder, size_t length,
                      const char *name, struct asm_source *source, c205_error *error)
{
    char path[4096];
    const char *slash = length && folder[length - 1] != '/' ? "/" : "";
    int used;
    used = snprintf(path, sizeof path, "%.*s%s%s", (int)length, folder, slash, name);
    return used > 0 && (size_t)used < sizeof path
           && read_source(assembler, path, source, error);
}

bool source_find(struct assembler *assembler, const char *name, const char *from,
                 struct asm_source *source, c205_error *error)
{
    const struct asm_options *options = assembler->options;
    const struct text *carried = find_carried(options, name);
    const char *const *folder = options ? options->search : NULL;
    const char *slash = strrchr(from, '/');
    errno = 0;
    if (carried)
        return join_lines(assembler, carried, source);
    error_set(error, "there is no such file");
    if (options && options->sealed)
        return false;
    if (*name == '/')
        return read_source(assembler, name, source, error);
    if (read_from(assembler, from, slash ? (size_t)(slash - from) + 1 : 0, name, source,
                  error))
        return true;
    for (; folder && *folder && is_missing(errno); folder++)
        if (read_from(assembler, *folder, strlen(*folder), name, source, error))
            return true;
    return false;
}
