/* reference_clock.c - computes waits and their causes (reference_clock.h). */
#include "reference_clock.h"

#include <stdio.h>
#include <string.h>

enum { WORD = 64, HALF = 32, NAME = 64 };
#define MILLION UINT64_C(1000000)

/* ---- Constants --------------------------------------------------------- */

/* Returns the constant FAMILY.NAME of the model, in millionths. */
static uint64_t millionths(const struct reference_clock *clock, const char *family,
                           const char *name)
{
    char full[NAME];
    snprintf(full, sizeof full, "%s.%s", family, name);
    return (uint64_t)(c205_model_lookup(clock->model, full)->value * (double)MILLION
                      + 0.5);
}

static uint64_t constant(const struct reference_clock *clock, const char *family,
                         const char *name)
{
    return millionths(clock, family, name) / MILLION;
}

static uint64_t of_class(const struct reference_clock *clock, const char *family,
                         c205_timing timing)
{
    return constant(clock, family, c205_timing_name(timing));
}

/* ---- Charging ---------------------------------------------------------- */

static void charge(struct reference_clock *clock, size_t region, c205_cause cause,
                   uint64_t until)
{
    if (until > clock->now) {
        clock->charged[region][cause] += until - clock->now;
        clock->now = until;
    }
}

static void pass(struct reference_clock *clock, c205_cause cause, uint64_t clocks)
{
    charge(clock, clock->region, cause, clock->now + clocks);
}

/* Charges each part of the wait to the phase of the vector unit during this part. */
static void wait_for_vector(struct reference_clock *clock, uint64_t until)
{
    for (size_t i = 0; i < clock->phase_count; i++)
        charge(clock, clock->phases[i].region, clock->phases[i].cause,
               lesser(clock->phases[i].end, until));
}

static void wait_for(struct reference_clock *clock, const struct awaited *awaited)
{
    if (awaited->maker == VECTOR_UNIT)
        wait_for_vector(clock, awaited->ready);
    else
        charge(clock, clock->region,
               awaited->maker == LOAD ? C205_MEMORY_WAIT : C205_OPERAND_WAIT,
               awaited->ready);
}

/* ---- Registers --------------------------------------------------------- */

/* The registers of an instruction in its syntax's order. Offsets follow vectors. */
struct named {
    const c205_insn *insn;
    const c205_fields *fields;
    unsigned numbers[16];
    size_t count;
};

static void name_register(struct named *named, unsigned number)
{
    if (number != 0)
        named->numbers[named->count++] = number;
}

/* Adds the register of an operand. For a half register, this is the register that
 * contains it. */
static void name_operand(struct named *named, char field, unsigned number)
{
    unsigned bit = field == 'A'   ? C205_G_BROADCAST_A
                   : field == 'B' ? C205_G_BROADCAST_B
                                  : 0;
    char letter = reference_letter(named->insn, named->fields->g, field);
    name_register(named, reference_is_half_register(letter, named->fields->g & bit)
                             ? number / 2
                             : number);
}

/* Returns true for a reduction. It only writes C, so its wait for C is the last. */
static bool is_reduction(const c205_insn *insn)
{
    return insn->format == C205_FORMAT_REDUCE || insn->format == C205_FORMAT_REDUCE2
           || insn->format == C205_FORMAT_EXTREME;
}

/* Returns true if a sum has a second register. A first register of 0 has none. */
static bool has_second_part(const c205_insn *insn, const c205_fields *fields)
{
    return strchr(insn->operands, 'p') && fields->c != 0;
}

static void name_results(struct named *named)
{
    const c205_fields *fields = named->fields;
    if (named->insn->format == C205_FORMAT_EXTREME)
        name_register(named, fields->b);
    name_operand(named, 'C', fields->c);
    if (has_second_part(named->insn, fields))
        name_operand(named, 'C', fields->c + 1u);
}

