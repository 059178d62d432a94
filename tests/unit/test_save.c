/* test_save.c - saving and restoring machines. Runs of examples and kernels that are
 * interrupted by a save and a restore are compared with uninterrupted runs. Saved
 * machines that are truncated, damaged, forged or of another model are rejected. State
 * that is not saved, or bytes that are accepted without their hash, fail here. */
#include "tests/unit/prior_model.h"
#include "tests/unit/saved_machine.h"

#include "rt/trace/trace.h"
#include "tests/random.h"
#include "tests/unit/scene_reading.h"
#include "vm/hash.h"
#include "vm/machine.h"

enum { WORD_BYTES = 8 };

static uint64_t random_state = RANDOM_SEED;

static c205_stop run_in_pieces(c205 **machine, uint64_t clocks)
{
    c205_stop stop;
    while (stop = c205_run(*machine, c205_clock(*machine) + clocks),
           stop.trap == C205_TRAP_CLOCK_LIMIT)
        *machine = replace(*machine);
    return stop;
}

/* Runs a saved machine to its end, in one run and in slices of `clocks`. */
static void compare_runs(const struct bytes *begin, uint64_t clocks)
{
    SCOPED(c205) *whole = restore(begin, prior_model);
    SCOPED(c205) *broken = restore(begin, prior_model);
    c205_stop one = c205_run(whole, C205_NO_LIMIT);
    c205_stop other = run_in_pieces(&broken, clocks);
    assert_same_stop(&one, &other);
    assert_same(whole, broken);
}

/* ---- Programs ------------------------------------------------------------ */

static void compare_program(const char *path, uint64_t clocks)
{
    SCOPED(c205) *machine = machine_from(path, prior_model);
    SCOPED_VALUE(bytes) begin = save(machine);
    compare_runs(&begin, clocks);
}

TEST(programs)
{
    static const char *const paths[] = {
        "asm/examples/horner.s",       "asm/examples/interval_sum.s",
        "asm/examples/lookup.s",       "asm/examples/saxpy_linked.s",
        "asm/examples/saxpy_scalar.s", "asm/examples/saxpy_vector.s",
        "asm/examples/sieve.s",        "tests/programs/swap.s"
    };
    compare_program("asm/examples/dot.s", 1);
    for (size_t i = 0; i < COUNT(paths); i++)
        compare_program(paths[i], 41);
}

static void compare_frame(const struct scene *scene, enum trace_mode mode)
{
    struct trace_options options = {
        .mode = mode, .width = 8, .height = 6, .queue = 30, .model = prior_model
    };
    SCOPED(trace) *trace = trace_new(scene, &options, &failure);
    SCOPED(c205) *machine = NON_NULL(trace ? trace_machine(trace, 0, &failure) : NULL);
    SCOPED_VALUE(bytes) begin = save(machine);
    compare_runs(&begin, 20011);
}

TEST(kernels)
{
    SCOPED(scene) *scene = read_scene(
        "camera { location <0, 1, -4> look_at 0 }"
        "light_source { <5, 9, -7>, 1 }"
        "plane { y, -1 pigment { rgb .5 } finish { reflection .3 } }"
        "sphere { 0, 1 pigment { rgb <1, .5, .2> } }");
    compare_frame(scene, TRACE_SCALAR);
    compare_frame(scene, TRACE_VECTOR);
}

TEST(access)
{
    uint64_t address = UINT64_C(0xFFFFFFFFFFC0);
    SCOPED(c205) *machine = machine_from("asm/examples/dot.s", prior_model);
    c205_word word = 205;
    uint64_t fault;
    assert_true(c205_map(machine, address, 1, C205_READ_ONLY, &failure));
    assert_true(c205_write(machine, address, &word, 1));
    machine = replace(machine);
    word = 0;
    assert_true(c205_read(machine, address, &word, 1));
    assert_int_equal(word, 205);
    assert_int_equal(memory_check(&machine->memory, address, 64, true, &fault),
                     C205_TRAP_PROTECTED_ADDRESS);
}

/* A page that was never accessed is saved as zeros without being allocated. */
TEST(untouched)
{
    const c205_access access[] = { C205_READ_WRITE, C205_WHEN_TOUCHED };
    struct bytes saved[2];
    for (size_t i = 0; i < 2; i++) {
        SCOPED(c205) *machine = NON_NULL(c205_new(prior_model, &failure));
        assert_true(c205_map(machine, 0, 3 * C205_PAGE_WORDS, access[i], &failure));
        saved[i] = save(machine);
        assert_int_equal(memory_is_untouched(
                             memory_peek(&machine->memory, UINT64_C(1) << 22)),
                         i);
    }
    assert_int_equal(saved[0].count, saved[1].count);
    assert_memory_equal(saved[0].byte, saved[1].byte, saved[0].count);
    bytes_free(&saved[0]);
    bytes_free(&saved[1]);
}

/* A machine without a program can be saved. */
TEST(empty_machine)
{
    SCOPED(c205) *machine = NON_NULL(c205_new(prior_model, &failure));
    machine = replace(machine);
    assert_int_equal(c205_loaded_program(machine), 0);
}

TEST(program_hash)
{
    c205_word words[] = { 1, 2 };
    c205_segment segment = { 0x400000, 2, words };
    c205_region region = { "loop", 0x400000, 0x400040 };
    c205_program program = { 0x400000, 1, &segment, 1, &region, false };
    uint64_t hash = c205_program_hash(&program);
    assert_int_equal(hash, c205_program_hash(&program));
    words[1] = 3;
    assert_int_not_equal(hash, c205_program_hash(&program));
    words[1] = 2;
    region.name = "loops";
    assert_int_not_equal(hash, c205_program_hash(&program));
    region.name = "loop";
    program.entry += 64;
    assert_int_not_equal(hash, c205_program_hash(&program));
}

