/* measure.c - measures the clocks of vector instructions at many lengths and fits a
 * line. */
#include "asm/measure/measure.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "asm/measure/straight_line.h"
#include "asm/object/syntax.h"
#include "asm/text/assemble.h"
#include "vm/error.h"

const char measure_triad[] = "TRIAD";

static const size_t lengths[MEASURE_POINTS] = {
    0,   1,   2,    5,    10,   20,    50,    100,   200,
    300, 500, 1000, 2000, 5000, 10000, 20000, 50000, C205_MAX_LENGTH,
};

/* The operands of the program. Each operand has a page. */
enum operand_place { A, B, C, Z, OPERANDS };
enum { FIRST_REGISTER = 16, SCALAR = 32, LOADED = 33, FIRST_PAGE = 64 };
enum { TEXT_SIZE = 256 };
#define PAGE_BITS ((uint64_t)C205_PAGE_WORDS * 64)

static uint64_t address_of(enum operand_place operand)
{
    return (FIRST_PAGE + (uint64_t)operand) * PAGE_BITS;
}

/* Returns the register of an operand. Every second register is used, because C+1 is
 * also a result of some instructions. */
static unsigned register_of(enum operand_place operand)
{
    return FIRST_REGISTER + 2u * (unsigned)operand;
}

/* ---- The program ---------------------------------------------------- */

/* The instruction to measure, or NULL for the triad, and the size of its operands. */
struct subject {
    const c205_insn *insn;
    bool half;
};

static bool same(const char *name, size_t length, const char *text)
{
    bool good = length == strlen(text);
    for (size_t i = 0; good && i < length; i++)
        good = toupper((unsigned char)name[i]) == text[i];
    return good;
}

static bool take_suffix(const char *name, size_t *length)
{
    size_t suffix = strlen(SYNTAX_HALF);
    if (*length < suffix || !same(name + *length - suffix, suffix, SYNTAX_HALF))
        return false;
    *length -= suffix;
    return true;
}

static bool find_subject(const char *name, struct subject *subject)
{
    size_t length = strlen(name);
    const c205_insn *insn;
    subject->half = take_suffix(name, &length);
    subject->insn = insn = c205_insn_named(name, length);
    if (!insn)
        return same(name, length, measure_triad);
    return c205_timing_is_vector(insn->timing) && insn->timing != C205_TIMING_vlink
           && (!subject->half || (insn->flags & C205_INSN_HALF));
}

bool measure_knows(const char *name)
{
    struct subject subject;
    return find_subject(name, &subject);
}

/* Returns the operand for a letter. R is the first and T the last operand of a short
 * instruction. */
static enum operand_place operand_of(char letter)
{
    switch (toupper((unsigned char)letter)) {
    case 'A':
    case 'R': return A;
    case 'B': return B;
    case 'Z': return Z;
    default: return C;
    }
}

/* Returns true if the field is a half register. */
static bool is_half(const struct subject *subject, char field)
{
    struct operand operands[MAX_OPERANDS];
    size_t count = syntax_operands(subject->insn, subject->half, operands);
    bool half = false;
    for (size_t i = 0; i < count; i++)
        half = half || (operands[i].field == field && operands[i].half);
    return half;
}

/* Writes the operand for a letter of the syntax. "a" and "[A]" are vectors. A or B
 * outside of brackets is a scalar. Half register 2n is the left half of register n. */
static int write_letter(const struct subject *subject, char letter, bool in_brackets,
                        char *text, size_t size)
{
    unsigned number = register_of(operand_of(letter));
    if (islower((unsigned char)letter))
        return snprintf(text, size, "[r%u]", number);
    if (!in_brackets && (letter == 'A' || letter == 'B'))
        number = SCALAR;
    return !in_brackets && is_half(subject, letter)
               ? snprintf(text, size, "h%u", 2 * number)
               : snprintf(text, size, "r%u", number);
}

/* Replaces the letters of the syntax in insn.def by registers. Offsets and an optional
 * control vector are omitted. */
static void write_operands(const struct subject *subject, char *text, size_t size)
{
    const char *syntax = c205_format_syntax(subject->insn->format);
    size_t used = 0;
    for (const char *at = syntax; *at && *at != '?'; at++) {
        int length = 0;
        if (*at == '+') {
            at++;
        } else if (*at == '!') {
            length = snprintf(text + used, size - used, "? [r%u]", register_of(Z));
            at++;
        } else if (isalpha((unsigned char)*at)) {
            length = write_letter(subject, *at, at > syntax && at[-1] == '[',
                                  text + used, size - used);
        } else {
            length = snprintf(text + used, size - used, "%c", *at);
        }
        used += (size_t)length;
    }
}

