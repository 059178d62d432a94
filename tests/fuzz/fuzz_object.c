/* fuzz_object.c - reads any bytes as an object file, and runs valid objects. */
#include "asm/object/object_file.h"
#include "tests/fuzz/fuzz.h"

bool fuzz_accepted;

#define CLOCKS 10000
#define MAX_WORDS ((size_t)1 << 20) /* larger objects are only slower */

static size_t words_of(const c205_program *program)
{
    size_t words = 0;
    for (size_t i = 0; i < program->segment_count; i++)
        words += program->segments[i].length;
    return words;
}

static void load_and_run(const c205_program *program)
{
    c205_error error;
    SCOPED(c205) *machine = c205_new(fuzz_model(), &error);
    if (machine && c205_load(machine, program, &error)) {
        c205_stop stop = c205_run(machine, CLOCKS);
        c205_describe_stop(machine, &stop, &error);
        fuzz_accepted = true;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    c205_error error;
    SCOPED(object) *object = object_read((const char *)data, size, &error);
    if (object && words_of(&object->program) <= MAX_WORDS)
        load_and_run(&object->program);
    return 0;
}
