/* saved_machine.c - saves a machine as bytes, restores it, and compares machines. */
#include "saved_machine.h"

void bytes_free(struct bytes *bytes)
{
    free(bytes->byte);
}

bool append(void *context, const void *more, size_t count)
{
    struct bytes *bytes = context;
    if (bytes->count + count > bytes->reserved) {
        bytes->reserved = 2 * bytes->count + count;
        bytes->byte = NON_NULL(realloc(bytes->byte, bytes->reserved));
    }
    if (bytes->room && bytes->count + count > bytes->room)
        return false;
    memcpy(bytes->byte + bytes->count, more, count);
    bytes->count += count;
    return true;
}

struct bytes save(const c205 *machine)
{
    struct bytes bytes = { 0, 0, NULL, 0 };
    REQUIRE(c205_save(machine, append, &bytes, &failure));
    return bytes;
}

c205 *restore(const struct bytes *bytes, const c205_model *model)
{
    return NON_NULL(c205_restore(bytes->byte, bytes->count, model, &failure));
}

static void assert_saved_as(const c205 *machine, const struct bytes *expected)
{
    SCOPED_VALUE(bytes) bytes = save(machine);
    assert_int_equal(bytes.count, expected->count);
    assert_memory_equal(bytes.byte, expected->byte, bytes.count);
}

void assert_same(const c205 *a, const c205 *b)
{
    SCOPED_VALUE(bytes) bytes = save(a);
    assert_saved_as(b, &bytes);
}

c205 *replace(c205 *machine)
{
    SCOPED_VALUE(bytes) bytes = save(machine);
    c205 *other = restore(&bytes, c205_machine_model(machine));
    assert_saved_as(other, &bytes);
    assert_int_equal(c205_clock(machine), c205_clock(other));
    assert_int_equal(c205_loaded_program(machine), c205_loaded_program(other));
    c205_free(machine);
    return other;
}

void assert_same_stop(const c205_stop *a, const c205_stop *b)
{
    assert_int_equal(a->trap, b->trap);
    assert_int_equal(a->pc, b->pc);
    assert_int_equal(a->address, b->address);
    assert_int_equal(a->status, b->status);
}

c205 *machine_with(const c205_program *program, const c205_model *model)
{
    c205 *machine = c205_new(model, &failure);
    REQUIRE(machine && c205_load(machine, program, &failure));
    return machine;
}

c205 *machine_from(const char *path, const c205_model *model)
{
    SCOPED(object) *object = good_file(path);
    return machine_with(&object->program, model);
}

c205_model *model_of(const struct random_program *program)
{
    return NON_NULL(
        c205_model_parse("random", random_models[program->model], &failure));
}

c205 *machine_of(const struct random_program *program, const c205_model *model)
{
    c205 *machine = NON_NULL(c205_new(model, &failure));
    assert_true(random_load(machine, program, &failure));
    return machine;
}
