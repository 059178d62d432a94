/* wasm.c - exports an engine to the host of a WebAssembly module. The host writes a
 * request to the address that `room` returns, calls `answer`, and releases the reply by
 * `free`.
 */
#include <stdlib.h>

#include "web/engine/engine.h"

#define EXPORTED(name) __attribute__((export_name(name)))

char *host_room(size_t length) EXPORTED("room");
char *host_answer(char *request, size_t length) EXPORTED("answer");
void host_free(char *text) EXPORTED("free");

static struct engine *engine;

/* Returns memory for a request, or NULL if memory is exhausted. */
char *host_room(size_t length)
{
    return malloc(length + 1);
}

/* Returns the reply and frees the request. Returns NULL if memory is exhausted. */
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
