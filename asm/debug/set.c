/* set.c - registers and memory, changed by hand. */
#include <inttypes.h>

#include "asm/debug/parts.h"

static bool set_register(struct debugger *debugger, struct register_of named,
                         const struct value_of *value)
{
    c205 *machine = machine_of(debugger);
    unsigned shift = named.number % 2 * 32;
    c205_word word, kept;

    if (named.number / (named.half ? 2 : 1) == 0)
        return debug_fault(debugger, "register 0 stays what it is");
    if (!debug_word(debugger, value, named.half, &word))
        return false;
    if (!named.half) {
        c205_set_register(machine, named.number, word);
        return true;
    }
    kept = c205_register(machine, named.number / 2u)
           & (shift ? ~(c205_word)UINT32_MAX : UINT32_MAX);
    c205_set_register(machine, named.number / 2u, kept | word >> shift);
    return true;
}

static bool set_word(struct debugger *debugger, uint64_t address,
                     const struct value_of *value)
{
    c205_word word;

    return debug_word(debugger, value, false, &word)
           && (c205_write(machine_of(debugger), address, &word, 1)
               || debug_fault(debugger, "there is no word at %" PRIX64,
                              address));
}

static bool read_new(struct debugger *debugger, struct rest *rest,
                     struct value_of *value)
{
    rest_skip(rest);
    if (*rest->at != '=')
        return debug_fault(debugger, "set REGISTER = VALUE, or "
                                     "[ADDRESS] = VALUE");
    rest->at++;
    return debug_value(debugger, rest, value) && rest_finish(debugger, rest);
}

static bool keep_change(struct debugger *debugger)
{
    c205_error error;

    debugger->halted = false;
    if (debugger->told > c205_history_step(debugger->history))
        debugger->told = c205_history_step(debugger->history);
    stops_sample(debugger);
    return c205_history_changed(debugger->history, &error)
           || debug_fault(debugger, "%s", error.message);
}

/* From here on the run is another one. */
bool verb_set(struct debugger *debugger, struct rest *rest)
{
    struct register_of named;
    struct value_of value;
    uint64_t address;

    if (debugger->halted && debugger->halt.trap == C205_TRAP_NONE)
        return debug_fault(debugger, "the program has ended: go back first");
    rest_skip(rest);
    if (*rest->at == '[') {
        rest->at++;
        if (!debug_address(debugger, rest, &address))
            return false;
        rest_skip(rest);
        if (*rest->at != ']')
            return debug_fault(debugger, "a ] is missing");
        rest->at++;
        return read_new(debugger, rest, &value)
               && set_word(debugger, address, &value)
               && keep_change(debugger);
    }
    if (!debug_register(debugger, rest, &named))
        return debug_fault(debugger, "set REGISTER = VALUE, or "
                                     "[ADDRESS] = VALUE");
    return read_new(debugger, rest, &value)
           && set_register(debugger, named, &value) && keep_change(debugger);
}
