/* engine.h - a program under the control of a page: one call, JSON in, JSON out.
 */
#ifndef WEB_ENGINE_H
#define WEB_ENGINE_H

#include <stddef.h>
#include <stdint.h>

struct engine;

/* Clocks that one movement takes unless the request says another number. */
#define ENGINE_LIMIT UINT64_C(1000000000)
/* .. and each run of a sweep. */
#define ENGINE_SWEEP_LIMIT UINT64_C(100000000)

/* NULL: no memory. */
struct engine *engine_new(void);
void engine_free(struct engine *engine);

/* The reply to a request of so many bytes, whatever they are: a text to be freed.  NULL:
 * there is no memory even for that. */
char *engine_answer(struct engine *engine, const char *request,
                    size_t length);

#endif
