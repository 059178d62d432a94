/* measure.c - see measure.h. */
#include "asm/measure.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "asm/assemble.h"

const char measure_triad[] = "TRIAD";

static const size_t lengths[MEASURE_POINTS] = {
    0,   1,   2,    5,    10,   20,    50,    100,   200,
    300, 500, 1000, 2000, 5000, 10000, 20000, 50000, C205_MAX_LENGTH,
};

/* Floating operations of one element of each class that has any. */
static const unsigned flops_of[C205_TIMINGS] = {
    [C205_TIMING_vadd] = 1,    [C205_TIMING_vmultiply] = 1,
    [C205_TIMING_vdivide] = 1, [C205_TIMING_vsqrt] = 1,
    [C205_TIMING_vsum] = 1,    [C205_TIMING_vproduct] = 1,
    [C205_TIMING_vdot] = 2,    [C205_TIMING_vlink] = 2,
};

/* The operands of every program, each in a page of its own. */
enum operand { A, B, C, Z, OPERANDS };
enum { FIRST_REGISTER = 16, SCALAR = 32, LOADED = 33, FIRST_PAGE = 64 };
enum { TEXT_SIZE = 256 };
#define PAGE_BITS ((uint64_t)C205_PAGE_WORDS * 64)

static uint64_t address_of(enum operand operand)
{
    return (FIRST_PAGE + (uint64_t)operand) * PAGE_BITS;
}

/* C+1 is a result of some instructions, so registers go in twos. */
static unsigned register_of(enum operand operand)
{
    return FIRST_REGISTER + 2u * (unsigned)operand;
}

/* ---- The program ---------------------------------------------------- */

static const c205_insn *instruction(const char *name, size_t length)
{
    const c205_insn *insn = c205_insn_named(name, length);
    bool vector = insn && c205_timing_is_vector(insn->timing);
    return vector && insn->timing != C205_TIMING_vlink ? insn : NULL;
}

static bool is_triad(const char *name, size_t length)
{
    bool same = length == strlen(measure_triad);
    for (size_t i = 0; same && i < length; i++) {
        same = toupper((unsigned char)name[i]) == measure_triad[i];
    }
    return same;
}

bool measure_knows(const char *name, size_t length)
{
    return is_triad(name, length) || instruction(name, length);
}

/* R and T are the first and the last operand of a short instruction. */
static enum operand operand_of(char letter)
{
    switch (toupper((unsigned char)letter)) {
    case 'A': case 'R': return A;
    case 'B': return B;
    case 'Z': return Z;
    default: return C;
    }
}

/* A letter of the syntax: "a" and "[A]" are vectors, a source outside
 * brackets is the scalar. */
static int write_letter(char letter, bool in_brackets, char *text,
                        size_t size)
{
    unsigned number = register_of(operand_of(letter));
    if (!in_brackets && (letter == 'A' || letter == 'B')) {
        number = SCALAR;
    }
    return snprintf(text, size,
                    islower((unsigned char)letter) ? "[r%u]" : "r%u",
                    number);
}

/* The syntax of insn.def with registers for its letters; offsets and an
 * optional control vector are left out. */
static void write_operands(const char *syntax, char *text, size_t size)
{
    size_t used = 0;
    for (const char *at = syntax; *at && *at != '?'; at++) {
        int length = 0;
        if (*at == '+') {
            at++;
        } else if (*at == '!') {
            length = snprintf(text + used, size - used, "? [r%u]",
                              register_of(Z));
            at++;
        } else if (isalpha((unsigned char)*at)) {
            length = write_letter(*at, at > syntax && at[-1] == '[',
                                  text + used, size - used);
        } else {
            length = snprintf(text + used, size - used, "%c", *at);
        }
        used += (size_t)length;
    }
}

/* The load waits until the vector unit is done, so that nothing of the end
 * hides under the instruction. */
static void write_program(const c205_insn *insn, char text[TEXT_SIZE])
{
    char operands[TEXT_SIZE / 2] = "";
    unsigned a = register_of(A), b = register_of(B), c = register_of(C);
    int length;
    if (insn) {
        write_operands(c205_format_syntax(insn->format), operands,
                       sizeof operands);
        length = snprintf(text, TEXT_SIZE, "\t%s %s\n", insn->mnemonic,
                          operands);
    } else {
        length = snprintf(text, TEXT_SIZE,
                          "\tLINKV\n\tMPYSV [r%u], r%d, [r%u]\n"
                          "\tADDNV [r%u], [r%u], [r%u]\n",
                          a, SCALAR, c, c, b, c);
    }
    snprintf(text + length, TEXT_SIZE - (size_t)length,
             "last:\tLOD [r%u], r%d\n\tEXIT\n", a, LOADED);
}

/* ---- The operands ---------------------------------------------------- */

