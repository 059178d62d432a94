/* source.c - finding and reading texts. */
#include "rt/scene/language/source.h"

#include "base/file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char *copy(const char *text, size_t length)
{
    char *own = malloc(length + 1);

    if (own) {
        memcpy(own, text, length);
        own[length] = '\0';
    }
    return own;
}

/* Takes the text over. */
static struct scene_source *adopt(struct scene_source **list,
                                  const char *name, char *text, size_t length)
{
    struct scene_source *source = malloc(sizeof *source);
    char *own_name = copy(name, strlen(name));

    if (!source || !own_name || !text) {
        free(source);
        free(own_name);
        free(text);
        errno = ENOMEM;
        return NULL;
    }
    source->next = *list;
    source->name = own_name;
    source->text = text;
    source->length = length;
    source->library = false;
    return *list = source;
}

struct scene_source *source_add(struct scene_source **list, const char *name,
                                const char *text, size_t length)
{
    if (length > SOURCE_LONGEST) {
        errno = EFBIG;
        return NULL;
    }
    return adopt(list, name, copy(text, length), length);
}

struct scene_source *source_load(struct scene_source **list, const char *path)
{
    c205_error error;
    size_t length;
    char *text = file_read(path, SOURCE_LONGEST, &length, &error);

    return text ? adopt(list, path, text, length) : NULL;
}

static struct scene_source *find(struct scene_source *list, const char *name)
{
    while (list && strcmp(list->name, name))
        list = list->next;
    return list;
}

/* A folder and a name as a path; the caller frees it. */
static char *join(const char *folder, size_t length, const char *name)
{
    size_t rest = strlen(name);
    char *path = malloc(length + rest + 2);

    if (!path)
        return NULL;
    memcpy(path, folder, length);
    if (length && folder[length - 1] != '/')
        path[length++] = '/';
    memcpy(path + length, name, rest + 1);
    return path;
}

static struct scene_source *include_from(struct scene_source **list,
                                         const char *folder, size_t length,
                                         const char *name)
{
    char *path = join(folder, length, name);
    struct scene_source *source;

    if (!path)
        return NULL;
    source = find(*list, path);
    if (!source)
        source = source_load(list, path);
    free(path);
    return source;
}

static struct scene_source *carried(struct scene_source **list,
                                    const char *name)
{
    const struct text *text = scene_texts;
    size_t length = 0;
    char *all, *end;

    while (text->name && strcmp(text->name, name))
        text++;
    if (!text->name) {
        errno = ENOENT;
        return NULL;
    }
    for (size_t i = 0; text->lines[i]; i++)
        length += strlen(text->lines[i]);
    all = end = malloc(length + 1);
    for (size_t i = 0; all && text->lines[i]; i++) {
        size_t n = strlen(text->lines[i]);
        memcpy(end, text->lines[i], n + 1);
        end += n;
    }
    return adopt(list, name, all, length);
}

/* Where POV-Ray's package has its files. */
static const char *const installed[] = {
    "/usr/local/share/povray-3.7/include",
    "/usr/share/povray-3.7/include",
    NULL,
};

static struct scene_source *include_from_one(struct scene_source **list,
                                             const char *const *folders,
                                             const char *name)
{
    struct scene_source *source = NULL;

    for (; !source && errno != ETXTBSY && folders && *folders; folders++)
        source = include_from(list, *folders, strlen(*folders), name);
    return source;
}

struct scene_source *source_include(struct scene_source **list,
                                    const char *name,
                                    const struct scene_source *from,
                                    const char *const *search)
{
    const char *slash = strrchr(from->name, '/');
    size_t folder = slash ? (size_t)(slash - from->name) + 1 : 0;
    struct scene_source *source;

    if (name[0] == '/')
        folder = 0;
    source = include_from(list, from->name, folder, name);
    if (source) {
        source->library |= from->library;
        return source;
    }
    if (name[0] != '/')
        source = include_from_one(list, search, name);
    if (!source && name[0] != '/')
        source = include_from_one(list, installed, name);
    if (!source && errno != ETXTBSY) /* an output of the command */
        source = carried(list, name);
    if (source)
        source->library = true;
    return source;
}

void sources_free(struct scene_source *list)
{
    while (list) {
        struct scene_source *next = list->next;
        free(list->name);
        free(list->text);
        free(list);
        list = next;
    }
}