static void name_field(struct named *named, char field)
{
    const c205_insn *insn = named->insn;
    const c205_fields *fields = named->fields;
    bool vector = c205_unit_is_vector(insn->unit);
    switch (field) {
    case 'R': name_operand(named, 'R', fields->r); break;
    case 'S': name_operand(named, 'S', fields->s); break;
    case 'T': name_operand(named, 'T', fields->t); break;
    case 'a':
    case 'A':
        name_operand(named, 'A', fields->a);
        if (vector)
            name_register(named, fields->x);
        break;
    case 'b':
    case 'B':
        if (insn->format == C205_FORMAT_EXTREME)
            break;
        name_operand(named, 'B', fields->b);
        if (vector)
            name_register(named, fields->y);
        break;
    case 'C':
        if (!is_reduction(insn))
            name_register(named, fields->c);
        if (reference_has_offset(insn, fields))
            name_register(named, fields->c + 1u);
        break;
    case 'X': name_register(named, fields->x); break;
    case 'Z': name_register(named, fields->z); break;
    case '@':
        if (!(fields->g & C205_G_RELATIVE)) {
            name_register(named, fields->y);
            name_register(named, fields->b);
        }
        break;
    default: break;
    }
}

static void wait_for_registers(struct reference_clock *clock, const c205_insn *insn,
                               const c205_fields *fields)
{
    const char *syntax = c205_format_syntax(insn->format);
    struct named named = { .insn = insn, .fields = fields };
    for (const char *p = syntax; *p; p++)
        if (p == syntax || p[-1] != '+')
            name_field(&named, *p);
    if (is_reduction(insn))
        name_results(&named);
    for (size_t i = 0; i < named.count; i++)
        wait_for(clock, clock->registers + named.numbers[i]);
}

/* Returns the field that an instruction writes, or 0. */
static char written_field(const c205_insn *insn)
{
    const char *letters = insn->operands;
    if (!strpbrk(letters, "wpmkcoWM"))
        return '\0';
    if (insn->format == C205_FORMAT_ALTER)
        return 'A';
    if (insn->format == C205_FORMAT_INDEX
        || (c205_unit_is_vector(insn->unit) && insn->format != C205_FORMAT_BITS1))
        return 'C';
    return strchr("wmWM", letters[0]) && letters[1] != '\0' ? 'R' : 'T';
}

/* Returns the register of the result plus `behind`. The register of a half register is
 * the register that contains it. */
static unsigned written(const c205_insn *insn, const c205_fields *fields,
                        unsigned behind)
{
    char field = written_field(insn);
    unsigned number = field == 'A'   ? fields->a
                      : field == 'C' ? fields->c
                      : field == 'R' ? fields->r
                                     : fields->t;
    char letter = reference_letter(insn, fields->g, field);
    number += behind;
    return reference_is_half_register(letter, false) ? number / 2 : number;
}

/* Delivers a result. A result for register 0 is never read, but is in flight, too. */
static void deliver_to(struct reference_clock *clock, unsigned number,
                       struct awaited awaited)
{
    if (number != 0 || awaited.ready > clock->registers[0].ready)
        clock->registers[number] = awaited;
}

static void deliver(struct reference_clock *clock, const c205_insn *insn,
                    const c205_fields *fields, struct awaited awaited)
{
    if (!written_field(insn))
        return;
    deliver_to(clock, written(insn, fields, 0), awaited);
    if (has_second_part(insn, fields))
        deliver_to(clock, written(insn, fields, 1), awaited);
    if (insn->format == C205_FORMAT_EXTREME)
        deliver_to(clock, fields->b, awaited);
    if (reference_letter(insn, fields->g, 'Z') == 'o')
        deliver_to(clock, fields->z, awaited);
}

/* ---- Pages ------------------------------------------------------------- */

struct translation {
    uint64_t page_bits, registers, real_pages;
    uint64_t misses, faults;
};

/* Returns counts of zero for the model's pages. Real memory has room for at least one
 * page. */
static struct translation nothing_met(const struct reference_clock *clock)
{
    uint64_t words = constant(clock, "page", "words");
    uint64_t pages = constant(clock, "memory", "real_words") / words;
    return (struct translation){
        .page_bits = words * WORD,
        .registers = constant(clock, "translation", "registers"),
        .real_pages = pages > 0 ? pages : 1,
    };
}

/* Moves a page to the front of the list and returns its previous depth. */
static size_t touch(struct reference_clock *clock, uint64_t page)
{
    size_t depth = 0;
    while (depth < clock->page_count && clock->pages[depth] != page)
        depth++;
    bool known = depth < clock->page_count;
    if (!known && clock->page_count < CLOCK_PAGES)
        clock->page_count++;
    size_t above = lesser(depth, CLOCK_PAGES - 1);
    memmove(clock->pages + 1, clock->pages, above * sizeof *clock->pages);
    clock->pages[0] = page;
    return known ? depth : CLOCK_PAGES;
}

