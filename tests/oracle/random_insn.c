/* random_insn.c - random instructions of the instruction table. */
#include "random_parts.h"

#include "tests/oracle/operand_letters.h"
#include "tests/oracle/operands.h"
#include "tests/oracle/reference.h"

#include <ctype.h>
#include <string.h>

/* ---- Instructions ------------------------------------------------------ */

static const unsigned unit_weights[C205_UNITS] = {
    [C205_UNIT_SINGLE] = 10,    [C205_UNIT_ADD] = 6,      [C205_UNIT_MULTIPLY] = 4,
    [C205_UNIT_DIVIDE] = 3,     [C205_UNIT_LOGICAL] = 4,  [C205_UNIT_MEMORY] = 9,
    [C205_UNIT_BRANCH] = 14,    [C205_UNIT_VECTOR] = 28,  [C205_UNIT_V_ADD] = 9,
    [C205_UNIT_V_MULTIPLY] = 4, [C205_UNIT_V_DIVIDE] = 4, [C205_UNIT_V_SHIFT] = 2,
    [C205_UNIT_V_LOGICAL] = 3,
};

static c205_unit draw_unit(uint64_t *random)
{
    int64_t left = random_between(random, 0, 99);
    int unit = 0;
    while (left >= unit_weights[unit])
        left -= unit_weights[unit++];
    return (c205_unit)unit;
}

typedef bool insn_filter(const c205_insn *insn);

static bool may_link(const c205_insn *insn)
{
    return c205_unit_links(insn->unit);
}

static const c205_insn *draw_any(uint64_t *random)
{
    return c205_insns + random_between(random, 0, (int64_t)c205_insn_count - 1);
}

static const c205_insn *draw_where(uint64_t *random, insn_filter *fits)
{
    const c205_insn *insn;
    do
        insn = draw_any(random);
    while (!fits(insn));
    return insn;
}

static const c205_insn *draw_of_unit(uint64_t *random, c205_unit unit)
{
    const c205_insn *insn;
    do
        insn = draw_any(random);
    while (insn->unit != unit || !reference_knows(insn));
    return insn;
}

static bool is_prefix(const c205_insn *insn)
{
    return insn->format == C205_FORMAT_NONE;
}

/* Chooses an instruction that can be linked. All units have the same probability, but
 * the unit of the first instruction of the pair is rarely chosen for the second. */
static const c205_insn *draw_linked(uint64_t *random, const c205_insn *first)
{
    c205_unit unit;
    do
        unit = draw_where(random, may_link)->unit;
    while ((unit == C205_UNIT_V_ADD && one_in(random, 2))
           || (first && unit == first->unit && !one_in(random, 20)));
    return draw_of_unit(random, unit);
}

/* After a prefix, mostly chooses two instructions that can be linked. Otherwise it
 * often repeats the last instruction, to keep units and memory busy. */
static const c205_insn *draw_insn(uint64_t *random, const c205_insn *const *rows,
                                  size_t i)
{
    bool first = i > 0 && is_prefix(rows[i - 1]);
    bool second = i > 1 && is_prefix(rows[i - 2]);
    if ((first || second) && !one_in(random, 30))
        return draw_linked(random, first ? NULL : rows[i - 1]);
    if (one_in(random, 20))
        return draw_where(random, is_prefix);
    if (i > 0 && !is_prefix(rows[i - 1]) && one_in(random, 4))
        return rows[i - 1];
    return draw_of_unit(random, draw_unit(random));
}

static bool is_transfer(const c205_insn *insn)
{
    static const char *const names[] = { "VXTOV", "VTOVX", "VGATHP", "VSCATP" };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(insn->mnemonic, names[i]) == 0)
            return true;
    return false;
}

/* Like draw_insn, for programs of scalar instructions, which the machine translates to
 * blocks. Rarely chooses a vector instruction. */
static const c205_insn *draw_scalar(uint64_t *random, const c205_insn *const *rows,
                                    size_t i)
{
    const c205_insn *insn;
    if (i > 0 && one_in(random, 4))
        return rows[i - 1];
    do
        insn = draw_of_unit(random, draw_unit(random));
    while (c205_unit_is_vector(insn->unit) && !one_in(random, 60));
    return insn;
}

/* ---- Operands ---------------------------------------------------------- */

static bool is_field(const c205_insn *insn)
{
    return strcmp(insn->mnemonic, "INSB") == 0 || strcmp(insn->mnemonic, "EXTB") == 0;
}

