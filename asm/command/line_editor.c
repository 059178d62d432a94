/* line_editor.c - reads lines from a terminal, with libedit if it is available. */
#include "asm/command/line_editor.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/interrupt.h"

#ifndef __wasi__
#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <sys/select.h>
#endif

/* WASI has neither dynamic libraries nor signals. */
#ifdef __wasi__

static bool wait_for_input(void)
{
    return true;
}

static void open_library(struct typed_lines *lines, const char *(*name)(size_t i))
{
    (void)lines, (void)name;
}

#else

/* Waits for input. Returns false if a signal has arrived since interrupt_clear. Signals
 * are blocked between the check and pselect, which unblocks them atomically, so no
 * signal is missed. */
static bool wait_for_input(void)
{
    sigset_t all, before;
    fd_set input;
    bool ready = false;
    sigfillset(&all);
    while (!ready && !interrupt_pending()) {
        FD_ZERO(&input);
        FD_SET(STDIN_FILENO, &input);
        sigprocmask(SIG_BLOCK, &all, &before);
        if (!interrupt_pending())
            ready = pselect(STDIN_FILENO + 1, &input, NULL, NULL, NULL, &before) >= 0
                    || errno != EINTR;
        sigprocmask(SIG_SETMASK, &before, NULL);
    }
    return !interrupt_pending();
}

/* The types of readline's callbacks, which libedit also uses. */
typedef char *generator(const char *text, int state);
typedef int getter(FILE *file);

/* Reads a byte for libedit. The function of libedit cannot be used, because it
 * continues to read after the first signal. */
static int read_byte(FILE *file)
{
    unsigned char byte;
    (void)file;
    return wait_for_input() && read(STDIN_FILENO, &byte, 1) == 1 ? byte : EOF;
}

static const char *(*names)(size_t i); /* global, because the callbacks of libedit have
                                          no context */

/* Returns a copy of the name number `state` that begins with the text, or NULL. */
static char *complete(const char *text, int state)
{
    size_t length = strlen(text);
    for (size_t i = 0; names(i); i++)
        if (strncmp(names(i), text, length) == 0 && state-- == 0)
            return strdup(names(i));
    return NULL;
}

static void open_library(struct typed_lines *lines, const char *(*name)(size_t i))
{
    void *library = dlopen("libedit.so.2", RTLD_NOW);
    generator **entry;
    getter **get;
    if (!library)
        return;
    names = name;
    *(void **)&lines->read = dlsym(library, "readline");
    *(void **)&lines->keep = dlsym(library, "add_history");
    entry = (generator **)dlsym(library, "rl_completion_entry_function");
    get = (getter **)dlsym(library, "rl_getc_function");
    if (!lines->read || !lines->keep || !get) {
        lines->read = NULL;
        return;
    }
    *get = read_byte;
    if (entry)
        *entry = complete;
}

#endif

struct typed_lines typed_lines_of(FILE *file, const char *(*name)(size_t i))
{
    struct typed_lines lines = { .stream.file = file };
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

static const char *read_plain(struct typed_lines *lines, const char *prompt)
{
    if (lines->terminal) {
        fputs(prompt, stdout);
        fflush(stdout);
    }
    if (lines->terminal && !wait_for_input())
        return NULL;
    return text_stream_next(&lines->stream) ? lines->stream.line : NULL;
}

/* Returns true if Ctrl-C abandoned a line. The next line is then read. */
static bool is_dropped(const struct typed_lines *lines)
{
    return lines->terminal && interrupt_pending() && !interrupt_ends();
}

const char *typed_lines_next(struct typed_lines *lines, const char *prompt)
{
    for (;;) {
        const char *line;
        fflush(stdout);
        line = lines->read ? read_edited(lines, prompt) : read_plain(lines, prompt);
        if (line || !is_dropped(lines))
            return line;
        interrupt_clear();
        putchar('\n');
    }
}

void typed_lines_free(struct typed_lines *lines)
{
    free(lines->text);
    free(lines->stream.line);
}
