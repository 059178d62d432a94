/* test_blocks.c - blocks of scalar instructions. A run from block to block is compared
 * with a run step by step, in state, clock and accounts. The programs have loops with
 * calls, branches, loads, SWAP, vectors and code that changes. Some runs are stopped,
 * or have a listener. A schedule that is used for another state of the clock, or stale
 * code, fails here. */
#include "tests/unit/saved_machine.h"
#include "tests/unit/prior_model.h"

#include "vm/machine.h"
#include "vm/time/clock_parts.h"

/* Ends a loop and the program. `to` contains the address of the loop's start. */
#define LOOP_END \
    "        DBNZ    turns, [to]\n" \
    "        EXIT\n"

static const char arithmetic[] = /* solves 40 quadratic equations, with calls */
    "        .regs   r10, x, y, one, four, turns, list, to, link, i\n"
    "        .data\n"
    "values: .word   1.0, -3.0, 0.25, 7.5, 2.0, 2.0, -1.0, 3.0\n"
    "        .code\n"
    "        .kernel main\n"
    "        load_constant four, 4.0\n"
    "        EX      list, values\n"
    "        ES      one, 1\n"
    "        ES      turns, 40\n"
    "again:  ES      i, 7\n"
    "        AND     turns, i, i\n"
    "        LOD     [list, i], x\n"
    "        EX      to, root\n"
    "        BSAVE   link, [to]\n"
    "        STO     [list, i], y\n"
    "        EX      to, again\n" LOOP_END "        .endkernel\n"
    "        .kernel root\n"
    "root:   MPYS    x, x, y\n"
    "        SUBN    y, four, y\n"
    "        CFPLT   y, r0, none\n"
    "        SQRT    y, y\n"
    "        ADDN    y, x, y\n"
    "        DIVS    y, four, y\n"
    "none:   BIM     0, link\n"
    "        .endkernel\n";

/* ---- Runs to the end ----------------------------------------------------- */

static c205 *load(const char *text)
{
    SCOPED(object) *object = good(formatted("        .include \"core.s\"\n%s", text));
    return machine_with(&object->program, prior_model);
}

static c205_stop step_to_end(c205 *machine)
{
    c205_stop stop;
    while (c205_step(machine, &stop))
        continue;
    return stop;
}

/* A machine that ran blocks, a machine that ran single steps, and their stop. */
struct both {
    c205 *whole, *stepped;
    c205_stop stop;
};

static void both_free(struct both *both)
{
    c205_free(both->whole);
    c205_free(both->stepped);
}

/* Runs a program to its end in both ways, and compares the machines. */
static struct both compare(const char *text)
{
    struct both both = { .whole = load(text), .stepped = load(text) };
    both.stop = c205_run(both.whole, C205_NO_LIMIT);
    c205_stop stop = step_to_end(both.stepped);
    assert_same_stop(&both.stop, &stop);
    assert_same(both.whole, both.stepped);
    return both;
}

static uint64_t schedule_count(const c205 *machine)
{
    uint64_t count = 0;
    for (size_t i = 0; i < machine->blocks->count; i++)
        count += machine->blocks->block[i].schedule_count;
    return count;
}

TEST(whole)
{
    SCOPED_VALUE(both) both = compare(arithmetic);
    assert_int_equal(both.stop.trap, C205_TRAP_NONE);
    assert_true(schedule_count(both.whole) > 5);
    assert_int_equal(schedule_count(both.stepped), 0);
}

/* ---- Limits, listeners --------------------------------------------------- */

/* At every clock limit, the run stops where single steps would stop. */
static void check_limits(const char *text)
{
    SCOPED(c205) *whole = load(text);
    c205_run(whole, C205_NO_LIMIT);
    uint64_t clocks = c205_clock(whole);
    for (uint64_t limit = 1; limit < clocks; limit += 1 + limit / 50) {
        SCOPED(c205) *broken = load(text);
        SCOPED(c205) *stepped = load(text);
        c205_stop stop = c205_run(broken, limit), other;
        while (c205_clock(stepped) < limit && c205_step(stepped, &other))
            continue;
        assert_same(broken, stepped);
        if (stop.trap == C205_TRAP_CLOCK_LIMIT)
            c205_run(broken, C205_NO_LIMIT);
        assert_same(broken, whole);
    }
}

TEST(limits)
{
    check_limits(arithmetic);
    check_limits("        .regs   r10, turns, to, x, y\n"
                 "        ES      turns, 12\n"
                 "        load_constant x, 1.5\n"
                 "        EX      to, again\n"
                 "again:  DIVS    x, x, y\n"
                 "        BIM     await\n"
                 "await:  ADDX    y, r0, y\n" LOOP_END);
}

struct heard {
    uint64_t events, clock;
};

