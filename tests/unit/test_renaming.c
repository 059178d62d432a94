/* test_renaming.c - the final state of a random program is compared with the final
 * state of the same program with permuted registers. A state or a clock that depends on
 * the names of registers fails here.
 *
 *   test_renaming [PROGRAMS]
 *
 * Both runs must end with the same numbers in corresponding registers, the same memory
 * and the same clocks. Register 0 keeps its name. Registers that an instruction uses
 * together (C and C+1) stay together.
 */
#include "tests/oracle/operand_letters.h"
#include "tests/unit/saved_machine.h"

enum {
    DEFAULT_PROGRAMS = 2000,
    STEPS = 200,
    PAIR = 2,       /* number of instructions after a prefix */
    IN_HALVES = 128 /* number of registers that have half registers */
};

static unsigned long program_count = DEFAULT_PROGRAMS;

/* new_name[r] is the new name of r. tied[r] means that r and r+1 stay together. */
struct renaming {
    uint8_t new_name[C205_REGISTERS];
    bool tied[C205_REGISTERS];
};

static const c205_insn *row_of(const struct program_insn *insn)
{
    return c205_insn_coded((uint8_t)(insn->word >> 56), (uint8_t)(insn->word >> 48));
}

/* ---- Programs ---------------------------------------------------------- */

/* Returns false if the program has an instruction that cannot be renamed. SWAP is one,
 * because it uses as many registers as its vectors have elements. A word that is not in
 * the table, or has bits that its format does not have, is not an instruction. */
static bool can_be_renamed(const struct random_program *program)
{
    for (size_t i = 0; i < program->insn_count; i++) {
        const struct program_insn *insn = &program->insns[i];
        const c205_insn *row = row_of(insn);
        if (!row || row->format == C205_FORMAT_SWAP
            || c205_format_halves(row->format) != insn->halves)
            return false;
        c205_fields fields = c205_decode(row, insn->word);
        if (c205_encode(row, &fields) != insn->word || fields.c == C205_REGISTERS - 1
            || fields.c == IN_HALVES - 1)
            return false;
    }
    return true;
}

/* ---- The renaming ------------------------------------------------------ */

static void tie_pairs(struct renaming *renaming, const struct random_program *program)
{
    for (size_t i = 0; i < program->insn_count; i++) {
        const c205_insn *row = row_of(&program->insns[i]);
        c205_fields fields = c205_decode(row, program->insns[i].word);
        if (c205_unit_is_vector(row->unit) && !is_half_register(row, fields.g, ROLE_C))
            renaming->tied[fields.c] = true;
    }
}

static uint64_t random_state = 5205;

static size_t below(size_t n)
{
    random_state = random_state * UINT64_C(6364136223846793005) + 1;
    return (size_t)(random_state >> 33) % n;
}

/* Shuffles the entries first .. end - 1. */
static void shuffle(unsigned *order, unsigned first, unsigned end)
{
    for (unsigned i = end - 1; i > first; i--) {
        size_t other = first + below(i - first + 1);
        unsigned one = order[i];
        order[i] = order[other];
        order[other] = one;
    }
}

/* Shuffles groups of tied registers. The first group begins with register 0. */
static void draw_names(struct renaming *renaming)
{
    unsigned begin[C205_REGISTERS + 1], order[C205_REGISTERS];
    unsigned runs = 0, low = 0, next = 0;
    for (unsigned r = 0; r < C205_REGISTERS; r++)
        if (r == 0 || !renaming->tied[r - 1]) {
            low = r == IN_HALVES ? runs : low;
            order[runs] = runs;
            begin[runs++] = r;
        }
    begin[runs] = C205_REGISTERS;
    shuffle(order, 1, low);
    shuffle(order, low, runs);
    for (unsigned i = 0; i < runs; i++)
        for (unsigned r = begin[order[i]]; r < begin[order[i] + 1]; r++)
            renaming->new_name[r] = (uint8_t)next++;
}

/* A sum traps with an odd register, so the parity must not change. */
static bool keeps_sums(const struct renaming *renaming,
                       const struct random_program *program)
{
    for (size_t i = 0; i < program->insn_count; i++) {
        const c205_insn *row = row_of(&program->insns[i]);
        c205_fields fields = c205_decode(row, program->insns[i].word);
        if (sized_letter(row, fields.g, ROLE_C) == 'p'
            && (renaming->new_name[fields.c] ^ fields.c) & 1)
            return false;
    }
    return true;
}

/* Renames an instruction. A half register moves with its register. */
static c205_word rename_insn(const struct renaming *renaming, const c205_insn *row,
                             c205_word word)
{
    c205_fields old = c205_decode(row, word), fields = old;
    uint8_t *const names[] = { &fields.x, &fields.a, &fields.y, &fields.b, &fields.z,
                               &fields.c, &fields.r, &fields.s, &fields.t };

    for (size_t i = 0; i < COUNT(names); i++)
        *names[i] = renaming->new_name[*names[i]];
    for (int role = 0; role < ROLES; role++)
        if (is_half_register(row, old.g, (enum role)role)) {
            uint8_t half = *field_of_role(&old, row, (enum role)role);
            *field_of_role(&fields, row,
                           (enum role)role) = (uint8_t)(2 * renaming->new_name[half / 2]
                                                        + half % 2);
        }
    return c205_encode(row, &fields);
}

