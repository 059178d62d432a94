/* syntax.c - the syntax of names, and the operands of an instruction. The syntax of its
 * format in insn.def determines the operands. */
#include "asm/object/syntax.h"

#include <ctype.h>
#include <string.h>

enum { LAST_REGISTER = C205_REGISTERS - 1 };

bool is_name_start(char c)
{
    return isalpha((unsigned char)c) || c == '_' || c == '$';
}

/* Returns true for the characters of a name. A dot groups names, as in sphere.loop. */
bool is_name_part(char c)
{
    return is_name_start(c) || isdigit((unsigned char)c) || c == '.';
}

bool is_register_name(const char *name, size_t length)
{
    int number = 0;
    if (length < 2 || length > 4 || !strchr("rRhH", *name)
        || (name[1] == '0' && length > 2))
        return false;
    for (size_t i = 1; i < length; i++) {
        if (!isdigit((unsigned char)name[i]))
            return false;
        number = 10 * number + (name[i] - '0');
    }
    return number < C205_REGISTERS;
}

uint8_t *syntax_field(c205_fields *fields, char letter)
{
    switch (letter) {
    case 'X': return &fields->x;
    case 'A': return &fields->a;
    case 'Y': return &fields->y;
    case 'B': return &fields->b;
    case 'Z': return &fields->z;
    case 'C': return &fields->c;
    case 'R': return &fields->r;
    case 'S': return &fields->s;
    default: return &fields->t;
    }
}

/* Properties that the syntax of a format does not express: the range of its immediate,
 * the number of optional operands at its end, and whether a source must be a vector
 * because no other operand has a length. */
static const struct format_rule {
    c205_format format;
    int64_t low, high;
    size_t left_out;
    bool needs_vector;
} format_rules[] = {
    { C205_FORMAT_SHIFT, -64, 63, 0, false },
    { C205_FORMAT_REQUEST, 0, 255, 3, false },
    { C205_FORMAT_I16, -32768, 65535, 0, false },
    { C205_FORMAT_I24, -((int64_t)1 << 23), ((int64_t)1 << 24) - 1, 0, false },
    { C205_FORMAT_I48, -((int64_t)1 << 47), ((int64_t)1 << 48) - 1, 0, false },
    { C205_FORMAT_JUMP, 0, ((int64_t)1 << 48) - 1, 1, false },
    { C205_FORMAT_ALTER, 0, 15, 0, false },
    { C205_FORMAT_ALTERB, 0, 15, 0, false },
    { C205_FORMAT_ALTERF, 0, 15, 0, false },
    { C205_FORMAT_INDEX, 0, 0, 1, false },
    { C205_FORMAT_REDUCE, 0, 0, 0, true },
    { C205_FORMAT_REDUCE2, 0, 0, 0, true },
    { C205_FORMAT_EXTREME, 0, 0, 0, true },
    { C205_FORMAT_SIEVE, 0, 0, 0, true }
};

static const struct format_rule *find_rule(c205_format format)
{
    for (size_t i = 0; i < sizeof format_rules / sizeof *format_rules; i++)
        if (format_rules[i].format == format)
            return &format_rules[i];
    return NULL;
}

/* Sets the bits of G that select the sign of an operand. |A| and |B| are possible, but
 * only A can be negated. */
static void add_sign(struct operand *operand, const c205_insn *insn, char letter)
{
    if (!(insn->flags & C205_INSN_SIGN)
        || !strchr("vuf", tolower((unsigned char)letter)))
        return;
    if (operand->field == 'A') {
        operand->negate = C205_G_NEGATE_A;
        operand->magnitude = C205_G_MAGNITUDE_A;
    } else if (operand->field == 'B') {
        operand->magnitude = C205_G_MAGNITUDE_B;
    }
}

/* Reads an operand in brackets: "[R, S]", "[A+X]" or "[R]". A result vector may have an
 * offset in register C+1, but not in instructions whose Z can be given (letter g in
 * insn.def). Returns the end of the operand, and advances over its letters. */
static const char *read_bracket(struct operand *operand, const char *at,
                                const c205_insn *insn, const char **letter)
{
    operand->kind = OPERAND_BRACKET;
    operand->field = at[1];
    if (at[2] == ',') {
        operand->second = at[4];
        ++*letter;
    } else if (at[2] == '+') {
        operand->second = at[3];
    } else if (**letter == 'g') {
        operand->given = C205_G_GIVEN;
    } else if (operand->field == 'C' && strchr("dDeqco", **letter)
               && !strchr(insn->operands, 'g')) {
        operand->second = SECOND_IS_NEXT;
    }
    return strchr(at, ']') + 1;
}

static void read_source(struct operand *operand, char field)
{
    operand->kind = OPERAND_SOURCE;
    operand->field = (char)toupper((unsigned char)field);
    operand->second = operand->field == 'A' ? 'X' : 'Y';
    operand->broadcast = operand->field == 'A' ? C205_G_BROADCAST_A
                                               : C205_G_BROADCAST_B;
}

/* Returns true if an operand without brackets is a half register: its letter in
 * insn.def is a capital, or is treated as a capital because of ",H". */
