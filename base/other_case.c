/* other_case.c - searches folders for names that differ only in case. */
#include "base/other_case.h"

#include <string.h>

#include "base/sink.h"

enum { PATH_LONGEST = 4096 };

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

bool other_case_is(const char *a, const char *b, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if (lower(a[i]) != lower(b[i]))
            return false;
    return true;
}

static bool search(struct folder *found, const char *folder, const char *rest);

/* Continues the search in an entry of the folder. The entry must match the next part of
 * the path. */
static bool enter(struct folder *found, const char *folder, const char *name,
                  size_t length, const char *rest)
{
    struct text_buffer path = { 0 };
    struct sink sink = text_buffer_sink(&path);
    bool good;
    sink_put(&sink, folder);
    sink.put(sink.context, name, length);
    if (*rest)
        sink_put(&sink, "/");
    if (path.failed)
        good = false;
    else if (*rest)
        good = path.length > PATH_LONGEST || search(found, path.text, rest + 1);
    else
        good = folder_is(path.text) || folder_add(found, path.text);
    text_buffer_free(&path);
    return good;
}

/* Searches a folder. Its path is "" or ends with a '/'. A folder that cannot be read
 * counts as empty. */
static bool search(struct folder *found, const char *folder, const char *rest)
{
    size_t length = strcspn(rest, "/");
    const char *next = rest + length;
    struct folder entries;
    c205_error error;
    bool good = true;
    if (strspn(rest, ".") >= length)
        return enter(found, folder, rest, length, next);
    if (folder_read(&entries, *folder ? folder : ".", &error))
        for (size_t i = 0; good && i < entries.count; i++)
            if (strlen(entries.names[i]) == length
                && other_case_is(entries.names[i], rest, length))
                good = enter(found, folder, entries.names[i], length, next);
    folder_free(&entries);
    return good;
}

bool other_case_find(struct folder *found, const char *path, size_t fixed)
{
    struct text_buffer folder = { 0 };
    struct sink sink = text_buffer_sink(&folder);
    bool good;
    *found = (struct folder){ 0, NULL };
    sink.put(sink.context, path, fixed);
    good = !folder.failed && search(found, folder.text, path + fixed);
    text_buffer_free(&folder);
    return good;
}