static void look_up(struct reference_clock *clock, uint64_t page,
                    struct translation *translation)
{
    size_t depth = touch(clock, page);
    if (depth >= translation->registers || depth >= translation->real_pages)
        translation->misses++;
    if (depth >= translation->real_pages)
        translation->faults++;
}

static struct translation translate(struct reference_clock *clock,
                                    const struct deed *deed)
{
    struct translation translation = nothing_met(clock);
    uint64_t page_bits = translation.page_bits;
    for (size_t i = 0; i < deed->extent_count; i++) {
        const struct extent *extent = deed->extents + i;
        uint64_t last = extent->address + extent->bits - 1;
        for (uint64_t page = plain_address(extent->address) / page_bits;
             page <= plain_address(last) / page_bits; page++)
            look_up(clock, page, &translation);
    }
    for (size_t i = 0; i < deed->indexed_count; i++)
        look_up(clock, plain_address(deed->indexed[i]) / page_bits, &translation);
    translation.misses *= constant(clock, "translation", "miss");
    translation.faults *= constant(clock, "page_fault", "clocks");
    return translation;
}

/* ---- The scalar unit --------------------------------------------------- */

static void forget_loads(struct reference_clock *clock)
{
    while (clock->load_count > 0 && clock->loads[0] <= clock->now)
        memmove(clock->loads, clock->loads + 1,
                --clock->load_count * sizeof *clock->loads);
}

static void wait_for_loads(struct reference_clock *clock, size_t left)
{
    while (clock->load_count > left) {
        charge(clock, clock->region, C205_MEMORY_WAIT, clock->loads[0]);
        forget_loads(clock);
    }
}

static void issue(struct reference_clock *clock)
{
    pass(clock, C205_ISSUE, constant(clock, "issue", "interval"));
}

/* Waits until the vector unit has finished, because memory belongs to it until then. */
static void reach_memory(struct reference_clock *clock, const struct deed *deed)
{
    wait_for_vector(clock, clock->vector_done);
    struct translation translation = translate(clock, deed);
    pass(clock, C205_TRANSLATION_MISS, translation.misses);
    pass(clock, C205_PAGE_FAULT, translation.faults);
}

static void step_swap(struct reference_clock *clock, const struct deed *deed)
{
    uint64_t words = deed->swapped * millionths(clock, "swap", "word") + MILLION - 1;
    uint64_t clocks = constant(clock, "latency", "swap") + words / MILLION;
    wait_for_registers(clock, deed->insns[0], deed->fields);
    reach_memory(clock, deed);
    wait_for_loads(clock, 0);
    for (size_t i = 0; i < C205_REGISTERS; i++)
        wait_for(clock, clock->registers + i);
    uint64_t begin = clock->now;
    issue(clock);
    charge(clock, clock->region, C205_MEMORY_WAIT, begin + clocks);
}

static void step_scalar(struct reference_clock *clock, const struct deed *deed)
{
    const c205_insn *insn = deed->insns[0];
    bool load = insn->timing == C205_TIMING_load;
    wait_for_registers(clock, insn, deed->fields);
    if (insn->unit == C205_UNIT_MEMORY || deed->extent_count > 0)
        reach_memory(clock, deed);
    if (load)
        wait_for_loads(clock, constant(clock, "memory", "loads_in_flight") - 1);
    charge(clock, clock->region, C205_UNIT_BUSY, clock->unit_free[insn->unit]);
    uint64_t ready = clock->now + of_class(clock, "latency", insn->timing);
    clock->unit_free[insn->unit] = clock->now + of_class(clock, "busy", insn->timing);
    if (load)
        clock->loads[clock->load_count++] = ready;
    deliver(clock, insn, deed->fields,
            (struct awaited){ ready, load ? LOAD : ARITHMETIC });
    issue(clock);
}

/* ---- Branches ---------------------------------------------------------- */

/* Extends the instruction stack by the sequential code through this instruction. */
static void run_on(struct reference_clock *clock, const struct deed *deed)
{
    uint64_t halves = 0, end;
    for (size_t i = 0; i < deed->insn_count; i++)
        halves += c205_format_halves(deed->insns[i]->format);
    end = (deed->pc + HALF * halves + WORD - 1) / WORD;
    if (end > clock->stack_high)
        clock->stack_high = end;
    uint64_t words = constant(clock, "branch", "stack_words");
    if (clock->stack_high - clock->stack_low > words)
        clock->stack_low = clock->stack_high - words;
}