static struct random_program rename_program(const struct renaming *renaming,
                                            const struct random_program *program)
{
    struct random_program renamed = *program;
    for (size_t i = 0; i < program->insn_count; i++)
        renamed.insns[i].word = rename_insn(renaming, row_of(&program->insns[i]),
                                            program->insns[i].word);
    for (unsigned r = 0; r < C205_REGISTERS; r++)
        renamed.registers[renaming->new_name[r]] = program->registers[r];
    return renamed;
}

/* ---- Runs of both machines --------------------------------------------- */

/* Returns true if the register points into the code. Instructions contain register
 * numbers, so a program that uses its own code changes with renaming. */
static bool holds_code_address(const c205 *machine, unsigned number,
                               const struct random_program *program)
{
    uint64_t address = c205_register(machine, number) << 16 >> 16;
    return address >= random_pages[0].address
           && address < program_address(program, program->insn_count);
}

static bool uses_code(const c205 *machine, const c205_insn *row, const c205_fields *f,
                      const struct random_program *program)
{
    const uint8_t names[] = { f->x, f->a, f->y, f->b, f->z, f->c, f->r, f->s, f->t };
    for (size_t i = 0; i < sizeof names; i++)
        if (holds_code_address(machine, names[i], program))
            return row->unit != C205_UNIT_BRANCH || row->format == C205_FORMAT_ALTERB;
    return false;
}

/* Checks the next instruction, or the next three after a prefix. A branch may also lead
 * to an address where no instruction of the program begins. */
static bool next_uses_code(const c205 *machine, const struct random_program *program)
{
    size_t i = 0, end;
    while (i < program->insn_count && program_address(program, i) != c205_pc(machine))
        i++;
    if (i == program->insn_count)
        return true;
    for (end = i + 1; i < end && i < program->insn_count; i++) {
        const c205_insn *row = row_of(&program->insns[i]);
        c205_fields fields = c205_decode(row, program->insns[i].word);
        if (uses_code(machine, row, &fields, program))
            return true;
        if (row->format == C205_FORMAT_NONE)
            end = i + 1 + PAIR;
    }
    return false;
}

static void check_memory(const c205 *machine, const c205 *other)
{
    enum { MAX_AREA = 4096 };
    static c205_word one[MAX_AREA], two[MAX_AREA];
    for (size_t i = 0; i < random_area_count; i++) {
        const struct random_area *area = random_areas + i;
        assert_true(c205_read(machine, area->address, one, area->words));
        assert_true(c205_read(other, area->address, two, area->words));
        assert_memory_equal(one, two, area->words * sizeof *one);
    }
}

static bool step_both(c205 *machine, c205 *other, const struct renaming *renaming)
{
    c205_stop stop = { .trap = C205_TRAP_NONE };
    c205_stop its_stop = { .trap = C205_TRAP_NONE };
    bool goes_on = c205_step(machine, &stop);
    assert_int_equal(goes_on, c205_step(other, &its_stop));
    assert_int_equal(stop.trap, its_stop.trap);
    assert_int_equal(stop.address, its_stop.address);
    for (unsigned r = 1; r < C205_REGISTERS; r++)
        assert_int_equal(c205_register(machine, r),
                         c205_register(other, renaming->new_name[r]));
    assert_int_equal(c205_data_flags(machine), c205_data_flags(other));
    assert_int_equal(c205_pc(machine), c205_pc(other));
    assert_int_equal(c205_clock(machine), c205_clock(other));
    for (size_t i = 0; i < c205_account_count(machine); i++)
        assert_memory_equal(c205_account_at(machine, i)->clocks,
                            c205_account_at(other, i)->clocks,
                            sizeof c205_account_at(machine, i)->clocks);
    return goes_on;
}

static void try_program(const struct random_program *program)
{
    struct renaming renaming = { .tied = { false } };
    tie_pairs(&renaming, program);
    do
        draw_names(&renaming);
    while (!keeps_sums(&renaming, program));
    struct random_program renamed = rename_program(&renaming, program);
    SCOPED(c205_model) *model = model_of(program);
    SCOPED(c205) *machine = machine_of(program, model);
    SCOPED(c205) *other = machine_of(&renamed, model);
    for (int step = 0; step < STEPS && !next_uses_code(machine, program); step++)
        if (!step_both(machine, other, &renaming))
            break;
    check_memory(machine, other);
}

TEST(renaming)
{
    unsigned long tried = 0;
    for (uint64_t seed = 1; tried < program_count; seed++) {
        struct random_program program = random_program(seed);
        if (can_be_renamed(&program)) {
            try_program(&program);
            tried++;
        }
    }
}

ARGUMENTS(argc, argv)
{
    program_count = argument(argc, argv, 1, share_of(program_count));
}