/* Each event must begin at the clock at which the previous event ended. */
static void hear(void *context, const c205 *machine UNUSED, const c205_event *event)
{
    struct heard *heard = context;
    if (event->kind != C205_EVENT_INSTRUCTION && event->kind != C205_EVENT_REQUEST)
        return;
    assert_int_equal(event->record->arrived, heard->clock);
    heard->clock += event->clocks;
    heard->events++;
}

static uint64_t instructions(const c205 *machine)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < c205_account_count(machine); i++)
        sum += c205_account_at(machine, i)->instructions;
    return sum;
}

/* A listener that is added during a run is notified of all later events. */
TEST(listener)
{
    SCOPED(c205) *whole = load(arithmetic);
    c205_run(whole, C205_NO_LIMIT);
    for (uint64_t limit = 1; limit < c205_clock(whole); limit += 137) {
        SCOPED(c205) *machine = load(arithmetic);
        c205_run(machine, limit);
        uint64_t before = instructions(machine);
        struct heard heard = { 0, c205_clock(machine) };
        assert_true(c205_listen(machine, hear, &heard));
        c205_run(machine, C205_NO_LIMIT);
        assert_int_equal(before + heard.events, instructions(whole));
        assert_same(machine, whole);
    }
}

/* ---- Code that changes --------------------------------------------------- */

/* A store to the code of its own block, at an instruction before or after the store.
 * From then on the new instruction is executed. */
TEST(changes)
{
    static const char text[] =
        "        .regs   r10, at, from, word, turns, to, sum, back\n"
        "        EX      from, other\n"
        "        EX      at, ahead\n"
        "        EX      back, behind\n"
        "        ES      turns, 6\n"
        "        ES      sum, 0\n"
        "        EX      to, again\n"
        "        .align  64\n"
        "again:\n"
        "behind: IS      sum, 1\n"
        "        IS      sum, 1\n"
        "        LOD     [from], word\n"
        "        STO     [at], word\n"
        "        .align  64\n"
        "ahead:  IS      sum, 10\n"
        "        IS      sum, 10\n"
        "        STO     [back], word\n" LOOP_END "        .align  64\n"
        "other:  IS      sum, 100\n"
        "        IS      sum, 100\n";
    SCOPED_VALUE(both) both = compare(text);
    assert_int_equal(c205_register(both.whole, 15), 2 + 200 + 5 * 400);
}

/* ---- Faults -------------------------------------------------------------- */

/* Loads access unmapped memory within a block. Once it is mapped, the run continues. */
TEST(fault)
{
    static const char text[] = "        .regs   r10, at, x, sum, turns, to\n"
                               "        EX      at, 0x10000000 - 64 * 20\n"
                               "        ES      turns, 40\n"
                               "        ES      sum, 0\n"
                               "        EX      to, again\n"
                               "again:  IX      at, 64\n"
                               "        LOD     [at], x\n"
                               "        ADDX    sum, x, sum\n" LOOP_END
                               "        .data\n"
                               "        .org    0x10000000 - 64 * 20\n"
                               "        .space  20\n";
    SCOPED_VALUE(both) both = compare(text);
    assert_int_equal(both.stop.trap, C205_TRAP_UNMAPPED_ADDRESS);
    assert_int_equal(both.stop.address, 0x10000000);
    assert_true(c205_map(both.whole, 0x10000000, 100, C205_READ_WRITE, &failure));
    assert_true(c205_map(both.stepped, 0x10000000, 100, C205_READ_WRITE, &failure));
    c205_run(both.whole, C205_NO_LIMIT);
    step_to_end(both.stepped);
    assert_same(both.whole, both.stepped);
}

/* ---- Regions ------------------------------------------------------------- */

/* Control enters another region's block in the middle while vectors stream. */
TEST(regions)
{
    static const char text[] = "        .regs   r10, turns, to, a, b, time, v, x\n"
                               "        .data\n"
                               "        .vector numbers, 100, 1.0, 2.0, 3.0\n"
                               "        .code\n"
                               "        ES      turns, 30\n"
                               "        descriptor v, numbers, 100\n"
                               "        load_constant x, 1.5\n"
                               "        EX      to, inside\n"
                               "        .kernel one\n"
                               "begin:  ADDN    x, x, a\n"
                               "        MPYS    a, x, a\n"
                               "inside: DIVS    a, x, b\n"
                               "        ADDN    b, x, b\n"
                               "        .endkernel\n"
                               "        .kernel two\n"
                               "        MPYS    b, x, a\n"
                               "        CLOCK   time\n"
                               "        CFPLT   x, b, further\n"
                               "        ADDNV   [v], [v], [v]\n"
                               "further: ADDN   a, b, a\n"
                               "        DBNZ    turns, [to]\n"
                               "        .endkernel\n"
                               "        EXIT\n";
    SCOPED_VALUE(both) both = compare(text);
    assert_int_equal(c205_account_count(both.whole), 3);
    assert_int_equal(c205_account_at(both.whole, 1)->entries, 30);
}