static void step_branch(struct reference_clock *clock, const struct deed *deed)
{
    uint64_t word = deed->target / WORD;
    bool inside = word >= clock->stack_low && word < clock->stack_high;
    if (deed->insns[0]->timing == C205_TIMING_monitor)
        pass(clock, C205_BRANCH, constant(clock, "latency", "monitor") - 1);
    else if (!deed->taken)
        pass(clock, C205_BRANCH, constant(clock, "branch", "not_taken"));
    else if (inside)
        pass(clock, C205_BRANCH, constant(clock, "branch", "taken"));
    else {
        pass(clock, C205_BRANCH, constant(clock, "branch", "out_of_stack"));
        reference_clock_enter(clock, deed->target);
    }
}

/* ---- The vector unit --------------------------------------------------- */

/* Returns the number of clocks that a gather or scatter waits for busy banks. */
static uint64_t conflicts(const struct reference_clock *clock, const struct deed *deed)
{
    uint64_t banks = constant(clock, "memory", "banks");
    uint64_t busy = constant(clock, "memory", "bank_busy");
    uint64_t free[1024] = { 0 };
    uint64_t time = 0;
    for (size_t k = 0; k < deed->indexed_count; k++) {
        uint64_t bank = deed->indexed[k] / WORD % banks;
        if (k > 0)
            time++;
        if (free[bank] > time)
            time = free[bank];
        free[bank] = time + busy;
    }
    return deed->indexed_count > 0 ? time - (deed->indexed_count - 1) : 0;
}

/* Returns the number of clocks of a stream. If its rate is per pipe, the pipes process
 * several elements at the same time. */
static uint64_t stream(const struct reference_clock *clock, c205_timing timing,
                       bool halves, uint64_t elements)
{
    char name[NAME];
    uint64_t pipes, millionth;
    snprintf(name, sizeof name, "stream.%s", c205_timing_name(timing));
    const c205_constant *rate = c205_model_lookup(clock->model, name);
    pipes = strstr(rate->unit, "pipe") ? constant(clock, "machine", "pipes") : 1;
    if (strstr(rate->unit, "pipe"))
        pipes *= constant(clock, "vector", halves ? "half_rate" : "word_rate");
    millionth = elements * millionths(clock, "stream", c205_timing_name(timing));
    return (millionth + MILLION * pipes - 1) / (MILLION * pipes);
}

static void add_phase(struct reference_clock *clock, c205_cause cause, uint64_t *end,
                      uint64_t clocks)
{
    *end += clocks;
    clock->phases[clock->phase_count++] = (struct phase){ *end, cause, clock->region };
}

/* Removes the phases that have ended. */
static void forget_phases(struct reference_clock *clock)
{
    size_t kept = 0;
    for (size_t i = 0; i < clock->phase_count; i++)
        if (clock->phases[i].end > clock->now)
            clock->phases[kept++] = clock->phases[i];
    clock->phase_count = kept;
}

/* Waits until the start-up can overlap the previous stream. */
static void wait_for_overlap(struct reference_clock *clock, uint64_t startup)
{
    uint64_t hidden = lesser(lesser(constant(clock, "vector", "overlap"),
                                    clock->vector_stream),
                             startup);
    if (clock->vector_done > hidden)
        wait_for_vector(clock, clock->vector_done - hidden);
}

/* Returns the start-up time. For a linked pair it is longer by the excess of each
 * instruction's start-up over the start-up of an addition. */
static uint64_t startup_of(const struct reference_clock *clock, const struct deed *deed)
{
    uint64_t addition = of_class(clock, "startup", C205_TIMING_vadd);
    uint64_t clocks = of_class(clock, "startup", deed->insns[0]->timing);
    for (size_t i = 1; i < deed->insn_count; i++) {
        uint64_t own = of_class(clock, "startup", deed->insns[i]->timing);
        clocks += own > addition ? own - addition : 0;
    }
    return clocks;
}

/* Returns the time of the stream. A linked pair has the rate of its slower instruction.
 * Each recurrent element waits for the previous element. */
static uint64_t stream_of(const struct reference_clock *clock, const struct deed *deed,
                          uint64_t startup)
{
    bool halves = deed->fields[deed->insn_count - 1].g & C205_G_HALF;
    uint64_t longest = 0;
    for (size_t i = 0; i < deed->insn_count; i++) {
        uint64_t clocks = stream(clock, deed->insns[i]->timing, halves, deed->elements);
        longest = clocks > longest ? clocks : longest;
    }
    return longest + deed->recurrent * startup;
}