/* Returns the role of registers written as i, by format and operand. */
static char integer_role(uint64_t *random, const c205_insn *insn, char field)
{
    switch (insn->format) {
    case C205_FORMAT_ALTER:
    case C205_FORMAT_ALTERB:
    case C205_FORMAT_ALTERF:
        return field == 'C'                                         ? 'k'
               : field == 'A' && insn->format == C205_FORMAT_ALTERB ? 'b'
                                                                    : 'i';
    case C205_FORMAT_MEMORY:
        return field != 'R' ? field == 'S' ? 'i' : 'n' : one_in(random, 3) ? 'w' : 'v';
    case C205_FORMAT_COMPARE: return 'k';
    case C205_FORMAT_CALL: return field == 'T' ? 'k' : 'i';
    case C205_FORMAT_SWAP: return field == 'S' ? 'n' : 's';
    case C205_FORMAT_JUMP: return '0';
    default:
        if (is_field(insn) && field == 'S')
            return 'f';
        return insn->unit == C205_UNIT_LOGICAL ? 'n' : 'i';
    }
}

static char vector_role(uint64_t *random, unsigned g, char role)
{
    char of_other_size = role == 'v' ? 'w' : 'v';
    if (g & C205_G_OFFSET)
        return role == 'v' ? 'p' : 'o';
    return one_in(random, role == 'v' ? 20 : 6) ? of_other_size : role;
}

/* Removes the offset of a sparse result, which has none. */
static unsigned result_bits(const c205_insn *insn, unsigned g)
{
    return insn->format == C205_FORMAT_SPARSE ? g & ~C205_G_OFFSET : g;
}

static char role_of(uint64_t *random, const c205_insn *insn, char field, unsigned g)
{
    char letter = reference_letter(insn, g, (char)toupper(field));
    bool number = (field == 'a' && g & C205_G_BROADCAST_A)
                  || (field == 'b' && g & C205_G_BROADCAST_B);
    unsigned sources = g & ~C205_G_OFFSET;
    switch (letter) {
    case 'v':
    case 'u': return number ? 'n' : vector_role(random, sources, 'v');
    case 'V':
    case 'U': return number ? 'h' : vector_role(random, sources, 'w');
    case 'l': return number ? 'i' : 'x';
    case 'x': return vector_role(random, sources, 'v');
    case 'X': return vector_role(random, sources, 'w');
    case 'c':
    case 'd':
    case 'q': return vector_role(random, result_bits(insn, g), 'v');
    case 'C':
    case 'D': return vector_role(random, result_bits(insn, g), 'w');
    case 'e':
    case 'o': return g & C205_G_OFFSET && field == 'C' ? 'q' : 'b';
    case 'b': return 'b';
    case 'z':
        return strstr(c205_format_syntax(insn->format), "!Z") || one_in(random, 3)
                   ? 'b'
                   : '0';
    case 'f':
    case 'p': return 'n';
    case 'F':
    case 'P': return 'h';
    case 'm': return one_in(random, 3) ? 'v' : 'i';
    case 'M': return 'j';
    case 'I':
        return insn->format == C205_FORMAT_MEMORY || one_in(random, 3) ? 'h' : 'j';
    case 'w': return strpbrk(insn->operands, "fvF") ? 'n' : 'i';
    case 'W': return insn->format == C205_FORMAT_I24 ? 'j' : 'h';
    default: return integer_role(random, insn, field);
    }
}

static unsigned draw_bits_of_g(uint64_t *random, const c205_insn *insn)
{
    unsigned legal = reference_bits_of_g(insn);
    if (one_in(random, 80))
        return (unsigned)random_bits(random) & 0xFF;
    unsigned size = one_in(random, 2) ? C205_G_HALF : 0;

    return (((unsigned)(random_bits(random) & random_bits(random)) & ~C205_G_HALF)
            | size)
           & legal;
}

/* Returns the distance from the branch to a random instruction, in half words. */
static int64_t distance(uint64_t *random, const struct random_program *program,
                        size_t i)
{
    return ((int64_t)draw_code_address(random, program)
            - (int64_t)program_address(program, i))
           / HALF;
}

static int64_t draw_immediate(uint64_t *random, const struct random_program *program,
                              const c205_insn *insn, size_t i)
{
    switch (insn->format) {
    case C205_FORMAT_INDEX:
    case C205_FORMAT_FLOAT: return distance(random, program, i);
    case C205_FORMAT_JUMP: return (int64_t)draw_code_address(random, program);
    case C205_FORMAT_ALTER:
    case C205_FORMAT_ALTERB:
    case C205_FORMAT_ALTERF: return random_between(random, 0, 15);
    case C205_FORMAT_REQUEST:
        return one_in(random, 8) ? random_between(random, 0, 255)
                                 : random_between(random, 1, 7);
    case C205_FORMAT_SHIFT: return random_between(random, -128, 127);
    case C205_FORMAT_I48:
        if (one_in(random, 2))
            return (int64_t)(draw_descriptor(random, 'v') << 16 >> 16);
        return draw_integer(random);
    case C205_FORMAT_I24:
        return one_in(random, 2) ? draw_integer(random)
                                 : (int64_t)random_bits(random) >> 40;
    default:
        return one_in(random, 3) ? WORD * random_between(random, -9, 9)
                                 : (int64_t)draw_length(random);
    }
}

