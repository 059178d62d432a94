/* dap.h - a debugger for editors, by the Debug Adapter Protocol.
 *
 * What the client says is asked of callbacks, what it is to hear goes to a sink, a
 * message at a time.  The program is under the same control as by asm/debug/debugger.h:
 * forward and back, the same stops, values and times.  docs/editors.md has an exchange.
 */
#ifndef ASM_DAP_H
#define ASM_DAP_H

#include "asm/assemble.h"

/* What a client asks to be opened. */
struct dap_program {
    const char *path;
    const char *model;                /* NULL: the usual */
    const struct asm_define *defines; /* ends with a NULL name */
    const char *const *search;        /* folders for .include, ends with NULL */
};

struct dap_setup {
    /* The next bytes of the client, which are waited for; 0: there are no more. */
    size_t (*read)(void *context, char *bytes, size_t most);
    /* Whether there is something to read now.  Asked while a program runs. */
    bool (*ready)(void *context);
    /* False after all that is wrong has gone to the report. */
    bool (*open)(void *context, const struct dap_program *program,
                 const struct sink *report, struct object **object, c205_model **model);
    void *context;
    struct sink out;
    const char *program;  /* of a client that names none; or NULL */
    const char *folder;   /* in which paths begin */
    bool warm;            /* as if the client had asked for that */
    uint64_t clocks_most; /* that one motion takes */
};

/* A whole session, to the client's goodbye or the end of what it says.  False: that
 * is no message; the error tells why. */
bool dap_serve(const struct dap_setup *setup, c205_error *error);

#endif
