/* value.c - parses and evaluates the expressions of the debugger.
 *
 *   integers, X'hex', numbers with a point or an exponent, ( )
 *   r10 h21 NAME      registers, as numbers; a word with exponent 0 is an integer;
 *                     NAME.i: the low 48 bits as an integer; NAME.length
 *   label             its bit address; a constant: its value
 *   [ADDRESS]         the word there; [ADDRESS].i
 *   pc clock step flags    also $pc .., if the program itself has such a name
 *   the operators of the assembler, - ~ ! and binary ones (asm/text/operators.h)
 */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/debug/debug_internal.h"
#include "asm/text/operators.h"
#include "asm/view/operand_view.h"
#include "base/visible_text.h"
#include "vm/error.h"

enum { MAX_DEPTH = 100, HALF_DIGITS = 8 };

bool debug_fault(struct debugger *debugger, const char *format, ...)
{
    char text[512];
    unsigned long code;
    PRINTF_TEXT(text, format);
    line_tracker_close(&debugger->printed);
    sink_print(&debugger->out, "error: %s", text);
    if (invisible_find(text, &code)) {
        sink_put(&debugger->out, " (");
        invisible_name(&debugger->out, code);
        sink_put(&debugger->out, ")");
    }
    sink_put(&debugger->out, "\n");
    debugger->faults++;
    return false;
}

/* ---- Words ---------------------------------------------------------------- */

void text_cursor_skip(struct text_cursor *cursor)
{
    while (isspace((unsigned char)*cursor->at))
        cursor->at++;
}

bool text_cursor_end(struct text_cursor *cursor)
{
    text_cursor_skip(cursor);
    return *cursor->at == '\0';
}

static bool is_name(char c)
{
    return isalnum((unsigned char)c) || c == '_' || c == '.' || c == '$';
}

static size_t name_length(const char *text)
{
    size_t length = 0;
    while (is_name(text[length]))
        length++;
    return length;
}

bool text_cursor_begin(struct text_cursor *cursor, const char *word)
{
    size_t length;
    text_cursor_skip(cursor);
    length = name_length(cursor->at);
    if (length == 0 || strncmp(cursor->at, word, length) != 0)
        return false;
    cursor->at += length;
    text_cursor_skip(cursor);
    return true;
}

bool text_cursor_take(struct text_cursor *cursor, const char *word)
{
    text_cursor_skip(cursor);
    return name_length(cursor->at) == strlen(word) && text_cursor_begin(cursor, word);
}

bool text_cursor_sign(struct text_cursor *cursor, const char *sign)
{
    size_t length = strlen(sign);
    text_cursor_skip(cursor);
    if (strncmp(cursor->at, sign, length) != 0)
        return false;
    cursor->at += length;
    return true;
}

void text_cursor_text(const char *from, const struct text_cursor *cursor,
                      char text[MAX_TEXT])
{
    size_t length = (size_t)(cursor->at - from);
    while (length > 0 && isspace((unsigned char)from[length - 1]))
        length--;
    snprintf(text, MAX_TEXT, "%.*s", (int)length, from);
}

bool text_cursor_finish(struct debugger *debugger, struct text_cursor *cursor)
{
    return text_cursor_end(cursor)
           || debug_fault(debugger, "expected the end of the line, found '%.60s'",
                          cursor->at);
}

/* ---- Values --------------------------------------------------------------- */

struct reading {
    struct debugger *debugger;
    struct text_cursor *cursor;
    bool grammar; /* check only the syntax; registers and memory are not read */
    unsigned depth;
};

static struct value_of of_integer(int64_t integer)
{
    return (struct value_of){ .integer = integer, .real = (double)integer };
}

static struct value_of of_real(double real)
{
    return (struct value_of){ .is_real = true, .real = real };
}

static struct value_of of_word(c205_word word)
{
    return (struct value_of){ .is_real = word >> 48 != 0,
                              .is_word = true,
                              .integer = c205_to_integer(word),
                              .real = c205_to_double(word),
                              .word = word };
}