/* Chooses the operands in the order of the syntax. A letter after + is an offset. */
static void draw_registers(uint64_t *random, const c205_insn *insn, c205_fields *fields)
{
    const char *syntax = c205_format_syntax(insn->format);
    for (const char *p = syntax; *p; p++) {
        int place = role_of_letter(*p);
        if (place < 0 || (p > syntax && p[-1] == '+'))
            continue;
        char role = role_of(random, insn, *p, fields->g);
        *field_of_role(fields, insn,
                       (enum role)place) = (uint8_t)(role == '0'
                                                         ? 0
                                                         : draw_register(random, role));
    }
}

/* Changes the result register. A sum is mostly in an even register. The index of an
 * extreme is sometimes in the register of its value. Another result is sometimes in the
 * register of its first source, or in an adjacent register. The vectors then start near
 * each other, and the result is a recurrence. */
static void draw_result(uint64_t *random, const c205_insn *insn, c205_fields *fields)
{
    char letter = reference_letter(insn, fields->g, 'C');
    if (letter && strchr("pP", letter) && !one_in(random, 15))
        fields->c &= (uint8_t)~1u;
    else if (insn->format == C205_FORMAT_EXTREME && one_in(random, 10))
        fields->c = letter == 'W' ? (uint8_t)(2u * fields->b) : fields->b;
    else if (letter && strchr("deD", letter) && one_in(random, 6))
        fields->c = (uint8_t)(fields->a + (unsigned)random_between(random, -1, 1));
}

static void draw_offsets(uint64_t *random, const c205_insn *insn, c205_fields *fields)
{
    if (strchr(c205_format_syntax(insn->format), '@')) {
        fields->y = (uint8_t)draw_register(random, 'k');
        fields->b = 0;
        return;
    }
    if (insn->format == C205_FORMAT_SPARSE)
        return;
    if (!(fields->g & C205_G_BROADCAST_A) && one_in(random, 4))
        fields->x = (uint8_t)draw_register(random, 'i');
    if (!(fields->g & C205_G_BROADCAST_B) && one_in(random, 4))
        fields->y = (uint8_t)draw_register(random, 'i');
}

static void put_insn(struct random_program *program, size_t i, const c205_insn *insn,
                     const c205_fields *fields)
{
    program->insns[i].word = c205_encode(insn, fields);
    program->insns[i].halves = c205_format_halves(insn->format);
}

/* Mostly gives the second instruction of a pair the operand size of the first. */
static unsigned size_of_pair(uint64_t *random, const struct random_program *program,
                             const c205_insn *const *rows, size_t i, unsigned g)
{
    if (i < 2 || !is_prefix(rows[i - 2]) || !may_link(rows[i - 1]) || !may_link(rows[i])
        || one_in(random, 20))
        return g;
    return (g & ~C205_G_HALF)
           | ((unsigned)(program->insns[i - 1].word >> 48) & C205_G_HALF);
}

static c205_fields draw_fields(uint64_t *random, const struct random_program *program,
                               const c205_insn *const *rows, size_t i)
{
    const c205_insn *insn = rows[i];
    c205_fields fields = { .f = insn->opcode };
    fields.g = (uint8_t)size_of_pair(random, program, rows, i,
                                     draw_bits_of_g(random, insn));
    draw_registers(random, insn, &fields);
    draw_result(random, insn, &fields);
    if (c205_format_halves(insn->format) == 2)
        draw_offsets(random, insn, &fields);
    if (fields.z == 0 && c205_unit_is_vector(insn->unit))
        fields.g &= (uint8_t)~C205_G_ZEROS;
    fields.immediate = draw_immediate(random, program, insn, i);
    return fields;
}

static void broadcast(uint64_t *random, c205_fields *fields, bool a)
{
    uint8_t number = (uint8_t)draw_register(random,
                                            fields->g & C205_G_HALF ? 'h' : 'n');
    fields->g |= a ? C205_G_BROADCAST_A : C205_G_BROADCAST_B;
    *(a ? &fields->a : &fields->b) = number;
    *(a ? &fields->x : &fields->y) = 0;
}

