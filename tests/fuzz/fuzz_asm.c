/* fuzz_asm.c - reads any bytes as a program text and as an object file. The disassembly
 * of the resulting object must assemble (clang -fsanitize=fuzzer). */
#include <string.h>

#include "asm/object/disassemble.h"
#include "asm/object/object_file.h"
#include "asm/text/assemble.h"
#include "asm/view/listing.h"
#include "tests/fuzz/fuzz.h"

bool fuzz_accepted;

static void ignore(void *context UNUSED, const char *text UNUSED, size_t length UNUSED)
{
}

static const struct sink nowhere = { ignore, NULL };

/* The disassembly of an object must assemble. */
static void go_round(const struct object *object)
{
    SCOPED_VALUE(text_buffer) text = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&text);
    SCOPED_VALUE(diagnostics) errors = { 0 };
    disassemble(object, &sink);
    struct object *again = assemble_text("again.s", text.text, NULL, &errors);
    if (!again)
        abort();
    object_free(again);
}

static void try_text(const char *text)
{
    SCOPED_VALUE(diagnostics) errors = { 0 };
    SCOPED(object) *object = assemble_text("fuzz.s", text, NULL, &errors);
    if (!object && errors.count == 0)
        abort();
    diagnostics_put(&errors, &nowhere);
    if (object) {
        fuzz_accepted = true;
        go_round(object);
        listing(object, &nowhere);
        object_write(object, &nowhere);
    }
}

static void try_object(const uint8_t *data, size_t size)
{
    c205_error error;
    SCOPED(object) *object = object_read((const char *)data, size, &error);
    if (object)
        object_write(object, &nowhere);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = calloc(1, size + 1);
    if (!text)
        return 0;
    if (size > 0)
        memcpy(text, data, size);
    try_text(text);
    try_object(data, size);
    free(text);
    return 0;
}