static struct value_of of_half(c205_word half)
{
    return (struct value_of){ .is_real = true,
                              .is_word = true,
                              .is_half = true,
                              .real = c205_half_to_double(half),
                              .word = half };
}

/* Returns true if a number fits in 48 bits. */
static bool is_integer_word(int64_t integer)
{
    return integer >= -(INT64_C(1) << 47) && integer < INT64_C(1) << 47;
}

static c205_word make_word(const struct value_of *value)
{
    if (value->is_word && !value->is_half)
        return value->word;
    return value->is_real ? c205_from_double(value->real)
                          : c205_from_integer(value->integer);
}

bool debug_word(struct debugger *debugger, const struct value_of *value, bool half,
                c205_word *word)
{
    if (!value->is_word && value->is_real && !isfinite(value->real))
        return debug_fault(debugger,
                           "%g cannot be represented as a number of the machine",
                           value->real);
    if (!value->is_real && !is_integer_word(value->integer))
        return debug_fault(debugger, "%lld does not fit in the 48 bits of an integer",
                           (long long)value->integer);
    if (half)
        *word = value->is_half ? value->word : c205_half_from_double(value->real);
    else
        *word = make_word(value);
    return true;
}

bool debug_is_true(const struct value_of *value)
{
    return value->real != 0;
}

static bool read_any(struct reading *reading, struct value_of *value);

/* ---- Names ---------------------------------------------------------------- */

/* Finds the register with a name. If several registers have it, the last one counts. */
static const struct asm_register *find_register(const struct debugger *debugger,
                                                const char *name, size_t length)
{
    const struct object *object = debugger->setup.object;
    for (size_t i = object->register_count; i-- > 0;)
        if (strlen(object->registers[i].name) == length
            && strncmp(object->registers[i].name, name, length) == 0)
            return &object->registers[i];
    return NULL;
}

static bool is_numbered(const char *name, size_t length, struct register_of *named)
{
    char *end;
    unsigned long number;
    if (length < 2 || length > 4 || (*name != 'r' && *name != 'h')
        || !isdigit((unsigned char)name[1]))
        return false;
    number = strtoul(name + 1, &end, 10);
    if (end != name + length || number >= C205_REGISTERS)
        return false;
    *named = (struct register_of){ (uint8_t)number, *name == 'h' };
    return true;
}

static bool find_named(const struct debugger *debugger, const char *name, size_t length,
                       struct register_of *named)
{
    const struct asm_register *known = find_register(debugger, name, length);
    if (known)
        *named = (struct register_of){ known->number, known->half };
    return known || is_numbered(name, length, named);
}

/* Returns the length of a name without ".i" or ".length". */
static size_t base_length(const char *text)
{
    size_t length = name_length(text);
    if (length > 2 && strncmp(text + length - 2, ".i", 2) == 0)
        return length - 2;
    if (length > 7 && strncmp(text + length - 7, ".length", 7) == 0)
        return length - 7;
    return length;
}

bool debug_register(const struct debugger *debugger, struct text_cursor *cursor,
                    struct register_of *named)
{
    size_t length;
    text_cursor_skip(cursor);
    length = name_length(cursor->at);
    if (!find_named(debugger, cursor->at, length, named))
        return false;
    cursor->at += length;
    return true;
}

c205_word debug_register_word(const struct debugger *debugger, struct register_of named)
{
    return view_register(machine_of(debugger), named.number, named.half);
}

/* Reads a part: ".i" is the low 48 bits as an integer, ".length" the high 16 bits. */
static void take_part(struct reading *reading, struct value_of *value)
{
    if (text_cursor_sign(reading->cursor, ".length"))
        *value = of_integer((int64_t)c205_descriptor_length(value->word));
    else if (text_cursor_sign(reading->cursor, ".i"))
        *value = of_integer(value->integer);
}

