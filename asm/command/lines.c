#include "asm/command/lines.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifndef __wasi__
#include <dlfcn.h>
#endif

/* WebAssembly's system interface opens no libraries. */
#ifdef __wasi__

static void open_library(struct typed_lines *lines,
                         const char *(*name)(size_t i))
{
    (void)lines, (void)name;
}

#else

/* What libedit has of readline's interface. */
typedef char *generator(const char *text, int state);

static const char *(*names)(size_t i); /* libedit knows no context */

/* The state-th name that begins so, its own copy. */
static char *complete(const char *text, int state)
{
    size_t length = strlen(text);

    for (size_t i = 0; names(i); i++)
        if (strncmp(names(i), text, length) == 0 && state-- == 0)
            return strdup(names(i));
    return NULL;
}

static void open_library(struct typed_lines *lines,
                         const char *(*name)(size_t i))
{
    void *library = dlopen("libedit.so.2", RTLD_NOW);
    generator **entry;

    if (!library)
        return;
    names = name;
    *(void **)&lines->read = dlsym(library, "readline");
    *(void **)&lines->keep = dlsym(library, "add_history");
    entry = (generator **)dlsym(library, "rl_completion_entry_function");
    if (!lines->read || !lines->keep)
        lines->read = NULL;
    else if (entry)
        *entry = complete;
}

#endif

struct typed_lines typed_lines_of(FILE *file, const char *(*name)(size_t i))
{
    struct typed_lines lines = { .file = file };

    lines.terminal = file == stdin && isatty(STDIN_FILENO) == 1
                     && isatty(STDOUT_FILENO) == 1;
    if (lines.terminal)
        open_library(&lines, name);
    return lines;
}

static const char *read_edited(struct typed_lines *lines, const char *prompt)
{
    free(lines->text);
    lines->text = lines->read(prompt);
    if (lines->text && *lines->text)
        lines->keep(lines->text);
    return lines->text;
}

const char *typed_lines_next(struct typed_lines *lines, const char *prompt)
{
    ssize_t length;

    fflush(stdout);
    if (lines->read)
        return read_edited(lines, prompt);
    if (lines->terminal) {
        fputs(prompt, stdout);
        fflush(stdout);
    }
    length = getline(&lines->text, &lines->capacity, lines->file);
    lines->failed = length < 0 && ferror(lines->file);
    if (length < 0)
        return NULL;
    if (length > 0 && lines->text[length - 1] == '\n')
        lines->text[length - 1] = '\0';
    return lines->text;
}

void typed_lines_free(struct typed_lines *lines)
{
    free(lines->text);
}
