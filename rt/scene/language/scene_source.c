/* scene_source.c - finds and reads the files of a scene. */
#include "rt/scene/language/scene_source.h"

#include "vm/error.h"
#include "base/other_case.h"
#include "base/sink.h"
#include "base/text_file.h"

#include <errno.h>
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

/* Creates a source from a text and adds it to the list, which then owns the text. */
static struct scene_source *adopt(struct scene_source **list, const char *name,
                                  char *text, size_t length, bool is_text,
                                  c205_error *error)
{
    struct scene_source *source = malloc(sizeof *source);
    char *own_name = copy(name, strlen(name));
    if (!source || !own_name || !text) {
        free(source);
        free(own_name);
        free(text);
        error_set(error, "%s", strerror(ENOMEM));
        return NULL;
    }
    source->next = *list;
    source->name = own_name;
    source->text = text;
    source->length = length;
    source->library = false;
    source->is_text = is_text;
    return *list = source;
}

struct scene_source *source_add(struct scene_source **list, const char *name,
                                const char *text, size_t length, c205_error *error)
{
    char *own;
    if (length > SOURCE_LONGEST) {
        error_set(error, "more than %d bytes", SOURCE_LONGEST);
        return NULL;
    }
    own = copy(text, length);
    if (own && !text_clean(own, &length, error)) {
        free(own);
        return NULL;
    }
    return adopt(list, name, own, length, true, error);
}

/* Reads a file. If the file is missing, returns NULL with errno ENOENT, so that the
 * caller can search for it in the next folder. */
static struct scene_source *load(struct scene_source **list, const char *path,
                                 bool is_text, c205_error *error)
{
    size_t length;
    char *text = (is_text ? text_file_read : file_read)(path, SOURCE_LONGEST, &length,
                                                        error);
    if (text)
        return adopt(list, path, text, length, is_text, error);
    if (errno == ENOTDIR)
        errno = ENOENT;
    return NULL;
}

struct scene_source *source_load(struct scene_source **list, const char *path,
                                 c205_error *error)
{
    return load(list, path, true, error);
}

static struct scene_source *find(struct scene_source *list, const char *name,
                                 bool is_text)
{
    while (list && (list->is_text != is_text || strcmp(list->name, name)))
        list = list->next;
    return list;
}

/* Joins a folder and a name; the caller frees the path. */
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

/* A search for a file. While it continues, found is NULL and is_over is false. */
struct search {
    struct scene_source **list;
    const struct source_request *request;
    bool any_case; /* ignore case */
    struct scene_source *found;
    bool is_over; /* the file was found, or the search failed with the reason in
                   * *error */
    c205_error *error;
};

static void open_path(struct search *search, const char *path)
{
    bool is_text = search->request->is_text;
    search->found = find(*search->list, path, is_text);
    if (!search->found)
        search->found = load(search->list, path, is_text, search->error);
    search->is_over = search->found || errno != ENOENT;
}

/* Reports an error that lists all matches, such as "'a.inc' or 'A.inc'". Each match is
 * printed without the search folder, as an #include would name it. */
static void refuse_several(struct search *search, const struct folder *paths)
{
    struct text_buffer names = { 0 };
    struct sink sink = text_buffer_sink(&names);
    size_t length = strlen(search->request->name);
    for (size_t i = 0; i < paths->count; i++)
        sink_print(&sink, "%s'%s'", i ? " or " : "",
                   paths->names[i] + strlen(paths->names[i]) - length);
    error_set(search->error, "no such file; did you mean %s?",
              names.failed ? "one of several names in other case" : names.text);
    text_buffer_free(&names);
    search->is_over = true;
}

static void open_any_case(struct search *search, const char *path, size_t fixed)
{
    struct folder paths;
    if (!other_case_find(&paths, path, fixed))
        search->is_over = !error_set(search->error, "%s", strerror(ENOMEM));
    else if (paths.count == 1)
        open_path(search, paths.names[0]);
    else if (paths.count > 1)
        refuse_several(search, &paths);
    folder_free(&paths);
}

static void search_folder(struct search *search, const char *folder, size_t length)
{
    char *path;
    if (search->is_over)
        return;
    path = join(folder, length, search->request->name);
    if (!path)
        search->is_over = !error_set(search->error, "%s", strerror(ENOMEM));
    else if (search->any_case)
        open_any_case(search, path, strlen(path) - strlen(search->request->name));
    else
        open_path(search, path);
    free(path);
}

static void search_folders(struct search *search, const char *const *folders)
{
    for (; folders && *folders; folders++)
        search_folder(search, *folders, strlen(*folders));
}

static void search_carried(struct search *search)
{
    const char *name = search->request->name;
    const struct text *text = scene_texts;
    size_t length = 0;
    char *all, *end;
    while (text->name
           && (search->any_case ? strlen(text->name) != strlen(name)
                                      || !other_case_is(text->name, name, strlen(name))
                                : strcmp(text->name, name)))
        text++;
    if (search->is_over || !text->name)
        return;
    for (size_t i = 0; text->lines[i]; i++)
        length += strlen(text->lines[i]);
    all = end = malloc(length + 1);
    for (size_t i = 0; all && text->lines[i]; i++) {
        size_t n = strlen(text->lines[i]);
        memcpy(end, text->lines[i], n + 1);
        end += n;
    }
    search->found = adopt(search->list, text->name, all, length,
                          search->request->is_text, search->error);
    search->is_over = true;
}

/* The include folders of POV-Ray's package. */
static const char *const installed[] = {
    "/usr/local/share/povray-3.7/include",
    "/usr/share/povray-3.7/include",
    NULL,
};

/* Searches the folder of the source that requests the file, then all other places. */
static void search_all(struct search *search)
{
    const struct source_request *request = search->request;
    const char *slash = strrchr(request->from->name, '/');
    size_t folder = slash ? (size_t)(slash - request->from->name) + 1 : 0;
    bool is_absolute = request->name[0] == '/';
    search_folder(search, request->from->name, is_absolute ? 0 : folder);
    if (search->found)
        search->found->library |= request->from->library;
    if (search->is_over)
        return;
    if (!is_absolute) {
        search_folders(search, request->search);
        search_folders(search, installed);
    }
    search_carried(search);
    if (search->found)
        search->found->library = true;
}

struct scene_source *source_include(struct scene_source **list,
                                    const struct source_request *request,
                                    c205_error *error)
{
    struct search search = { .list = list, .request = request, .error = error };
    search_all(&search);
    if (!search.is_over) {
        search.any_case = true;
        search_all(&search);
    }
    if (!search.is_over)
        error_set(error, "no such file");
    return search.found;
}

bool source_is_other(const struct scene_source *source, const char *name)
{
    return strcmp(source->name + strlen(source->name) - strlen(name), name) != 0;
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
