/* operand_letters.c - matches the syntax of a format with the operand letters of a
 * row. */
#include "operand_letters.h"

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

char letter_of(const c205_insn *row, enum role role)
{
    const char *letters = row->operands;
    const char *syntax = c205_format_syntax(row->format);
    for (const char *p = syntax; *p && *letters; p++) {
        int found = role_of_letter(*p);
        if (*p == '@' || *p == 'I')
            letters++;
        if (found < 0 || (p > syntax && p[-1] == '+'))
            continue;
        if (found == (int)role)
            return *letters;
        letters++;
    }
    return 0;
}

char sized_letter(const c205_insn *row, unsigned g, enum role role)
{
    char letter = letter_of(row, role);
    bool half = row->flags & C205_INSN_HALF && g & C205_G_HALF;
    if (letter == 'g')
        return g & C205_G_GIVEN ? 'b' : 'o';
    return half && letter && strchr("fwpvudcx", letter)
               ? (char)toupper((unsigned char)letter)
               : letter;
}

bool is_scalar(const c205_insn *row, unsigned g, enum role role)
{
    char letter = (char)tolower((unsigned char)letter_of(row, role));
    if (letter == 0 || strchr("fiwpkm", letter))
        return true;
    return (role == ROLE_A && g & C205_G_BROADCAST_A
            && strchr(c205_format_syntax(row->format), 'a'))
           || (role == ROLE_B && g & C205_G_BROADCAST_B
               && strchr(c205_format_syntax(row->format), 'b'));
}

bool is_half_register(const c205_insn *row, unsigned g, enum role role)
{
    char letter = sized_letter(row, g, role);
    return isupper((unsigned char)letter) && is_scalar(row, g, role);
}
