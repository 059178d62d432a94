/* wasm.c - an engine for the host of a WebAssembly module, which has one: bytes of a
 * request are written where room says, and the reply is a text that is given
 * back.
 */
#include <stdlib.h>

#include "web/engine/engine.h"

#define EXPORTED(name) __attribute__((export_name(name)))

char *host_room(size_t length) EXPORTED("room");
char *host_answer(char *request, size_t length) EXPORTED("answer");
void host_free(char *text) EXPORTED("free");

static struct engine *engine;

/* NULL: no memory. */
char *host_room(size_t length)
{
    return malloc(length + 1);
}

/* The request is freed; NULL: no memory. */
char *host_answer(char *request, size_t length)
{
    char *reply;

    if (!engine)
        engine = engine_new();
    reply = engine ? engine_answer(engine, request, length) : NULL;
    free(request);
    return reply;
}

void host_free(char *text)
{
    free(text);
}