/* Numbers for operands; the sequence is xorshift64 and always the same. */
static uint64_t next_bits(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

/* Normalised numbers from 1 to 2; or indices of a table of one page. */
static c205_word next_word(uint64_t *state, bool index)
{
    uint64_t bits = next_bits(state) >> 18;
    return index ? c205_from_integer((int64_t)(bits % C205_PAGE_WORDS))
                 : C205_ONE | bits;
}

static bool fill(c205 *machine, const c205_insn *insn, c205_error *error)
{
    enum { PIECE = 1024 };
    uint64_t state = UINT64_C(0x9E3779B97F4A7C15);
    c205_word words[PIECE];
    bool indexed = insn && (insn->format == C205_FORMAT_TABLE
                            || insn->format == C205_FORMAT_SPREAD);
    for (int operand = A; operand < OPERANDS; operand++) {
        uint64_t address = address_of((enum operand)operand);
        if (!c205_map(machine, address, C205_PAGE_WORDS, C205_READ_WRITE,
                      error)) {
            return false;
        }
        for (size_t at = 0; at < C205_PAGE_WORDS; at += PIECE) {
            for (size_t i = 0; i < PIECE; i++) {
                words[i] = operand == Z ? next_bits(&state)
                           : next_word(&state, indexed && operand == A);
            }
            c205_write(machine, address + at * 64, words, PIECE);
        }
    }
    return true;
}

/* ---- The runs -------------------------------------------------------- */

/* A machine with operands.  An instruction that goes through B once for each
 * element of A gets a B of one element, so that its rate is that of one step. */
struct rig {
    c205 *machine;
    bool one_step;
};

static bool run_once(const struct rig *rig, uint64_t entry, size_t length,
                     c205_error *error)
{
    c205 *machine = rig->machine;
    for (int operand = A; operand < OPERANDS; operand++) {
        size_t own = operand == B && rig->one_step ? 1 : length;
        c205_set_register(machine, register_of((enum operand)operand),
                          (c205_word)own << 48
                              | address_of((enum operand)operand));
    }
    c205_set_register(machine, SCALAR, C205_ONE);
    c205_set_pc(machine, entry);
    c205_reset_clock(machine);
    c205_stop stop = c205_run(machine, C205_NO_LIMIT);
    if (stop.trap != C205_TRAP_NONE) {
        c205_describe_stop(machine, &stop, error);
        return false;
    }
    return true;
}

/* The clock of the second run. */
static bool clocks_of(const struct rig *rig, uint64_t entry, size_t length,
                      uint64_t *clocks, c205_error *error)
{
    bool good = run_once(rig, entry, length, error)
                && run_once(rig, entry, length, error);
    *clocks = c205_clock(rig->machine);
    return good;
}

static bool measure_points(const struct rig *rig, uint64_t entry,
                           uint64_t last, struct measurement *result,
                           c205_error *error)
{
    for (size_t i = 0; i < MEASURE_POINTS; i++) {
        uint64_t whole, empty;
        if (!clocks_of(rig, entry, lengths[i], &whole, error)
            || !clocks_of(rig, last, lengths[i], &empty, error)) {
            return false;
        }
        result->points[i].length = lengths[i];
        result->points[i].clocks = whole - empty;
    }
    return true;
}

/* Least squares; the empty vector is left out, as it makes no stream. */
static void fit_line(struct measurement *result)
{
    double count = 0, n = 0, t = 0, nn = 0, nt = 0;
    for (size_t i = 0; i < MEASURE_POINTS; i++) {
        double x = (double)result->points[i].length;
        double y = (double)result->points[i].clocks;
        double weight = x > 0 ? 1.0 : 0.0;
        count += weight;
        n += weight * x;
        t += weight * y;
        nn += weight * x * x;
        nt += weight * x * y;
    }
    result->per_element = (count * nt - n * t) / (count * nn - n * n);
    result->startup = (t - result->per_element * n) / count;
    result->deviation = 0;
    for (size_t i = 1; i < MEASURE_POINTS; i++) {
        double line = result->startup
                      + result->per_element
                            * (double)result->points[i].length;
        double off = fabs((double)result->points[i].clocks - line);
        result->deviation = fmax(result->deviation, off);
    }
}

static bool measure_object(const c205_model *model,
                           const struct object *object,
                           const c205_insn *insn,
                           struct measurement *result, c205_error *error)
{
    const struct asm_symbol *last = object_symbol(object, "last");
    c205 *machine = c205_new(model, error);
    struct rig rig = { machine, insn && insn->format == C205_FORMAT_SCAN };
    bool good = machine && c205_load(machine, &object->program, error)
                && fill(machine, insn, error)
                && measure_points(&rig, object->program.entry,
                                  (uint64_t)last->value, result, error);
    c205_free(machine);
    return good;
}

bool measure(const c205_model *model, const char *name,
             struct measurement *result, c205_error *error)
{
    const c205_insn *insn = instruction(name, strlen(name));
    c205_timing timing = insn ? insn->timing : C205_TIMING_vlink;
    struct asm_errors errors = { 0, NULL };
    char text[TEXT_SIZE];
    write_program(insn, text);
    struct object *object = assemble_text(name, text, NULL, &errors);
    result->name = insn ? insn->mnemonic : measure_triad;
    result->timing = c205_timing_name(timing);
    result->flops = flops_of[timing];
    bool good = object
                && measure_object(model, object, insn, result, error);
    if (good) {
        fit_line(result);
    } else if (!object) {
        snprintf(error->message, sizeof error->message, "%s: %.200s", name,
                 errors.count ? errors.items[0].message : "no memory");
    }
    asm_errors_free(&errors);
    object_free(object);
    return good;
}

double measure_rate(const struct measurement *measurement,
                    const c205_model *model)
{
    const c205_constant *period = c205_model_lookup(model, "clock.period");
    unsigned results = measurement->flops ? measurement->flops : 1;
    return period ? 1000.0 * results
                        / (measurement->per_element * period->value)
                  : NAN;
}

double measure_half_length(const struct measurement *measurement)
{
    return measurement->startup / measurement->per_element;
}
