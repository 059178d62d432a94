/* stop_text.c - names traps and rules, and writes the reason of a stop as text. */
#include "vm/machine.h"
#include "vm/error.h"

#include <stdio.h>

/* ---- Names and rules ---------------------------------------------------- */

static const char *const trap_names[C205_TRAPS] = {
    [C205_TRAP_NONE] = "none",
    [C205_TRAP_UNDEFINED_INSTRUCTION] = "undefined-instruction",
    [C205_TRAP_UNMAPPED_ADDRESS] = "unmapped-address",
    [C205_TRAP_PROTECTED_ADDRESS] = "protected-address",
    [C205_TRAP_BAD_DESCRIPTOR] = "bad-descriptor",
    [C205_TRAP_MISALIGNED_OPERAND] = "misaligned-operand",
    [C205_TRAP_BAD_LINK] = "bad-link",
    [C205_TRAP_BAD_REQUEST] = "bad-request",
    [C205_TRAP_CLOCK_LIMIT] = "clock-limit",
    [C205_TRAP_NO_MEMORY] = "no-memory",
    [C205_TRAP_PAUSED] = "paused",
    [C205_TRAP_BREAKPOINT] = "breakpoint",
    [C205_TRAP_WATCHPOINT] = "watchpoint"
};

const char *c205_trap_name(c205_trap trap)
{
    return trap_names[trap];
}

static const char *const rule_texts[RULES] = {
#define RULE(name, trap, text) [RULE_##name] = text,
#include "vm/rules.def"
#undef RULE
};

const char *machine_broken_rule(const struct c205 *machine, c205_trap trap)
{
    unsigned rule = machine->rule;
    if (rule_trap(machine->rule) != trap)
        rule = RULE_NONE + 1;
    while (rule < RULES && rule_trap((enum rule)rule) != trap)
        rule++;
    return rule < RULES ? rule_texts[rule] : NULL;
}

/* ---- The text of a stop ------------------------------------------------- */

/* Returns true if the text of a stop contains its address. A trap of a memory access
 * has an address even if it is 0, the content of an uninitialised descriptor. */
static bool has_address(const c205_stop *stop)
{
    return stop->address || stop->trap == C205_TRAP_UNMAPPED_ADDRESS
           || stop->trap == C205_TRAP_PROTECTED_ADDRESS;
}

/* Writes a text such as ": 56000000" with the half word that could not be decoded. */
static void describe_code(const c205 *machine, uint64_t pc, char text[20])
{
    c205_word word;
    uint64_t skip = pc % WORD_BITS;
    text[0] = '\0';
    if (c205_read(machine, pc - skip, &word, 1))
        snprintf(text, 20, ": %08llX",
                 (unsigned long long)(word << skip >> WORD_BITS / 2));
}

/* Returns true if the host could not allocate a page on first use. */
static bool lacks_page(const c205 *machine, const c205_stop *stop)
{
    return stop->trap == C205_TRAP_UNMAPPED_ADDRESS && stop->address <= ADDRESS_MASK
           && memory_is_untouched(memory_peek(&machine->memory, stop->address));
}

void c205_describe_stop(const c205 *machine, const c205_stop *stop, c205_error *text)
{
    unsigned long long pc = stop->pc, address = stop->address;
    char code[20] = "", operand[32] = "";
    const char *rule = lacks_page(machine, stop) ? MEMORY_NO_PAGE : stop->rule;
    if (stop->trap == C205_TRAP_NONE) {
        error_set(text, "ended at %llX with status %lld", pc, (long long)stop->status);
        return;
    }
    if (stop->insn)
        snprintf(code, sizeof code, ": %s", stop->insn->mnemonic);
    else if (stop->trap == C205_TRAP_UNDEFINED_INSTRUCTION)
        describe_code(machine, stop->pc, code);
    if (has_address(stop))
        snprintf(operand, sizeof operand, ": address %llX", address);
    error_set(text, "trap %s at %llX%s%s%s%s", c205_trap_name(stop->trap), pc, code,
              operand, rule ? ": " : "", rule ? rule : "");
}
