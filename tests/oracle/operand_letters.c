/* operand_letters.c - matches the syntax of a format with a row's operand letters. */
#include "operand_letters.h"

#include "tests/oracle/reference.h"

#include <ctype.h>
#include <string.h>

int role_of_letter(char letter)
{
    static const char *const letters[ROLES] = { "AaR", "BbS", "CT", "X", "Y", "Z" };
    for (int role = 0; role < ROLES; role++)
        if (strchr(letters[role], letter))
            return role;
    return -1;
}

/* Short and immediate formats have the fields R, S and T. */
static bool has_short_fields(const c205_insn *row)
{
    return !strpbrk(c205_format_syntax(row->format), "ABCab");
}

uint8_t *field_of_role(c205_fields *fields, const c205_insn *row, enum role role)
{
    bool is_short = has_short_fields(row);
    switch (role) {
    case ROLE_A: return is_short ? &fields->r : &fields->a;
    case ROLE_B: return is_short ? &fields->s : &fields->b;
    case ROLE_C: return is_short ? &fields->t : &fields->c;
    case ROLE_X: return &fields->x;
    case ROLE_Y: return &fields->y;
    default: return &fields->z;
    }
}

static char field_letter(const c205_insn *row, enum role role)
{
    return (has_short_fields(row) ? "RSTXYZ" : "ABCXYZ")[role];
}

char letter_of(const c205_insn *row, enum role role)
{
    return reference_table_letter(row, field_letter(row, role));
}

char sized_letter(const c205_insn *row, unsigned g, enum role role)
{
    return reference_letter(row, g, field_letter(row, role));
}

bool is_scalar(const c205_insn *row, unsigned g, enum role role)
{
    char letter = (char)tolower((unsigned char)letter_of(row, role));
    return letter == 0 || strchr("fiwpkm", letter)
           || (role == ROLE_A && g & C205_G_BROADCAST_A
               && strchr(c205_format_syntax(row->format), 'a'))
           || (role == ROLE_B && g & C205_G_BROADCAST_B
               && strchr(c205_format_syntax(row->format), 'b'));
}

bool is_half_register(const c205_insn *row, unsigned g, enum role role)
{
    char letter = sized_letter(row, g, role);
    return isupper((unsigned char)letter) && is_scalar(row, g, role);
}