static void step_vector(struct reference_clock *clock, const struct deed *deed)
{
    size_t last = deed->insn_count - 1;
    uint64_t startup = startup_of(clock, deed);
    for (size_t i = 0; i <= last; i++)
        wait_for_registers(clock, deed->insns[i], deed->fields + i);
    wait_for_loads(clock, 0);
    wait_for_overlap(clock, startup);
    struct translation translation = translate(clock, deed);
    forget_phases(clock);
    uint64_t end = clock->now;
    add_phase(clock, C205_VECTOR_STARTUP, &end, startup);
    add_phase(clock, C205_TRANSLATION_MISS, &end, translation.misses);
    add_phase(clock, C205_PAGE_FAULT, &end, translation.faults);
    add_phase(clock, C205_BANK_CONFLICT, &end, conflicts(clock, deed));
    clock->vector_stream = stream_of(clock, deed, startup);
    add_phase(clock, C205_VECTOR_STREAM, &end, clock->vector_stream);
    clock->vector_done = end;
    deliver(clock, deed->insns[last], deed->fields + last,
            (struct awaited){ end, VECTOR_UNIT });
    wait_for_vector(clock, clock->now + constant(clock, "issue", "interval"));
}

/* ---- A step ------------------------------------------------------------ */

void reference_clock_begin(struct reference_clock *clock, const c205_model *model)
{
    memset(clock, 0, sizeof *clock);
    clock->model = model;
}

void reference_clock_enter(struct reference_clock *clock, uint64_t pc)
{
    clock->stack_low = clock->stack_high = pc / WORD;
}

/* Returns the number of floating-point operations of one element or of one scalar
 * instruction. It depends on the prefix of the mnemonic. */
static unsigned flops(const c205_insn *insn)
{
    static const char ones[][7] = { "ADDU", "ADDN", "SUBU",   "SUBL",  "SUBN",
                                    "MPYU", "MPYL", "MPYS",   "DIVU",  "DIVS",
                                    "SQRT", "AVG",  "DELTAV", "SUMV",  "PROD",
                                    "ADJM", "INTV", "ADDLV",  "ADDLH", "ADDLS" };
    static const char twos[][5] = { "DOTV", "POLY" };
    for (size_t i = 0; i < sizeof twos / sizeof twos[0]; i++)
        if (strncmp(insn->mnemonic, twos[i], strlen(twos[i])) == 0)
            return 2;
    for (size_t i = 0; i < sizeof ones / sizeof ones[0]; i++)
        if (strncmp(insn->mnemonic, ones[i], strlen(ones[i])) == 0)
            return 1;
    return strcmp(insn->mnemonic, "ADDL") == 0;
}

static uint64_t operations(const struct deed *deed)
{
    uint64_t all = 0, times = 1;
    if (c205_unit_is_vector(deed->insns[0]->unit))
        times = deed->insns[0]->format == C205_FORMAT_SPARSE ? deed->results
                                                             : deed->elements;
    for (size_t i = 0; i < deed->insn_count; i++)
        all += flops(deed->insns[i]) * times;
    return all;
}

/* Counts instructions, elements, operations, and entries from other regions. */
static void count(struct reference_clock *clock, const struct deed *deed, size_t region)
{
    struct counts *counts = clock->counts + region;
    counts->instructions++;
    counts->operations += operations(deed);
    if (c205_unit_is_vector(deed->insns[0]->unit)) {
        counts->vector_instructions++;
        counts->elements += deed->elements;
    }
    if (!clock->begun || region != clock->region)
        counts->entries++;
    clock->begun = true;
}

void reference_clock_step(struct reference_clock *clock, const struct deed *deed,
                          size_t region)
{
    const c205_insn *insn = deed->insns[0];
    count(clock, deed, region);
    clock->region = region;
    forget_loads(clock);
    run_on(clock, deed);
    if (insn->timing == C205_TIMING_swap)
        step_swap(clock, deed);
    else if (c205_unit_is_vector(insn->unit))
        step_vector(clock, deed);
    else
        step_scalar(clock, deed);
    if (insn->unit == C205_UNIT_BRANCH)
        step_branch(clock, deed);
}

void reference_clock_drain(struct reference_clock *clock)
{
    wait_for_vector(clock, clock->vector_done);
    wait_for_loads(clock, 0);
    for (size_t i = 0; i < C205_REGISTERS; i++)
        wait_for(clock, clock->registers + i);
}