static bool is_half(const struct operand *operand, const c205_insn *insn, char letter,
                    bool half)
{
    if (half && (insn->flags & C205_INSN_HALF) && strchr("fwpvu", letter))
        letter = (char)toupper((unsigned char)letter);
    return (operand->kind == OPERAND_REGISTER && strchr("FIWMP", letter))
           || (operand->kind == OPERAND_SOURCE && strchr("VU", letter));
}

static const char *read_operand(struct operand *operand, const char *at,
                                const c205_insn *insn, const char **letter)
{
    const struct format_rule *rule = find_rule(insn->format);
    if (*at == '[')
        return read_bracket(operand, at, insn, letter);
    if (*at == 'I' && isdigit((unsigned char)at[1])) {
        operand->kind = OPERAND_IMMEDIATE;
        operand->low = rule->low;
        operand->high = rule->high;
        return at + 1 + strspn(at + 1, "0123456789");
    }
    if (*at == '?' || *at == '!') {
        operand->kind = OPERAND_CONTROL;
        operand->field = at[1];
        operand->may_be_left_out = *at == '?';
        return at + 2;
    }
    if (*at == '@')
        operand->kind = OPERAND_TARGET;
    else if (islower((unsigned char)*at))
        read_source(operand, *at);
    else
        operand->field = *at;
    return at + 1;
}

size_t syntax_operands(const c205_insn *insn, bool half,
                       struct operand operands[MAX_OPERANDS])
{
    static const struct operand empty;
    const char *at = c205_format_syntax(insn->format);
    const char *letter = insn->operands;
    const struct format_rule *rule = find_rule(insn->format);
    size_t count = 0;
    while (*at && count < MAX_OPERANDS) {
        char first = *letter;
        if (*at == ' ' || *at == ',') {
            at++;
            continue;
        }
        operands[count] = empty;
        at = read_operand(&operands[count], at, insn, &letter);
        add_sign(&operands[count], insn, first);
        operands[count].in_two = first == 'p';
        operands[count].half = is_half(&operands[count], insn, first, half);
        count++;
        letter += *letter != '\0';
    }
    for (size_t i = 0; rule && i < rule->left_out && i < count; i++)
        operands[count - 1 - i].may_be_left_out = true;
    return count;
}

/* ---- Instructions that the machine rejects  */

static const char *refuse_one(const struct operand *operand, c205_fields *fields)
{
    uint8_t number = *syntax_field(fields, operand->field);
    if (operand->second == SECOND_IS_NEXT && number == LAST_REGISTER
        && (fields->g & C205_G_OFFSET))
        return "the offset of a result is in the register after it, but r255 is the "
               "last register";
    if (operand->in_two && number % 2)
        return "the sum has two parts: it requires an even register and the one after "
               "it";
    if (operand->kind == OPERAND_CONTROL && number == 0
        && (!operand->may_be_left_out || (fields->g & C205_G_ZEROS)))
        return "r0 cannot be a control vector";
    return NULL;
}

const char *syntax_refusal(const c205_insn *insn, const struct operand *operands,
                           size_t count, c205_fields *fields, size_t *blamed)
{
    const struct format_rule *rule = find_rule(insn->format);
    bool vector = !rule || !rule->needs_vector;
    const char *problem = NULL;
    for (size_t i = 0; i < count && !problem; i++) {
        *blamed = i;
        problem = refuse_one(&operands[i], fields);
        vector |= operands[i].kind == OPERAND_SOURCE
                  && !(fields->g & operands[i].broadcast);
    }
    if (problem || vector)
        return problem;
    *blamed = 0;
    return "a source must be a vector [..], because it sets the length";
}

/* ---- The syntax as text ------------------------------------------------- */

static void write_operand(const struct operand *operand, const struct sink *sink)
{
    const char *letter = operand->half ? "h" : "r";
    switch (operand->kind) {
    case OPERAND_REGISTER: sink_put(sink, letter); break;
    case OPERAND_BRACKET:
        sink_put(sink, operand->second && operand->second != SECOND_IS_NEXT ? "[r, r]"
                       : operand->given ? "[r] or ? [r]"
                                        : "[r]");
        break;
    case OPERAND_SOURCE: sink_print(sink, "[r] or %s", letter); break;
    case OPERAND_IMMEDIATE: sink_put(sink, "number"); break;
    case OPERAND_TARGET: sink_put(sink, "label or [r]"); break;
    case OPERAND_CONTROL: sink_put(sink, "? [r]"); break;
    }
}

void syntax_write(const c205_insn *insn, bool half, const struct sink *sink)
{
    struct operand operands[MAX_OPERANDS];
    size_t i, open = 0, count = syntax_operands(insn, half, operands);
    sink_print(sink, "%s%s", insn->mnemonic, half ? SYNTAX_HALF : "");
    for (i = 0; i < count; i++) {
        bool control = operands[i].kind == OPERAND_CONTROL;
        if (i > 0 && !control)
            sink_put(sink, ",");
        sink_put(sink, operands[i].may_be_left_out ? " (" : " ");
        open += operands[i].may_be_left_out;
        write_operand(&operands[i], sink);
    }
    while (open-- > 0)
        sink_put(sink, ")");
}
