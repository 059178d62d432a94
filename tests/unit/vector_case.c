/* vector_case.c - random operands for a vector instruction: G, places, lengths. */
#include "vector_case.h"

#include <ctype.h>

/* ---- Properties of the row ----------------------------------------------- */

bool is_row_of(const c205_insn *row, const char *names)
{
    const char *found = strstr(names, row->mnemonic);
    char after = found ? found[strlen(row->mnemonic)] : 'x';
    return after == ' ' || after == '\0';
}

bool z_selects(const c205_insn *row)
{
    return strstr(c205_format_syntax(row->format), "!Z");
}

bool is_given(const struct vector_case *one)
{
    return letter_of(one->row, ROLE_Z) == 'g' && one->fields.g & C205_G_GIVEN;
}

bool has_control(const struct vector_case *one)
{
    return one->fields.z && letter_of(one->row, ROLE_Z) == 'z';
}

static unsigned width_of(const struct vector_case *one, enum role role)
{
    char letter = sized_letter(one->row, one->fields.g, role);
    if (letter && strchr("beoz", letter))
        return 1;
    return isupper((unsigned char)letter) ? HALF : WORD;
}

/* ---- Bits --------------------------------------------------------------- */

void mark(struct bits_of *bits, uint64_t address, uint64_t count)
{
    for (uint64_t at = address - DATA; count > 0; at++, count--)
        bits->memory[at / WORD] |= UINT64_C(1) << (WORD - 1 - at % WORD);
}

void mark_element(struct bits_of *bits, const struct extent_of *vector, size_t i)
{
    if (i < vector->length)
        mark(bits, vector->address + i * vector->width, vector->width);
}

bool bit_of(const struct vector_case *one, enum role role, size_t i)
{
    uint64_t at = one->vector[role].address + i - DATA;
    return i < one->vector[role].length
           && one->memory[at / WORD] >> (WORD - 1 - at % WORD) & 1;
}

bool is_chosen(const struct vector_case *one, size_t i)
{
    const struct extent_of *z = &one->vector[ROLE_Z];
    uint64_t at = z->address + i - DATA;
    bool bit = one->memory[at / WORD] >> (WORD - 1 - at % WORD) & 1;
    return bit != !!(one->fields.g & C205_G_ZEROS);
}

bool is_permitted(const struct vector_case *one, size_t i)
{
    return !has_control(one) || z_selects(one->row) || is_chosen(one, i);
}

size_t count_chosen(const struct vector_case *one, bool chosen)
{
    size_t count = 0;
    for (size_t i = 0; i < one->n; i++)
        count += is_chosen(one, i) == chosen;
    return count;
}

/* ---- Registers ---------------------------------------------------------- */

const uint8_t role_register[ROLES] = { 130, 140, 150, 160, 170, 180 };
const uint8_t role_half[ROLES] = { 201, 202, 205, 206, 209, 210 };

bool is_half(const struct vector_case *one, enum role role)
{
    return is_half_register(one->row, one->fields.g, role);
}

/* Returns the register number of an operand. A sum uses two half registers, and its
 * number is the left one, which is even. */
uint8_t register_name(const struct vector_case *one, enum role role)
{
    if (!is_half(one, role))
        return role_register[role];
    return letter_of(one->row, role) == 'p' ? role_half[role] & 0xFE : role_half[role];
}

void define(struct vector_case *one, unsigned number, c205_word word, c205_word bits)
{
    one->reg[number] = word;
    one->defined.reg[number] = bits;
}

void define_half(struct vector_case *one, unsigned number, c205_word word)
{
    unsigned shift = number % 2 ? 0 : HALF;
    define(one, number / 2, (word & UINT32_MAX) << shift,
           (c205_word)UINT32_MAX << shift);
}

/* Returns false if the instruction ignores the length field of the operand. The operand
 * is a table, a control vector or a result whose length the machine sets. */
static bool length_matters(const struct vector_case *one, enum role role)
{
    char letter = sized_letter(one->row, one->fields.g, role);
    if (letter == 'z')
        return one->row->format == C205_FORMAT_SQUEEZE
               || one->row->format == C205_FORMAT_SQUEEZEB;
    return !(role == ROLE_Z && letter == 'e') && !strchr("cCoxX", letter);
}

/* ---- Lengths and places ------------------------------------------------- */

size_t draw(uint64_t *random, size_t low, size_t high)
{
    return (size_t)random_between(random, (int64_t)low, (int64_t)high);
}

size_t draw_size(uint64_t *random)
{
    size_t kind = draw(random, 0, 9);
    return kind == 0 ? 0 : draw(random, 1, kind == 1 ? LENGTH : 150);
}

/* Defines the descriptor of a vector. It begins `offset` elements before its extent,
 * and is longer by `offset` elements. */
