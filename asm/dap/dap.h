/* dap.h - a debugger for editors that support the Debug Adapter Protocol.
 *
 * Callbacks read the messages of the client. Messages to the client are written to a
 * sink with one call each. The debugger of asm/debug/debugger.h controls the program,
 * so stops, values and times are the same, and the program can also go backward.
 * docs/editors.md has an example session.
 */
#ifndef ASM_DAP_H
#define ASM_DAP_H

#include "asm/text/assemble.h"

/* A program that a client requests. */
struct dap_program {
    const char *path;
    const char *model;                /* NULL: the default model */
    const struct asm_define *defines; /* the last has a NULL name */
    const char *const *search;        /* folders for .include; the last is NULL */
};

struct dap_setup {
    /* Waits for bytes of the client. Returns their number; 0: end of the input. */
    size_t (*read)(void *context, char *bytes, size_t most);
    /* Returns true if input is available now. Called regularly while a program runs. */
    bool (*ready)(void *context);
    /* Opens a program. On failure, writes all errors to the report and returns
     * false. */
    bool (*open)(void *context, const struct dap_program *program,
                 const struct sink *report, struct object **object, c205_model **model);
    void *context;
    struct sink out;
    const char *program;  /* default program; NULL: none */
    const char *folder;   /* folder of relative paths */
    bool warm;            /* start with warm pages, even if the client does not request
                             them */
    uint64_t clocks_most; /* limit of one execution request, in clocks */
};

/* Serves a session until the client disconnects or its input ends. Returns false and
 * sets the error if the input is not a message. */
bool dap_serve(const struct dap_setup *setup, c205_error *error);

#endif
