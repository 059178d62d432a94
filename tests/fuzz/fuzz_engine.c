/* fuzz_engine.c - reads any bytes as requests of a page, one per line. For any request,
 * the reply must be JSON that reports success, or an error with its reason. */
#include <string.h>

#include "base/json_read.h"
#include "tests/fuzz/fuzz.h"
#include "web/engine/engine.h"

bool fuzz_accepted;

static void ask(struct engine *engine, const char *line, size_t length)
{
    FREED char *text = engine_answer(engine, line, length);
    SCOPED_VALUE(arena) arena = { 0 };
    c205_error error;
    const struct json_value *reply, *ok;
    must(text);
    reply = json_read(&arena, text, strlen(text), &error);
    ok = json_member(reply, "ok");
    must(ok && ok->kind == JSON_TRUTH);
    must(ok->truth || json_member_text(reply, "error"));
    fuzz_accepted = fuzz_accepted || ok->truth;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    enum { MAX = 6 }; /* requests */
    SCOPED(engine) *engine = engine_new();
    const char *line = (const char *)data, *end = line + size;
    must(engine);
    engine_bound(engine, 100000);
    for (int i = 0; i < MAX && line < end; i++) {
        const char *newline = memchr(line, '\n', (size_t)(end - line));
        const char *next = newline ? newline : end;
        ask(engine, line, (size_t)(next - line));
        line = next + 1;
    }
    return 0;
}