static bool has_b(const c205_insn *insn)
{
    return reference_bits_of_g(insn) & C205_G_BROADCAST_B;
}

/* Broadcasts one source that is neither linked nor needed as a vector. It is a source
 * of the first instruction, or the other source of the second instruction. Memory then
 * supplies at most two sources. */
static void spare_a_stream(uint64_t *random, const c205_insn *const *rows,
                           c205_fields *first, c205_fields *second, bool a)
{
    if (has_b(rows[0]) && (!has_b(rows[1]) || !one_in(random, 3)))
        broadcast(random, first, one_in(random, 4));
    else if (has_b(rows[1]))
        broadcast(random, second, !a);
}

/* Mostly makes the second instruction of a pair read the result of the first. */
static void link_fields(uint64_t *random, const c205_insn *const *rows,
                        c205_fields *first, c205_fields *second)
{
    bool a = !has_b(rows[1]) || one_in(random, 2);
    if (!one_in(random, 20)) {
        first->z = 0;
        first->g &= (uint8_t) ~(C205_G_OFFSET | C205_G_ZEROS);
    }
    second->g &= (uint8_t) ~(a ? C205_G_BROADCAST_A : C205_G_BROADCAST_B);
    if (!one_in(random, 20))
        *(a ? &second->a : &second->b) = first->c;
    if (!one_in(random, 3))
        second->c = first->c; /* has the same length */
    if (!one_in(random, 20))
        spare_a_stream(random, rows, first, second, a);
    if (has_b(rows[1]) && one_in(random, 12))
        second->a = second->b = first->c;
    if (!one_in(random, 8))
        *(a ? &second->x : &second->y) = 0;
}

static void link_pairs(uint64_t *random, struct random_program *program,
                       const c205_insn *const *rows)
{
    for (size_t i = 0; i + 2 < program->insn_count; i++) {
        c205_fields first, second;
        if (!is_prefix(rows[i]) || !may_link(rows[i + 1]) || !may_link(rows[i + 2]))
            continue;
        first = c205_decode(rows[i + 1], program->insns[i + 1].word);
        second = c205_decode(rows[i + 2], program->insns[i + 2].word);
        link_fields(random, rows + i + 1, &first, &second);
        put_insn(program, i + 1, rows[i + 1], &first);
        put_insn(program, i + 2, rows[i + 2], &second);
    }
}

/* Ends the loop with a branch back. The branch has its own registers. */
static void close_loop(struct random_program *program)
{
    const c205_insn *insn = c205_insn_named("DBNZ", 4);
    c205_fields fields = { .f = insn->opcode, .r = LOOP_COUNT, .t = LOOP_BEGIN };
    put_insn(program, program->insn_count - 2, insn, &fields);
}

/* Puts a scatter to the program's own code into the second half of the loop. */
static void rewrite_in_loop(uint64_t *random, struct random_program *program,
                            const c205_insn **rows)
{
    const c205_insn *insn = c205_insn_named("VTOVX", 5);
    c205_fields fields = {
        .f = insn->opcode, .a = REWRITE_LIST, .b = REWRITE_FROM, .c = REWRITE_TABLE
    };
    int64_t count = (int64_t)program->insn_count;
    size_t i = (size_t)random_between(random, count / 2 - 1, count - 3);
    rows[i] = insn;
    put_insn(program, i, insn, &fields);
}

void draw_insns(uint64_t *random, struct random_program *program)
{
    const c205_insn *rows[PROGRAM_INSNS];
    size_t count = program->insn_count;
    for (size_t i = 0; i + 1 < count; i++) {
        rows[i] = program->transfers && one_in(random, 2)
                      ? draw_where(random, is_transfer)
                  : program->loop ? draw_scalar(random, rows, i)
                                  : draw_insn(random, rows, i);
        program->insns[i].halves = c205_format_halves(rows[i]->format);
    }
    if (program->loop) {
        rows[count - 2] = c205_insn_named("DBNZ", 4);
        program->insns[count - 2].halves = 1;
    }
    rows[count - 1] = c205_insn_named("EXIT", 4);
    program->insns[count - 1].halves = 1;
    for (size_t i = 0; i < count; i++) {
        c205_fields fields = draw_fields(random, program, rows, i);
        if (i == count - 1)
            fields.immediate = 0;
        put_insn(program, i, rows[i], &fields);
        if (one_in(random, 200))
            program->insns[i].word ^= UINT64_C(1) << random_between(random, 32, 63);
    }
    link_pairs(random, program, rows);
    if (program->rewrites)
        rewrite_in_loop(random, program, rows);
    if (program->loop)
        close_loop(program);
}