static struct value_of of_register(const struct debugger *debugger,
                                   struct register_of named)
{
    c205_word word = debug_register_word(debugger, named);
    return named.half ? of_half(word) : of_word(word);
}

static bool read_special(const struct debugger *debugger, const char *name,
                         size_t length, struct value_of *value)
{
    c205 *machine = machine_of(debugger);
    if (*name == '$') {
        name++;
        length--;
    }
    if (length == 2 && strncmp(name, "pc", 2) == 0)
        *value = of_integer((int64_t)c205_pc(machine));
    else if (length == 5 && strncmp(name, "clock", 5) == 0)
        *value = of_integer((int64_t)c205_clock(machine));
    else if (length == 4 && strncmp(name, "step", 4) == 0)
        *value = of_integer((int64_t)step_of(debugger));
    else if (length == 5 && strncmp(name, "flags", 5) == 0)
        *value = of_word(c205_data_flags(machine));
    else
        return false;
    return true;
}

static bool read_symbol(const struct debugger *debugger, const char *name,
                        size_t length, struct value_of *value)
{
    char text[MAX_TEXT];
    const struct asm_symbol *symbol;
    if (length >= sizeof text)
        return false;
    memcpy(text, name, length);
    text[length] = '\0';
    symbol = object_symbol(debugger->setup.object, text);
    if (!symbol)
        return false;
    *value = symbol->is_word ? of_word((c205_word)symbol->value)
                             : of_integer(symbol->value);
    return true;
}

/* Reads the value of a name. Names of the program have precedence over names of
 * registers and of the machine. */
static bool read_value_name(struct reading *reading, struct value_of *value)
{
    struct debugger *debugger = reading->debugger;
    const char *name = reading->cursor->at;
    size_t length = base_length(name);
    struct register_of named = { 0, false };
    const struct asm_register *known = find_register(debugger, name, length);
    reading->cursor->at += length;
    if (known) {
        named = (struct register_of){ known->number, known->half };
        *value = of_register(debugger, named);
    } else if (read_symbol(debugger, name, length, value)) {
        return true;
    } else if (is_numbered(name, length, &named)) {
        *value = of_register(debugger, named);
    } else if (!read_special(debugger, name, length, value)) {
        return debug_fault(debugger, "unknown name '%.*s'", (int)length, name);
    }
    if (value->is_word && !value->is_half)
        take_part(reading, value);
    return true;
}

/* ---- Numbers -------------------------------------------------------------- */

static bool read_number(struct reading *reading, struct value_of *value)
{
    const char *at = reading->cursor->at;
    bool is_hex = at[0] == '0' && (at[1] == 'x' || at[1] == 'X');
    char *end;
    long long integer;
    errno = 0;
    integer = strtoll(at, &end, is_hex ? 16 : 10);
    if (*end == '.' || *end == 'e' || *end == 'E')
        *value = of_real(strtod(at, &end));
    else
        *value = of_integer(integer);
    reading->cursor->at = end;
    return (!is_name(*end) && errno != ERANGE)
           || debug_fault(reading->debugger,
                          errno == ERANGE ? "'%.40s' is too large"
                                          : "'%.40s' is not a number",
                          at);
}

/* Reads a word such as X'FFD2 4000 0000 0000', or a half word of 8 digits. */
static bool read_hex(struct reading *reading, struct value_of *value)
{
    const char *at = reading->cursor->at + 2;
    c205_word word = 0;
    unsigned digits = 0;
    for (; *at && *at != '\''; at++) {
        if (*at == ' ')
            continue;
        if (!isxdigit((unsigned char)*at) || digits++ == 16)
            break;
        word = word << 4
               | (c205_word)(isdigit((unsigned char)*at)
                                 ? *at - '0'
                                 : toupper((unsigned char)*at) - 'A' + 10);
    }
    if (*at != '\'' || digits == 0)
        return debug_fault(reading->debugger,
                           "expected up to 16 hex digits and ' after X'");
    reading->cursor->at = at + 1;
    *value = digits == HALF_DIGITS ? of_half(word << 32) : of_word(word);
    return true;
}