static void place_vector(struct vector_case *one, enum role role, uint64_t *random,
                         size_t length, size_t offset)
{
    struct extent_of *vector = &one->vector[role];
    size_t start = WORD / (vector->width = width_of(one, role));
    uint64_t zone = DATA + (uint64_t)(role * ZONE_WORDS + LEAD) * WORD
                    + draw(random, 0, start - 1) * vector->width;
    bool counts = length_matters(one, role);
    define(one, role_register[role], descriptor(zone, counts ? length + offset : 0),
           counts ? UINT64_MAX : ADDRESS_BITS);
    vector->address = zone + offset * vector->width;
    vector->length = length;
}

static c205_word draw_of(const struct oracle_format *format, uint64_t *random)
{
    struct operands operands = operands_begin(format, random_bits(random));
    c205_word a, b;
    operands.position = draw(random, 0, 100000);
    operands_next(&operands, &a, &b, 1);
    return a;
}

c205_word draw_word(uint64_t *random)
{
    return draw_of(&oracle_full, random);
}

c205_word draw_half(uint64_t *random)
{
    return draw_of(&oracle_half, random) >> HALF;
}

static void place_scalar(struct vector_case *one, enum role role, uint64_t *random)
{
    char letter = letter_of(one->row, role);
    if (letter == 'i') /* number of groups of a repeated mask */
        define(one, role_register[role], (c205_word)draw(random, 1, 20), ADDRESS_BITS);
    else if (letter && strchr("wpk", letter)) /* operands that are results */
        return;
    else if (is_half(one, role))
        define_half(one, role_half[role], draw_half(random));
    else
        define(one, role_register[role], draw_word(random), UINT64_MAX);
}

static size_t draw_offset(struct vector_case *one, uint64_t *random, uint8_t *field,
                          enum role role)
{
    size_t offset = draw(random, 0, MAX_OFFSET);
    *field = (uint8_t)(role_register[role] + 1);
    define(one, *field, offset, ADDRESS_BITS);
    return offset;
}

/* Returns a source's random offset: one in four, if the syntax allows it. */
static size_t source_offset(struct vector_case *one, uint64_t *random, enum role role)
{
    const char *syntax = c205_format_syntax(one->row->format);
    bool may = role == ROLE_A ? strchr(syntax, 'a') || strstr(syntax, "A+X")
                              : strchr(syntax, 'b') || strstr(syntax, "B+Y");
    if (!may || draw(random, 0, 3) > 0)
        return 0;
    return draw_offset(one, random, role == ROLE_A ? &one->fields.x : &one->fields.y,
                       role);
}

size_t source_length(uint64_t *random, size_t n)
{
    return draw(random, 0, 1) ? n : draw(random, 0, n + 20);
}

/* ---- G ------------------------------------------------------------------ */

/* Returns false for reductions and moves of one number, which do not exist. */
static bool makes_sense(const c205_insn *row, unsigned g)
{
    bool a = g & C205_G_BROADCAST_A, b = g & C205_G_BROADCAST_B;
    switch (row->format) {
    case C205_FORMAT_REDUCE:
    case C205_FORMAT_EXTREME: return !a;
    case C205_FORMAT_REDUCE2:
    case C205_FORMAT_SIEVE:
    case C205_FORMAT_SPREAD: return !(a && b);
    default: return true;
    }
}

static void draw_g(struct vector_case *one, uint64_t *random)
{
    const char *syntax = c205_format_syntax(one->row->format);
    bool is_short = c205_format_halves(one->row->format) == 1;
    unsigned legal = reference_bits_of_g(one->row), g;
    legal |= one->row->flags & C205_INSN_HALF ? C205_G_HALF : 0;
    legal &= ~(unsigned)one->row->subop_mask;
    do
        g = (unsigned)(random_bits(random) & random_bits(random)) & legal;
    while (!makes_sense(one->row, g));
    one->fields.f = one->row->opcode;
    one->fields.g = (uint8_t)(is_short ? 0 : g | one->row->subop);
    if (strstr(syntax, "?Z") && draw(random, 0, 2) == 0)
        one->fields.g &= (uint8_t)~C205_G_ZEROS;
    else if (strchr(syntax, 'Z'))
        one->fields.z = role_register[ROLE_Z];
}

/* ---- Contents ----------------------------------------------------------- */

static void put_word(struct vector_case *one, uint64_t address, c205_word word)
{
    one->memory[(address - DATA) / WORD] = word;
}

/* Fills a vector with indices into the zone of a table. */
static void fill_indices(struct vector_case *one, uint64_t *random)
{
    for (size_t i = 0; i < LENGTH; i++)
        put_word(one, one->vector[ROLE_A].address + i * WORD,
                 draw(random, 0, draw(random, 0, 1) ? 600 : 30));
    if (one->fields.g & C205_G_BROADCAST_A)
        define(one, role_register[ROLE_A], draw(random, 0, 99), ADDRESS_BITS);
}

static bool has_list(const c205_insn *row)
{
    return row->format == C205_FORMAT_TABLE || row->format == C205_FORMAT_SPREAD;
}

static bool is_periodic(const c205_insn *row)
{
    return row->format == C205_FORMAT_PERIODIC || row->format == C205_FORMAT_SPACED;
}

bool has_indices(const c205_insn *row)
{
    return has_list(row) || is_periodic(row);
}