/* ---- Damaged saved machines ---------------------------------------------- */

static void put_word(struct bytes *bytes, size_t i, uint64_t word)
{
    for (size_t k = 0; k < WORD_BYTES; k++, word <<= 8)
        bytes->byte[i * WORD_BYTES + k] = (unsigned char)(word >> 56);
}

static uint64_t get_word(const struct bytes *bytes, size_t i)
{
    uint64_t word = 0;
    for (size_t k = 0; k < WORD_BYTES; k++)
        word = word << 8 | bytes->byte[i * WORD_BYTES + k];
    return word;
}

/* Replaces the hash at the end of a saved machine by the hash of its words. */
static void seal(struct bytes *bytes)
{
    size_t last = bytes->count / WORD_BYTES - 1;
    uint64_t hash = HASH_BEGIN;
    for (size_t i = 0; i < last; i++)
        hash = hash_word(hash, get_word(bytes, i));
    put_word(bytes, last, hash);
}

static struct bytes in_the_middle(void)
{
    SCOPED(c205) *machine = machine_from("asm/examples/lookup.s", prior_model);
    assert_int_equal(c205_run(machine, 1300).trap, C205_TRAP_CLOCK_LIMIT);
    return save(machine);
}

static void assert_rejected(const void *bytes, size_t count, const c205_model *other,
                            const char *why)
{
    c205_error error = { "" };
    assert_null(c205_restore(bytes, count, other, &error));
    FAIL_IF(!strstr(error.message, why) || !error.message[0], "'%s' does not say '%s'",
            error.message, why);
}

/* Each part is allocated with its exact size, so that reads after its end fail. */
TEST(truncated)
{
    SCOPED_VALUE(bytes) bytes = in_the_middle();
    for (size_t count = 0; count < bytes.count; count++) {
        FREED unsigned char *part = malloc(count ? count : 1);
        assert_non_null(part);
        memcpy(part, bytes.byte, count);
        assert_rejected(part, count, prior_model,
                        count < WORD_BYTES ? "not a saved machine" : "damaged");
    }
}

TEST(flipped)
{
    SCOPED_VALUE(bytes) bytes = in_the_middle();
    for (size_t i = 0; i < bytes.count; i++) {
        unsigned char bit = (unsigned char)(1 << xorshift(&random_state) % 8);
        bytes.byte[i] ^= bit;
        assert_rejected(bytes.byte, bytes.count, prior_model, "");
        bytes.byte[i] ^= bit;
    }
    append(&bytes, "beyond..", WORD_BYTES);
    assert_rejected(bytes.byte, bytes.count, prior_model, "damaged");
}

/* Words of any value with a correct hash give an error or a machine that runs. */
static void try_word(struct bytes *bytes, size_t i, uint64_t word)
{
    uint64_t before = get_word(bytes, i);
    c205_error error = { "" };
    put_word(bytes, i, word);
    seal(bytes);
    SCOPED(c205) *machine = c205_restore(bytes->byte, bytes->count, prior_model,
                                         &error);
    put_word(bytes, i, before);
    if (!machine) {
        assert_true(error.message[0]);
        return;
    }
    machine = replace(machine);
    c205_run(machine, c205_clock(machine) + 4000);
}

TEST(forged)
{
    SCOPED_VALUE(bytes) bytes = in_the_middle();
    bytes.byte = realloc(bytes.byte, bytes.count); /* an allocation of exact size */
    assert_non_null(bytes.byte);
    size_t words = bytes.count / WORD_BYTES;
    for (size_t i = 0; i + 1 < words; i++) {
        uint64_t random = xorshift(&random_state);
        try_word(&bytes, i, words - i); /* a count that exceeds the words that follow by
                                           one */
        try_word(&bytes, i, 0);
        try_word(&bytes, i, UINT64_MAX);
        try_word(&bytes, i, get_word(&bytes, i) + 1);
        try_word(&bytes, i, random >> random % 64);
    }
}

TEST(foreign)
{
    static const char text[] = "c205-object 1\nentry 400000\nend\n";
    SCOPED_VALUE(bytes) bytes = in_the_middle();
    SCOPED(c205_model) *other = NON_NULL(
        c205_model_find("cyber205-4pipe-prior", &failure));
    assert_rejected(bytes.byte, bytes.count, other, "cyber205-2pipe-prior");
    assert_rejected(text, sizeof text, prior_model, "not a saved machine");
    put_word(&bytes, 1, get_word(&bytes, 1) + 1);
    seal(&bytes);
    assert_rejected(bytes.byte, bytes.count, prior_model, "another version");
}

/* A model with other names and sources, but the same constants, is accepted. */
TEST(same_constants)
{
    static const char text[] = "title As before\nlike cyber205-2pipe-prior\n"
                               "latency.load 15.0 clk P\n";
    SCOPED(c205_model) *same = NON_NULL(c205_model_parse("renamed", text, &failure));
    SCOPED_VALUE(bytes) bytes = in_the_middle();
    SCOPED(c205) *machine = NON_NULL(
        c205_restore(bytes.byte, bytes.count, same, &failure));
}

TEST(no_room)
{
    SCOPED(c205) *machine = machine_from("asm/examples/dot.s", prior_model);
    c205_error error;
    for (size_t room = 1; room < 4000; room += 97) {
        SCOPED_VALUE(bytes) bytes = { 0, room, NULL, 0 };
        error.message[0] = '\0';
        assert_false(c205_save(machine, append, &bytes, &error));
        assert_true(error.message[0]);
    }
}