/* Reads an address. A descriptor with a length is rejected; the user must write NAME.i
 * for its address. */
static bool read_address(struct debugger *debugger, struct reading *reading,
                         struct value_of *value, uint64_t *address)
{
    if (!read_any(reading, value))
        return false;
    *address = c205_descriptor_address((c205_word)value->integer);
    return reading->grammar || (!value->is_half && (value->is_word || !value->is_real))
           || debug_fault(debugger,
                          "%g is not an address; the address of a descriptor is NAME.i",
                          value->real);
}

static bool read_memory(struct reading *reading, struct value_of *value)
{
    c205_word word = 0;
    uint64_t address;
    if (!read_address(reading->debugger, reading, value, &address))
        return false;
    if (!text_cursor_sign(reading->cursor, "]"))
        return debug_fault(reading->debugger, "expected ']'");
    if (!c205_read(machine_of(reading->debugger), address, &word, 1)
        && !reading->grammar)
        return debug_fault(reading->debugger, "no memory word at %llX",
                           (unsigned long long)address);
    *value = of_word(word);
    take_part(reading, value);
    return true;
}

static bool read_first(struct reading *reading, struct value_of *value)
{
    const char *at;
    text_cursor_skip(reading->cursor);
    at = reading->cursor->at;
    if (text_cursor_sign(reading->cursor, "("))
        return read_any(reading, value)
               && (text_cursor_sign(reading->cursor, ")")
                   || debug_fault(reading->debugger, "expected ')'"));
    if (text_cursor_sign(reading->cursor, "["))
        return read_memory(reading, value);
    if (at[0] == 'X' && at[1] == '\'')
        return read_hex(reading, value);
    if (isdigit((unsigned char)*at) || (*at == '.' && isdigit((unsigned char)at[1])))
        return read_number(reading, value);
    if (is_name(*at))
        return read_value_name(reading, value);
    return debug_fault(reading->debugger,
                       *at ? "expected a value, found '%.40s'"
                           : "expected a value%.40s",
                       at);
}

/* ---- Operators ------------------------------------------------------------ */

static bool needs_integers(struct reading *reading)
{
    return reading->grammar
           || debug_fault(reading->debugger, "this operator requires integers, not "
                                             "floating-point numbers");
}

static bool negate(struct reading *reading, char sign, struct value_of *value)
{
    if (sign == '!')
        *value = of_integer(!debug_is_true(value));
    else if (!value->is_real)
        *value = of_integer((int64_t)integer_negation(sign, (uint64_t)value->integer));
    else if (sign == '-')
        *value = of_real(-value->real);
    else
        return needs_integers(reading);
    return true;
}

static bool read_signed(struct reading *reading, struct value_of *value)
{
    const char *at;
    bool good;
    text_cursor_skip(reading->cursor);
    at = reading->cursor->at;
    if (reading->depth++ > MAX_DEPTH)
        return debug_fault(reading->debugger,
                           "more than %d nested operators or brackets", MAX_DEPTH);
    if (*at == '-' || *at == '~' || (*at == '!' && at[1] != '=')) {
        reading->cursor->at++;
        good = read_signed(reading, value) && negate(reading, *at, value);
    } else {
        good = read_first(reading, value);
    }
    reading->depth--;
    return good;
}

/* Returns true if two values are equal. Identical words are equal, even indefinite
 * words. */
static bool is_equal(const struct value_of *a, const struct value_of *b)
{
    if (a->is_word && b->is_word && a->is_half == b->is_half && a->word == b->word)
        return true;
    return a->is_real || b->is_real ? a->real == b->real : a->integer == b->integer;
}