static int write_triad(bool half, char *text)
{
    const char *suffix = half ? SYNTAX_HALF : "";
    unsigned a = register_of(A), b = register_of(B), c = register_of(C);
    return snprintf(text, TEXT_SIZE,
                    "\tLINKV\n\tMPYSV%s [r%u], %c%d, [r%u]\n"
                    "\tADDNV%s [r%u], [r%u], [r%u]\n",
                    suffix, a, half ? 'h' : 'r', half ? 2 * SCALAR : SCALAR, c, suffix,
                    c, b, c);
}

/* Writes the program. The load at its end waits for the vector unit. Otherwise its last
 * instruction would overlap the measured instruction. */
static void write_program(const struct subject *subject, char text[TEXT_SIZE])
{
    char operands[TEXT_SIZE / 2] = "";
    int length;
    if (subject->insn) {
        write_operands(subject, operands, sizeof operands);
        length = snprintf(text, TEXT_SIZE, "\t%s%s %s\n", subject->insn->mnemonic,
                          subject->half ? SYNTAX_HALF : "", operands);
    } else {
        length = write_triad(subject->half, text);
    }
    snprintf(text + length, TEXT_SIZE - (size_t)length,
             "last:\tLOD [r%u], r%d\n\tEXIT\n", register_of(A), LOADED);
}

/* ---- The operands ---------------------------------------------------- */

/* Generates operands by xorshift64 from a fixed seed, so they are the same in every
 * run. */
