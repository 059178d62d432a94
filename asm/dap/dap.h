/* dap.h - a debugger for editors, which uses the Debug Adapter Protocol.
 *
 * Messages of the client are read by callbacks; messages to the client are written to a
 * sink, one call for each. The program is controlled by the debugger of
 * asm/debug/debugger.h: it has the same stops, values and times, and also goes
 * backward. docs/editors.md has an example session.
 */
#ifndef ASM_DAP_H
#define ASM_DAP_H

#include "asm/text/assemble.h"

/* A program that a client requests. */
struct dap_program {
    const char *path;
    const char *model;                /* NULL: the default */
    const struct asm_define *defines; /* the last has a NULL name */
    const char *const *search;        /* folders for .include, the last is NULL */
};

struct dap_setup {
    /* Waits for bytes of the client and returns their number; 0: end of the input. */
    size_t (*read)(void *context, char *bytes, size_t most);
    /* Returns whether input is available now. Polled while a program runs. */
    bool (*ready)(void *context);
    /* Opens a program. Writes all errors to the report and returns false if it
     * fails. */
    bool (*open)(void *context, const struct dap_program *program,
                 const struct sink *report, struct object **object, c205_model **model);
    void *context;
    struct sink out;
    const char *program;  /* used if a client names none; NULL: there is none */
    const char *folder;   /* start of relative paths */
    bool warm;            /* start with warm pages even if the client does not request
                           * it */
    uint64_t clocks_most; /* limit for one execution request */
};

/* Serves a whole session, until the client disconnects or its input ends. Returns false
 * and sets the error if the input is not a message. */
bool dap_serve(const struct dap_setup *setup, c205_error *error);

#endif
