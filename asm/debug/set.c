/* set.c - changes registers, memory and the program counter by commands of the user. */
#include <inttypes.h>

#include "asm/debug/debug_internal.h"

static bool can_change(struct debugger *debugger)
{
    return !debugger->halted || debugger->halt.trap != C205_TRAP_NONE
           || debug_fault(
               debugger,
               "cannot change a value after the program has ended; go back first");
}

static bool keep_change(struct debugger *debugger)
{
    c205_error error;
    debugger->halted = false;
    if (debugger->reported > step_of(debugger))
        debugger->reported = step_of(debugger);
    breakpoints_sample(debugger);
    return c205_history_changed(debugger->history, &error)
           || debug_fault(debugger, "%s", error.message);
}

/* Returns a word with `width` bits from bit `at` on replaced. The new bits are
 * left-aligned. */
static c205_word with_bits(c205_word word, unsigned at, unsigned width, c205_word bits)
{
    c205_word mask = (~(c205_word)0 << (64 - width)) >> at;
    return (word & ~mask) | (bits >> at & mask);
}

bool debug_set_register(struct debugger *debugger, struct register_of named,
                        const struct value_of *value)
{
    c205 *machine = machine_of(debugger);
    unsigned number = named.half ? named.number / 2u : named.number;
    unsigned at = named.half ? named.number % 2 * 32 : 0;
    c205_word word;
    if (number == 0)
        return debug_fault(debugger, "register 0 cannot be changed");
    if (!can_change(debugger) || !debug_word(debugger, value, named.half, &word))
        return false;
    c205_set_register(machine, number,
                      with_bits(c205_register(machine, number), at,
                                named.half ? 32 : 64, word));
    return keep_change(debugger);
}

/* Writes bits within a word. Reports an error and returns false if no memory is mapped
 * there. */
static bool write_bits(struct debugger *debugger, uint64_t address, unsigned width,
                       c205_word bits)
{
    c205 *machine = machine_of(debugger);
    unsigned at = (unsigned)(address % 64);
    c205_word word;
    if (!c205_read(machine, address - at, &word, 1))
        return debug_fault(debugger, "no memory word at %" PRIX64, address);
    word = with_bits(word, at, width, bits);
    return c205_write(machine, address - at, &word, 1);
}

bool debug_set_bits(struct debugger *debugger, uint64_t address, unsigned width,
                    c205_word bits)
{
    return can_change(debugger) && write_bits(debugger, address, width, bits)
           && keep_change(debugger);
}

bool debug_set_bytes(struct debugger *debugger, uint64_t address,
                     const unsigned char *bytes, size_t count)
{
    bool good = can_change(debugger);
    for (size_t i = 0; good && i < count; i++)
        good = write_bits(debugger, address + 8 * (uint64_t)i, 8,
                          (c205_word)bytes[i] << 56);
    return good && keep_change(debugger);
}

bool debug_jump(struct debugger *debugger, uint64_t address)
{
    const struct asm_line *line = object_line(debugger->setup.object, address);
    if (!can_change(debugger))
        return false;
    if (!line || !line->is_code || line->address != address)
        return debug_fault(debugger, "no line of code begins at %" PRIX64, address);
    c205_set_pc(machine_of(debugger), address);
    return keep_change(debugger);
}

/* ---- The verb -------------------------------------------------------------- */

static bool read_new(struct debugger *debugger, struct text_cursor *cursor,
                     struct value_of *value)
{
    if (!text_cursor_sign(cursor, "="))
        return debug_fault(debugger, "expected REGISTER = VALUE or [ADDRESS] = VALUE");
    return debug_value(debugger, cursor, value) && text_cursor_finish(debugger, cursor);
}

static bool set_memory(struct debugger *debugger, struct text_cursor *cursor)
{
    struct value_of value;
    uint64_t address;
    c205_word word;
    if (!debug_address(debugger, cursor, &address))
        return false;
    if (!text_cursor_sign(cursor, "]"))
        return debug_fault(debugger, "expected ']'");
    if (!read_new(debugger, cursor, &value)
        || !debug_word(debugger, &value, false, &word))
        return false;
    return address % 64 == 0
               ? debug_set_bits(debugger, address, 64, word)
               : debug_fault(debugger, "no memory word at %" PRIX64, address);
}

bool verb_set(struct debugger *debugger, struct text_cursor *cursor)
{
    struct register_of named;
    struct value_of value;
    if (text_cursor_sign(cursor, "["))
        return set_memory(debugger, cursor);
    if (!debug_register(debugger, cursor, &named))
        return debug_fault(debugger, "expected REGISTER = VALUE or [ADDRESS] = VALUE");
    return read_new(debugger, cursor, &value)
           && debug_set_register(debugger, named, &value);
}
