/* fuzz_machine.c - runs any words as a program.
 *
 * For any words, the accounts must sum to the clock. A program in one run, in slices
 * and in single steps must end in the same state, and an instruction that traps must
 * not have changed registers or memory.
 *
 * If there is a row of the instruction table with the number of a word's first byte,
 * the byte selects that row; otherwise it is the opcode. Most programs therefore
 * continue after their first instruction, and undefined instructions still occur.
 */
#include <string.h>

#include "tests/fuzz/fuzz.h"

bool fuzz_accepted;

#define CODE UINT64_C(0x400000)   /* page 1 */
#define DATA UINT64_C(0x10000000) /* page 64; no other page is near */
#define CLOCKS 100000
/* The data flag of the job interval timer, which may expire during a trap. */
#define TIMER (UINT64_C(1) << 27)
#define SLICE 37
#define COUNT(array) (sizeof(array) / sizeof *(array))
enum { WORD_BITS = 64, CODE_WORDS = 256, DATA_WORDS = 1024 };

/* All state that a program can change, except code after its first CODE_WORDS words. */
struct state {
    c205_word registers[C205_REGISTERS];
    c205_word flags;
    c205_word code[CODE_WORDS];
    c205_word data[DATA_WORDS];
    uint64_t pc;
};

/* ---- Programs from bytes ------------------------------------------------ */

static c205_word word_of(const uint8_t *bytes)
{
    c205_word word = 0;
    for (int i = 0; i < 8; i++)
        word = word << 8 | bytes[i];
    if (bytes[0] < c205_insn_count) {
        const c205_insn *insn = &c205_insns[bytes[0]];
        c205_fields fields = c205_decode(insn, word);
        fields.f = insn->opcode;
        fields.g &= (uint8_t)~insn->subop_mask;
        fields.g |= insn->subop;
        word = c205_encode(insn, &fields)
               | (c205_format_halves(insn->format) == 1 ? word & UINT32_MAX : 0);
    }
    return word;
}

static void load(c205 *machine, const c205_word *code)
{
    static const c205_word some[DATA_WORDS] = { C205_ONE, C205_MACHINE_ZERO,
                                                C205_INDEFINITE, 1, UINT64_MAX };
    const c205_segment segments[] = { { CODE, CODE_WORDS, code },
                                      { DATA, DATA_WORDS, some } };
    const c205_region region = { "half", CODE, CODE + CODE_WORDS * WORD_BITS / 2 };
    const c205_program program = { CODE, 2, segments, 1, &region, false };
    c205_error error;
    must(c205_load(machine, &program, &error));
}

/* The registers are descriptors, numbers, indices and branch targets, in turn. */
static void fill_registers(c205 *machine)
{
    for (unsigned i = 1; i < C205_REGISTERS; i++) {
        const c205_word kinds[] = { (c205_word)(i % 32) << 48 | (DATA + i * WORD_BITS),
                                    c205_from_double(i - 100.5), i % 16,
                                    CODE + i * WORD_BITS / 2,
                                    (c205_word)(i % 8) << 48 | (CODE + i * WORD_BITS) };
        c205_set_register(machine, i, kinds[i % COUNT(kinds)]);
    }
}

/* ---- Checks ------------------------------------------------------------- */

static void take_state(const c205 *machine, struct state *state)
{
    memset(state, 0, sizeof *state);
    for (unsigned i = 0; i < C205_REGISTERS; i++)
        state->registers[i] = c205_register(machine, i);
    state->flags = c205_data_flags(machine);
    state->pc = c205_pc(machine);
    must(c205_read(machine, CODE, state->code, CODE_WORDS));
    must(c205_read(machine, DATA, state->data, DATA_WORDS));
}

static void check_same(const struct state *a, const struct state *b)
{
    must(memcmp(a, b, sizeof *a) == 0);
}

static void begin(c205 *machine, const c205_word *code)
{
    load(machine, code);
    fill_registers(machine);
}

/* Runs the machine in slices, with the same result as c205_run(machine, CLOCKS). */
static c205_stop run_slices(c205 *machine)
{
    c205_stop stop;
    uint64_t limit = 0;
    do {
        limit = CLOCKS - limit < SLICE ? CLOCKS : limit + SLICE;
        stop = c205_run(machine, limit);
        check_accounts(machine);
    } while (stop.trap == C205_TRAP_CLOCK_LIMIT && limit < CLOCKS);
    return stop;
}

/* Steps to the end of a run. Returns the number of steps. */
static size_t walk(c205 *machine)
{
    c205_stop stop;
    size_t steps = 0;
    while (c205_step(machine, &stop))
        steps++;
    return steps;
}

static void check_trap(c205 *machine, const c205_word *code, size_t steps,
                       const c205_stop *expected)
{
    static struct state before, after;
    c205_stop stop;
    begin(machine, code);
    while (steps-- > 0)
        must(c205_step(machine, &stop));
    take_state(machine, &before);
    must(!c205_step(machine, &stop));
    must(stop.trap == expected->trap && stop.pc == expected->pc);
    take_state(machine, &after);
    after.flags &= before.flags | ~TIMER;
    check_same(&before, &after);
}

/* Fails unless the machine is in the final state of the run. */
static void check_end(const c205 *machine, const struct state *ran, uint64_t clock)
{
    static struct state state;
    check_accounts(machine);
    take_state(machine, &state);
    check_same(ran, &state);
    must(clock == c205_clock(machine));
}

static void run_and_walk(c205 *machine, const c205_word *code)
{
    static struct state ran;
    c205_error text;
    begin(machine, code);
    c205_stop end = c205_run(machine, CLOCKS);
    c205_describe_stop(machine, &end, &text);
    take_state(machine, &ran);
    uint64_t clock = c205_clock(machine);
    check_end(machine, &ran, clock);

    begin(machine, code);
    must(run_slices(machine).trap == end.trap);
    check_end(machine, &ran, clock);
    if (end.trap == C205_TRAP_CLOCK_LIMIT) {
        fuzz_accepted = true;
        return;
    }

    begin(machine, code);
    size_t steps = walk(machine);
    fuzz_accepted = fuzz_accepted || steps > 0;
    check_end(machine, &ran, clock);
    if (end.trap != C205_TRAP_NONE)
        check_trap(machine, code, steps, &end);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    c205_word code[CODE_WORDS] = { 0 };
    c205_error error;
    SCOPED(c205) *machine = c205_new(fuzz_model(), &error);
    for (size_t i = 0; i < CODE_WORDS && 8 * i + 8 <= size; i++)
        code[i] = word_of(data + 8 * i);
    if (machine)
        run_and_walk(machine, code);
    return 0;
}