/* ---- Other programs, other models ---------------------------------------- */

/* Constants that differ from the prior model's, and a program. */
static const struct {
    const char *constants, *text;
} programs[] = {
    /* Vectors stream while blocks load and compute. */
    { "", "        .regs   r10, turns, to, v, at, x, y\n"
          "        .data\n"
          "        .vector numbers, 300, 1.0, 2.0, 3.0\n"
          "        .code\n"
          "        ES      turns, 30\n"
          "        descriptor v, numbers, 300\n"
          "        EX      at, numbers\n"
          "        EX      to, again\n"
          "again:  ADDNV   [v], [v], [v]\n"
          "        ADDN    x, y, x\n"
          "        EX      to, inner\n"
          "        BIM     inner\n"
          "inner:  LOD     [at], y\n"
          "        MPYS    y, y, x\n"
          "        EX      to, again\n" LOOP_END },
    /* An instruction that reads the time gets its first clock, anywhere in a block. */
    { "", "        .regs   r10, turns, to, x, y, wait, left, flags, sum, run_out\n"
          "        ES      turns, 30\n"
          "        ES      wait, 50\n"
          "        ES      run_out, 36\n"
          "        load_constant x, 1.5\n"
          "        EX      to, again\n"
          "again:  WJTIME  wait\n"
          "        DIVS    x, x, y\n"
          "        ADDN    y, x, y\n"
          "        LSDFR   r0, flags\n"
          "        ADDX    sum, flags, sum\n"
          "        WJTIME  wait\n"
          "        DIVS    x, x, y\n"
          "        ADDN    y, x, y\n"
          "        RJTIME  left\n"
          "        ADDX    sum, left, sum\n"
          "        WJTIME  wait\n"
          "        DIVS    x, x, y\n"
          "        ADDN    y, x, y\n"
          "        BADF    run_out, [to], 0\n" LOOP_END },
    /* Loads wait for the oldest of three loads, across the ends of blocks. */
    { "latency.load 70 clk R\n"
      "memory.loads_in_flight 3 loads R\n",
      "        .regs   r10, turns, to, at, a, b, c, n, three\n"
      "        .data\n"
      "words:  .space  10\n"
      "        .code\n"
      "        EX      at, words\n"
      "        ES      turns, 40\n"
      "        ES      three, 3\n"
      "        EX      to, again\n"
      "again:  LOD     [at], a\n"
      "        AND     turns, three, n\n"
      "        IBXEQ   n, r0, three, less, n\n"
      "        LOD     [at], b\n"
      "less:   BIM     more\n"
      "more:   LOD     [at], c\n"
      "        LOD     [at], r0\n"
      "        ADDX    n, a, n\n" LOOP_END },
    /* A SWAP of more registers takes longer, and ends on another page. Three pages are
     * used, but only two translations are stored. */
    { "page.words 512 words R\n"
      "translation.registers 2 registers R\n",
      "        .regs   r10, turns, to, place, from, n, mask, five\n"
      "        .regs   r20, near, far, x\n"
      "        .data\n"
      "        .org    0x10000000\n"
      "words:  .space  3000\n"
      "        .code\n"
      "        EX      from, words + 64 * 509\n"
      "        EX      near, words\n"
      "        EX      far, words + 64 * 2000\n"
      "        ES      turns, 80\n"
      "        ES      mask, 7\n"
      "        ES      five, 5\n"
      "again:  LOD     [near], x\n"
      "        AND     turns, mask, n\n"
      "        ADDLEN  from, n, place\n"
      "        BIM     swap\n"
      "swap:   SWAP    [r0], r100, [place]\n"
      "        IBXNE   n, r0, five, over, n\n"
      "        LOD     [far], x\n"
      "over:   EX      to, again\n" LOOP_END },
    /* The largest number of loads in a block, then a SWAP. */
    { "page.words 512 words R\n"
      "translation.registers 2 registers R\n",
      "        .regs   r10, turns, to, at, load, save, n, seven\n"
      "        .regs   r20, far, x\n"
      "        .data\n"
      "        .org    0x10000000\n"
      "words:  .space  4000\n"
      "        .code\n"
      "        EX      at, words\n"
      "        EX      load, words\n"
      "        ELEN    load, 4\n"
      "        EX      save, words + 64 * 4\n"
      "        ELEN    save, 4\n"
      "        EX      far, words + 64 * 2048\n"
      "        ELEN    far, 4\n"
      "        EX      turns, 60\n"
      "        ES      seven, 7\n"
      "        EX      to, again\n"
      "again:\n"
      "        .rept   31\n"
      "        LOD     [at], x\n"
      "        .endr\n"
      "        SWAP    [load], r200, [save]\n"
      "        AND     turns, seven, n\n"
      "        IBXNE   n, r0, r0, near\n"
      "        ADDX    far, r0, save\n"
      "near:   DBNZ    turns, [to]\n"
      "        EXIT\n" },
    /* Only SWAP and the end of the program wait for a result in register 0. On one path
     * the result is a product, on the other a sum. */
    { "latency.multiply 40 clk R\nlatency.add 30 clk R\n",
      "        .regs   r10, turns, to, bit, one, x, place\n"
      "        .data\n"
      "words:  .space  4\n"
      "        .code\n"
      "        EX      to, again\n"
      "        ES      turns, 8\n"
      "        ES      one, 1\n"
      "        load_constant x, 1.5\n"
      "        descriptor place, words, 4\n"
      "again:  AND     turns, one, bit\n"
      "        IBXEQ   bit, r0, one, odd, bit\n"
      "        MPYS    x, x, r0\n"
      "        BIM     both\n"
      "odd:    ADDN    x, x, r0\n"
      "        BIM     both\n"
      "both:   SWAP    [r0], r4, [place]\n" LOOP_END },
};