static bool combine_reals(struct reading *reading, int code, struct value_of *value,
                          double a, double b)
{
    switch (code) {
    case '+': *value = of_real(a + b); break;
    case '-': *value = of_real(a - b); break;
    case '*': *value = of_real(a * b); break;
    case '/': *value = of_real(a / b); break;
    case '%': *value = of_real(fmod(a, b)); break;
    case '<': *value = of_integer(a < b); break;
    case '>': *value = of_integer(a > b); break;
    case OPERATOR('<', '='): *value = of_integer(a <= b); break;
    case OPERATOR('>', '='): *value = of_integer(a >= b); break;
    default: return needs_integers(reading);
    }
    return true;
}

static bool combine(struct reading *reading, int code, struct value_of *value,
                    const struct value_of *other)
{
    uint64_t integer = 0;
    const char *problem = NULL;
    if (code == OPERATOR('|', '|'))
        integer = debug_is_true(value) || debug_is_true(other);
    else if (code == OPERATOR('&', '&'))
        integer = debug_is_true(value) && debug_is_true(other);
    else if (code == OPERATOR('=', '='))
        integer = is_equal(value, other);
    else if (code == OPERATOR('!', '='))
        integer = !is_equal(value, other);
    else if (value->is_real || other->is_real)
        return combine_reals(reading, code, value, value->real, other->real);
    else
        problem = integer_operation(code, value->integer, other->integer, &integer);
    *value = of_integer((int64_t)integer);
    return !problem || reading->grammar
           || debug_fault(reading->debugger, "%s", problem);
}

/* Returns true if the left side of && or || determines the result. */
static bool is_decided(int code, const struct value_of *value)
{
    return code == OPERATOR('&', '&')   ? !debug_is_true(value)
           : code == OPERATOR('|', '|') ? debug_is_true(value)
                                        : false;
}

/* Reads an operand and the operators after it whose precedence is at least the given
 * one. */
static bool read_chain(struct reading *reading, int precedence, struct value_of *value)
{
    bool grammar = reading->grammar, good;
    struct value_of other;
    size_t length;
    int code, found;
    if (!read_signed(reading, value))
        return false;
    for (;;) {
        text_cursor_skip(reading->cursor);
        code = operator_at(reading->cursor->at, &length);
        found = operator_precedence(code);
        if (found == 0 || found < precedence)
            return true;
        reading->cursor->at += length;
        reading->grammar = grammar || is_decided(code, value);
        good = read_chain(reading, found + 1, &other);
        reading->grammar = grammar;
        if (!good || !combine(reading, code, value, &other))
            return false;
    }
}

static bool read_any(struct reading *reading, struct value_of *value)
{
    if (reading->depth++ > MAX_DEPTH)
        return debug_fault(reading->debugger,
                           "more than %d nested operators or brackets", MAX_DEPTH);
    if (!read_chain(reading, 1, value))
        return false;
    reading->depth--;
    return true;
}

bool debug_value(struct debugger *debugger, struct text_cursor *cursor,
                 struct value_of *value)
{
    struct reading reading = { debugger, cursor, false, 0 };
    return read_any(&reading, value);
}

bool debug_grammar(struct debugger *debugger, struct text_cursor *cursor)
{
    struct reading reading = { debugger, cursor, true, 0 };
    struct value_of value;
    return read_any(&reading, &value);
}

bool debug_address(struct debugger *debugger, struct text_cursor *cursor,
                   uint64_t *address)
{
    struct reading reading = { debugger, cursor, false, 0 };
    struct value_of value;
    return read_address(debugger, &reading, &value, address);
}

bool debug_count(struct debugger *debugger, struct text_cursor *cursor, uint64_t *count)
{
    struct value_of value;
    if (!debug_value(debugger, cursor, &value))
        return false;
    *count = (uint64_t)value.integer;
    return (!value.is_real && value.integer >= 0)
           || debug_fault(debugger, "%g is not a count", value.real);
}