enum role table_of(const c205_insn *row)
{
    return letter_of(row, ROLE_B) == 'x' ? ROLE_B : ROLE_C;
}

uint64_t indexed(const struct vector_case *one, size_t i)
{
    const struct extent_of *table = &one->vector[table_of(one->row)];
    uint64_t list = one->vector[ROLE_A].address - DATA;
    uint64_t index = is_periodic(one->row) ? (uint64_t)(one->period * (int64_t)i)
                                           : one->memory[list / WORD + i];
    return table->address + index * table->width;
}

/* Places the table's n elements in its zone, with the first at either end. */
static void place_period(struct vector_case *one, uint64_t *random)
{
    enum role role = table_of(one->row);
    struct extent_of *table = &one->vector[role];
    int64_t room = ZONE_WORDS - 2 * LEAD;
    int64_t most = room / (int64_t)(one->n > 0 ? one->n : 1);
    one->period = random_between(random, -most, most);
    define(one, role_register[ROLE_A], (c205_word)one->period, ADDRESS_BITS);
    if (one->period < 0)
        table->address += (uint64_t)room * WORD;
    define(one, role_register[role], table->address, ADDRESS_BITS);
}

static bool has_halves(const struct vector_case *one, int zone)
{
    return zone < ROLES && letter_of(one->row, (enum role)zone)
           && width_of(one, (enum role)zone) == HALF;
}

static void fill_memory(struct vector_case *one, uint64_t *random)
{
    for (size_t i = 0; i < MEMORY_WORDS; i++)
        if (has_halves(one, (int)(i / ZONE_WORDS))) {
            one->memory[i] = draw_half(random) << HALF;
            one->memory[i] |= draw_half(random);
        } else {
            one->memory[i] = draw_word(random);
        }
    if (has_list(one->row))
        fill_indices(one, random);
    for (size_t i = 0; i < ZONE_WORDS; i++) /* control vectors have bits, not numbers */
        for (int role = ROLE_X; role < ROLES; role++)
            one->memory[(size_t)role * ZONE_WORDS + i] = random_bits(random);
}

/* ---- Number of elements ------------------------------------------------- */

static size_t scanned(const struct vector_case *one)
{
    return one->vector[one->scalar[ROLE_A] ? ROLE_B : ROLE_A].length;
}

static size_t elements_of(const struct vector_case *one)
{
    const struct extent_of *v = one->vector;
    size_t n = v[ROLE_C].length;
    switch (one->row->format) {
    case C205_FORMAT_REDUCE:
    case C205_FORMAT_REDUCE2:
    case C205_FORMAT_EXTREME:
    case C205_FORMAT_SIEVE:
    case C205_FORMAT_SPREAD:
    case C205_FORMAT_SPACED:
    case C205_FORMAT_BITS1: return scanned(one);
    case C205_FORMAT_SQUEEZE:
    case C205_FORMAT_SQUEEZEB: return v[ROLE_Z].length;
    case C205_FORMAT_SPARSE:
        if (is_given(one))
            return v[ROLE_Z].length;
        return v[ROLE_X].length > v[ROLE_Y].length ? v[ROLE_X].length
                                                   : v[ROLE_Y].length;
    case C205_FORMAT_TABLE:
        return one->scalar[ROLE_A] || v[ROLE_A].length > n ? n : v[ROLE_A].length;
    default: return n;
    }
}

/* ---- Whole cases -------------------------------------------------------- */

static void place_operand(struct vector_case *one, enum role role, uint64_t *random,
                          size_t n, size_t offset)
{
    bool exact = role == ROLE_C || role == ROLE_Z;
    if (!letter_of(one->row, role)
        || (letter_of(one->row, role) == 'z' && !one->fields.z))
        return;
    *field_of_role(&one->fields, one->row, role) = register_name(one, role);
    one->scalar[role] = is_scalar(one->row, one->fields.g, role);
    if (one->scalar[role])
        place_scalar(one, role, random);
    else
        place_vector(one, role, random, exact ? n : source_length(random, n), offset);
}

static void place_operands(struct vector_case *one, uint64_t *random, size_t n)
{
    size_t offset;
    for (int role = ROLE_A; role <= ROLE_B; role++) {
        offset = is_scalar(one->row, one->fields.g, (enum role)role)
                     ? 0
                     : source_offset(one, random, (enum role)role);
        place_operand(one, (enum role)role, random, n, offset);
    }
    offset = reference_has_offset(one->row, &one->fields)
                 ? draw_offset(one, random, &(uint8_t){ 0 }, ROLE_C)
                 : 0;
    for (int role = ROLE_C; role < ROLES; role++)
        place_operand(one, (enum role)role, random, n,
                      role == ROLE_C || role == ROLE_Z ? offset : 0);
}

void draw_case(struct vector_case *one, const c205_insn *row, uint64_t *random,
               size_t n)
{
    memset(one, 0, sizeof *one);
    one->row = row;
    draw_g(one, random);
    place_operands(one, random, n);
    fill_memory(one, random);
    one->n = elements_of(one);
    if (is_periodic(row))
        place_period(one, random);
}