static uint64_t next_bits(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

/* Returns a word with one number of 64 bits or two numbers of 32 bits. They are
 * normalised and between 1 and 2. */
static c205_word next_numbers(uint64_t *state, bool half)
{
    enum { HALF_BITS = 32 };
    uint64_t bits = next_bits(state);
    return half ? (C205_HALF_ONE | C205_HALF_ONE >> HALF_BITS)
                      | (bits & UINT64_C(0x003FFFFF003FFFFF))
                : C205_ONE | bits >> 18;
}

/* Returns a random index in a table with the length of a page. */
static c205_word next_index(uint64_t *state)
{
    return c205_from_integer((int64_t)(next_bits(state) >> 18) % C205_PAGE_WORDS);
}

static c205_word next_word(const struct subject *subject, enum operand_place operand,
                           uint64_t *state)
{
    const c205_insn *insn = subject->insn;
    bool indexed = insn
                   && (insn->format == C205_FORMAT_TABLE
                       || insn->format == C205_FORMAT_SPREAD);
    if (operand == Z)
        return next_bits(state);
    return indexed && operand == A ? next_index(state)
                                   : next_numbers(state, subject->half);
}

static bool fill_operands(c205 *machine, const struct subject *subject,
                          c205_error *error)
{
    enum { PIECE = 1024 };
    uint64_t state = UINT64_C(0x9E3779B97F4A7C15);
    c205_word words[PIECE];
    for (int operand = A; operand < OPERANDS; operand++) {
        uint64_t address = address_of((enum operand_place)operand);
        if (!c205_map(machine, address, C205_PAGE_WORDS, C205_READ_WRITE, error))
            return false;
        for (size_t at = 0; at < C205_PAGE_WORDS; at += PIECE) {
            for (size_t i = 0; i < PIECE; i++)
                words[i] = next_word(subject, (enum operand_place)operand, &state);
            c205_write(machine, address + at * 64, words, PIECE);
        }
    }
    return true;
}

/* ---- The runs -------------------------------------------------------- */

/* A machine whose operands are set. one_step gives B a single element, for instructions
 * that combine each element of A with all of B; otherwise B is as long as A. scalar is
 * the number one (left-aligned if it is a half word), or the period of a gather or
 * scatter. */
struct rig {
    c205 *machine;
    bool one_step;
    c205_word scalar;
};

static bool run_once(const struct rig *rig, uint64_t entry, size_t length,
                     c205_error *error)
{
    c205 *machine = rig->machine;
    for (int operand = A; operand < OPERANDS; operand++) {
        size_t own = operand == B && rig->one_step ? 1 : length;
        c205_set_register(machine, register_of((enum operand_place)operand),
                          (c205_word)own << 48
                              | address_of((enum operand_place)operand));
    }
    c205_set_register(machine, SCALAR, rig->scalar);
    c205_set_pc(machine, entry);
    c205_reset_clock(machine);
    c205_stop stop = c205_run(machine, C205_NO_LIMIT);
    if (stop.trap != C205_TRAP_NONE) {
        c205_describe_stop(machine, &stop, error);
        return false;
    }
    return true;
}

/* Measures the clocks of a run. The program runs twice and the second run counts,
 * because all pages are then resident. */
static bool measure_clocks(const struct rig *rig, uint64_t entry, size_t length,
                           uint64_t *clocks, c205_error *error)
{
    bool good = run_once(rig, entry, length, error)
                && run_once(rig, entry, length, error);
    *clocks = c205_clock(rig->machine);
    return good;
}

static uint64_t operations_of(const c205 *machine)
{
    uint64_t operations = 0;
    for (size_t i = 0; i < c205_account_count(machine); i++)
        operations += c205_account_at(machine, i)->operations;
    return operations;
}

/* Measures all points. The number of flops is taken from the last point, which is the
 * longest. */
static bool measure_points(const struct rig *rig, uint64_t entry, uint64_t last,
                           struct measurement *result, c205_error *error)
{
    for (size_t i = 0; i < MEASURE_POINTS; i++) {
        uint64_t whole, empty, operations;
        if (!measure_clocks(rig, entry, lengths[i], &whole, error))
            return false;
        operations = operations_of(rig->machine);
        if (!measure_clocks(rig, last, lengths[i], &empty, error))
            return false;
        result->flops = (double)operations / (double)lengths[i];
        result->points[i].length = lengths[i];
        result->points[i].clocks = whole - empty;
    }
    return true;
}

/* Fits a line to the clocks of the points. The point with length 0 is ignored, because
 * an empty vector has no stream, so its clocks need not be on the line. */
static void fit_line(struct measurement *result)
{
    struct weighted_point points[MEASURE_POINTS];
    for (size_t i = 0; i < MEASURE_POINTS; i++) {
        points[i].x = (double)result->points[i].length;
        points[i].y = (double)result->points[i].clocks;
        points[i].weight = result->points[i].length > 0 ? 1 : 0;
    }
    struct straight_line line = straight_line_through(points, MEASURE_POINTS);
    result->per_element = line.slope;
    result->startup = line.at_zero;
    result->deviation = 0;
    for (size_t i = 0; i < MEASURE_POINTS; i++) {
        double off = fabs(points[i].y - straight_line_at(&line, points[i].x));
        result->deviation = fmax(result->deviation, points[i].weight * off);
    }
}

static c205_word one_for(const struct subject *subject)
{
    bool period = subject->insn
                  && (subject->insn->format == C205_FORMAT_PERIODIC
                      || subject->insn->format == C205_FORMAT_SPACED);
    return period ? c205_from_integer(1) : subject->half ? C205_HALF_ONE : C205_ONE;
}

static bool measure_object(const c205_model *model, const struct object *object,
                           const struct subject *subject, struct measurement *result,
                           c205_error *error)
{
    const struct asm_symbol *last = object_symbol(object, "last");
    c205 *machine = c205_new(model, error);
    struct rig rig = { machine,
                       subject->insn && subject->insn->format == C205_FORMAT_SCAN,
                       one_for(subject) };
    bool good = machine && c205_load(machine, &object->program, error)
                && fill_operands(machine, subject, error)
                && measure_points(&rig, object->program.entry, (uint64_t)last->value,
                                  result, error);
    c205_free(machine);
    return good;
}

bool measure(const c205_model *model, const char *name, struct measurement *result,
             c205_error *error)
{
    struct subject subject = { NULL, false };
    struct diagnostics errors = { 0 };
    char text[TEXT_SIZE];
    find_subject(name, &subject);
    write_program(&subject, text);
    struct object *object = assemble_text(name, text, NULL, &errors);
    c205_timing timing = subject.insn ? subject.insn->timing : C205_TIMING_vlink;
    snprintf(result->name, sizeof result->name, "%s%s",
             subject.insn ? subject.insn->mnemonic : measure_triad,
             subject.half ? SYNTAX_HALF : "");
    result->timing = c205_timing_name(timing);
    bool good = object && measure_object(model, object, &subject, result, error);
    if (good) {
        fit_line(result);
    } else if (!object) {
        error_set(error, "%s: %.200s", name,
                  errors.count ? errors.items[0].message : "out of memory");
    }
    diagnostics_free(&errors);
    object_free(object);
    return good;
}

double measure_rate(const struct measurement *measurement, const c205_model *model)
{
    const c205_constant *period = c205_model_lookup(model, "clock.period");
    double results = measurement->flops > 0 ? measurement->flops : 1;
    return period ? 1000 * results / (measurement->per_element * period->value) : NAN;
}

double measure_half_length(const struct measurement *measurement)
{
    return measurement->startup / measurement->per_element;
}
