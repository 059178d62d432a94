/* fuzz_save.c - restores a machine from any bytes.
 *
 * The bytes are read unchanged, and a second time with the correct hash in the last
 * word, which random inputs would not contain. A restored machine, saved again, must
 * give the same bytes. After some steps it must save the same bytes as its copy, and
 * its accounts must sum to the clock.
 */
#include <string.h>

#include "tests/fuzz/fuzz.h"
#include "vm/hash.h"

bool fuzz_accepted;

#define CLOCKS 20000
enum { WORD_BYTES = 8, STEPS = 20 };

struct bytes {
    size_t count, room;
    uint8_t *byte;
};

static bool append(void *context, const void *more, size_t count)
{
    struct bytes *bytes = context;
    if (bytes->count + count > bytes->room) {
        bytes->room = 2 * (bytes->count + count);
        bytes->byte = realloc(bytes->byte, bytes->room);
        must(bytes->byte != NULL);
    }
    memcpy(bytes->byte + bytes->count, more, count);
    bytes->count += count;
    return true;
}

static struct bytes save(const c205 *machine)
{
    struct bytes bytes = { 0, 0, NULL };
    c205_error error;
    must(c205_save(machine, append, &bytes, &error));
    return bytes;
}

static c205 *restore(const uint8_t *data, size_t size)
{
    c205_error error = { "" };
    c205 *machine = c205_restore(data, size, fuzz_model(), &error);
    must(machine || error.message[0] != '\0');
    return machine;
}

/* Writes the hash of the other words into the last word. Returns the size in words. */
static size_t seal(uint8_t *byte, size_t size)
{
    size_t words = size / WORD_BYTES;
    uint64_t hash = HASH_BEGIN;
    for (size_t i = 0; i + 1 < words; i++) {
        uint64_t word = 0;
        for (size_t k = 0; k < WORD_BYTES; k++)
            word = word << 8 | byte[i * WORD_BYTES + k];
        hash = hash_word(hash, word);
    }
    for (size_t k = 0; words > 0 && k < WORD_BYTES; k++)
        byte[words * WORD_BYTES - 1 - k] = (uint8_t)(hash >> 8 * k);
    return words * WORD_BYTES;
}

/* ---- Checks ------------------------------------------------------------- */

static void check_same(const c205 *a, const c205 *b)
{
    struct bytes left = save(a), right = save(b);
    must(left.count == right.count && memcmp(left.byte, right.byte, left.count) == 0);
    free(left.byte);
    free(right.byte);
}

static c205_stop go_on(c205 *machine)
{
    c205_stop stop = { .trap = C205_TRAP_NONE };
    int steps = 0;
    while (steps < STEPS && c205_step(machine, &stop))
        steps++;
    if (steps == STEPS)
        stop = c205_run(machine, c205_clock(machine) + CLOCKS);
    check_accounts(machine);
    return stop;
}

/* Compares a machine with a saved and restored copy, before and after some steps. */
static void check_twins(c205 *machine)
{
    struct bytes bytes = save(machine);
    SCOPED(c205) *twin = restore(bytes.byte, bytes.count);
    c205_stop one, other;
    must(twin != NULL);
    check_accounts(machine);
    check_same(machine, twin);
    one = go_on(machine);
    other = go_on(twin);
    must(one.trap == other.trap && one.pc == other.pc);
    check_same(machine, twin);
    free(bytes.byte);
}

static void try_bytes(const uint8_t *data, size_t size)
{
    SCOPED(c205) *machine = restore(data, size);
    if (machine) {
        fuzz_accepted = true;
        check_twins(machine);
    }
}

/* The copy has an allocation of exact size, so that reads after its end fail. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    FREED uint8_t *sealed = malloc(size ? size : 1);
    try_bytes(data, size);
    must(sealed != NULL);
    if (size > 0)
        memcpy(sealed, data, size);
    try_bytes(sealed, seal(sealed, size));
    return 0;
}