TEST(programs)
{
    c205_model *usual = prior_model;
    for (size_t i = 0; i < COUNT(programs); i++) {
        const char *constants = formatted("title T\nlike cyber205-2pipe-prior\n%s",
                                          programs[i].constants);
        SCOPED(c205_model) *model = NON_NULL(
            c205_model_parse("other", constants, &failure));
        prior_model = model;
        SCOPED_VALUE(both) both = compare(programs[i].text);
    }
    prior_model = usual;
}

/* Data after an unconditional branch is not code. A store there is one change. */
TEST(data_behind_branch)
{
    SCOPED_VALUE(both) both = compare("        .regs   r10, turns, to, at, x, one\n"
                                      "        EX      to, again\n"
                                      "        EX      at, place\n"
                                      "        ES      turns, 100\n"
                                      "        ES      one, 1\n"
                                      "        .align  64\n"
                                      "again:  LOD     [at], x\n"
                                      "        ADDX    x, one, x\n"
                                      "        STO     [at], x\n"
                                      "        IBXEQ   r0, r0, r0, over\n"
                                      "        ADDX    x, x, x\n"
                                      "place:  ADDX    x, x, x\n"
                                      "        ADDX    x, x, x\n"
                                      "over:   DBNZ    turns, [to]\n"
                                      "        EXIT\n");
    assert_int_equal(both.stop.trap, C205_TRAP_NONE);
    assert_true(both.whole->memory.code_changes
                < both.stepped->memory.code_changes + 5);
}

/* ---- Limits of memory ---------------------------------------------------- */

/* The cache cannot hold all blocks, so it is cleared and filled again. */
TEST(many_blocks)
{
    static const char text[] = "        .regs   r10, turns, to, sum\n"
                               "        ES      turns, 2\n"
                               "        EX      to, again\n"
                               "again:\n"
                               "        .rept   70000\n"
                               "        IS      sum, 1\n"
                               "        .endr\n" LOOP_END;
    SCOPED(c205) *machine = load(text);
    c205_run(machine, C205_NO_LIMIT);
    assert_int_equal(c205_register(machine, 12), 140000);
    assert_int_equal(instructions(machine), 140000 + 5);
    assert_true(machine->blocks->decoded_count < 140000);
}

/* Each of many branches is taken at random, so that new states of in-flight results
 * occur. When the cache of states is cleared, no block may use old entries. */
TEST(many_flights)
{
    static const char text[] =
        "        .regs   r10, turns, to, seed, factor, bits, one, x, zero\n"
        "        .macro  chance number\n"
        "        MPYX    seed, factor, seed\n"
        "        ADDX    seed, one, seed\n"
        "        SHIFTI  seed, -30, bits\n"
        "        AND     bits, one, bits\n"
        "        IBXEQ   bits, r0, one, skip\\@, bits\n"
        "        MPYS    x, x, r20\\number\n"
        "        DIVS    x, x, r21\\number\n"
        "skip\\@:\n"
        "        .endm\n"
        "        .code\n"
        "        EX      factor, 25214903917\n"
        "        EX      seed, 12345\n"
        "        ES      one, 1\n"
        "        load_constant x, 1.25\n"
        "        EX      turns, 60\n"
        "        EX      to, again\n"
        "again:\n"
        "        .rept   100\n"
        "        .rept   10\n"
        "        chance  \\+\n"
        "        .endr\n"
        "        .endr\n" LOOP_END;
    SCOPED_VALUE(both) both = compare(text);
    assert_true(both.whole->clock->generation > 1);
}
