/* random_program.c - generates a random program, its data and its initial registers
 * from a seed (random_program.h). */
#include "random_parts.h"

#include "tests/oracle/operands.h"
#include "tests/oracle/reference.h"

#include <string.h>

enum { PAGE_BITS = C205_PAGE_WORDS * WORD };
#define HALF_ONES UINT64_C(0xEA400000EA400000)
#define LOW_24 UINT64_C(0xFFFFFF)
#define IN_PAGE(page, word) ((uint64_t)(page)*PAGE_BITS + (uint64_t)(word)*WORD)

const char *const random_models[] = {
    "title two pipes\nlike cyber205-2pipe-prior\n",
    "title one pipe\nlike cyber205-1pipe-prior\n",
    "title four pipes\nlike cyber205-4pipe-prior\n",
    "title little memory\nlike cyber205-2pipe-prior\n"
    "memory.real_words 196608 words R\ntranslation.registers 2 registers R\n",
    "title odd times\nlike cyber205-4pipe-prior\n"
    "memory.real_words 131072 words R\ntranslation.registers 1 registers R\n"
    "vector.overlap 70 clk R\nstream.vadd 1.7 clk*pipe/element R\n"
    "issue.interval 2 clk R\nmemory.loads_in_flight 2 loads R\n"
    "swap.word 0.3 clk/word R\nbusy.add 3 clk R\n"
    "branch.stack_words 4 words R\nbranch.not_taken 2 clk R\n"
    "vector.half_rate 3 results R\n",
    "title small pages\nlike cyber205-2pipe-prior\n"
    "page.words 512 words R\nmemory.real_words 20000 words R\n"
    "translation.registers 5 registers R\n"
    "memory.bank_busy 7 clk R\nmemory.banks 5 banks R\n",
    "title more registers than pages\nlike cyber205-4pipe-prior\n"
    "page.words 8192 words R\nmemory.real_words 20000 words R\n"
    "translation.registers 3 registers R\n",
    "title less than a page\nlike cyber205-1pipe-prior\n"
    "page.words 2048 words R\nmemory.real_words 100 words R\n"
    "translation.registers 0 registers R\n"
    "vector.word_rate 2 results R\nvector.half_rate 3 results R\n",
};
const size_t random_model_count = sizeof random_models / sizeof random_models[0];

/* Page 5 is not mapped. Neither are pages 0, 7, 9 and above. */
const struct random_page random_pages[RANDOM_PAGES] = {
    { IN_PAGE(1, 0), C205_READ_WRITE }, { IN_PAGE(2, 0), C205_READ_WRITE },
    { IN_PAGE(3, 0), C205_READ_WRITE }, { IN_PAGE(4, 0), C205_READ_WRITE },
    { IN_PAGE(6, 0), C205_READ_ONLY },  { IN_PAGE(8, 0), C205_READ_WRITE },
};

const struct random_area random_areas[] = {
    { IN_PAGE(2, C205_PAGE_WORDS - 250), 500, C205_READ_WRITE, NUMBERS },
    { IN_PAGE(3, 1000), 2600, C205_READ_WRITE, NUMBERS },
    { IN_PAGE(4, C205_PAGE_WORDS - 250), 250, C205_READ_WRITE, NUMBERS },
    { IN_PAGE(6, 0), 200, C205_READ_ONLY, NUMBERS },
    { IN_PAGE(8, 100), 300, C205_READ_WRITE, NUMBERS },
    { IN_PAGE(3, 9000), 1200, C205_READ_WRITE, HALF_NUMBERS },
    { IN_PAGE(3, C205_PAGE_WORDS - 120), 100, C205_READ_WRITE, HALF_NUMBERS },
    { IN_PAGE(4, 20), 150, C205_READ_WRITE, HALF_NUMBERS },
    { IN_PAGE(8, 440), 100, C205_READ_WRITE, HALF_NUMBERS },
    { IN_PAGE(3, 5000), 300, C205_READ_WRITE, INDICES },
    { IN_PAGE(3, 6000), 200, C205_READ_WRITE, WILD_INDICES },
    { IN_PAGE(3, 7000), 200, C205_READ_WRITE, FAR_INDICES },
    { IN_PAGE(3, C205_PAGE_WORDS - 10), 20, C205_READ_WRITE, BIT_STRINGS },
    { IN_PAGE(2, 300), 40, C205_READ_WRITE, BIT_STRINGS },
};
const size_t random_area_count = sizeof random_areas / sizeof random_areas[0];

/* ---- Chance ------------------------------------------------------------ */

bool one_in(uint64_t *random, int64_t n)
{
    return random_between(random, 1, n) == 1;
}

static c205_word integer(const struct oracle_format *format, int64_t value)
{
    long exponent_bits = format->width - format->digits - 1;
    return (c205_word)value << (WORD - format->digits - 1) >> exponent_bits;
}

static c205_word number(uint64_t *random, const struct oracle_format *format)
{
    struct operands operands = operands_begin(format, random_bits(random));
    c205_word a, b;
    if (one_in(random, 3))
        return integer(format, random_between(random, -20, 20));
    operands.position = (size_t)random_bits(random) % 100000;
    operands_next(&operands, &a, &b, 1);
    return one_in(random, 2) ? a : b;
}

/* Returns a word that is equal to a half word, or between two half words, where
 * rounding may carry. The lower digits are nearly half a unit or a whole one. */
static c205_word near_half(uint64_t *random)
{
    static const c205_word beyond[] = { 0, 0x7FFFFF, 0x800000, 0xFFFFFF };
    c205_word half = number(random, &oracle_half);
    int64_t exponent = ((int64_t)half >> 56) - 24;
    return (c205_word)exponent << 48 | (half >> HALF & LOW_24) << 24
           | beyond[random_between(random, 0, 3)];
}

static c205_word word_number(uint64_t *random)
{
    return one_in(random, 12) ? near_half(random) : number(random, &oracle_full);
}

/* Returns two half words. */
static c205_word half_numbers(uint64_t *random)
{
    c205_word left = number(random, &oracle_half);
    return left | number(random, &oracle_half) >> HALF;
}

int64_t draw_integer(uint64_t *random)
{
    if (one_in(random, 30))
        return random_between(random, -90, -1);
    if (one_in(random, 30))
        return (int64_t)(random_bits(random) >> 16);
    return random_between(random, 0, one_in(random, 4) ? 200 : 8);
}

uint64_t draw_length(uint64_t *random)
{
    if (one_in(random, 300))
        return C205_MAX_LENGTH;
    if (one_in(random, 12))
        return 0;
    if (one_in(random, 30))
        return (uint64_t)random_between(random, 500, 1600);
    return (uint64_t)random_between(random, 1, one_in(random, 3) ? 300 : 20);
}

/* ---- Data -------------------------------------------------------------- */

/* Returns an index that is mostly on the page of the table. Otherwise it is on another
 * page, which may contain code, be read-only or not be mapped. */
static c205_word far_index(uint64_t *random)
{
    int64_t pages = one_in(random, 40) ? random_between(random, -2, 3) : 0;
    return (c205_word)(pages * C205_PAGE_WORDS + random_between(random, -40, 300));
}

static c205_word datum(uint64_t *random, const struct random_area *area)
{
    switch (area->contents) {
    case INDICES: return (c205_word)random_between(random, 0, 90);
    case WILD_INDICES:
        return one_in(random, 60) ? random_bits(random)
                                  : (c205_word)random_between(random, -9, 9);
    case FAR_INDICES: return far_index(random);
    case BIT_STRINGS:
        return one_in(random, 3) ? 0 - (random_bits(random) & 1) : random_bits(random);
    case HALF_NUMBERS: return half_numbers(random);
    default: return word_number(random);
    }
}

static c205_word plain_datum(const struct random_area *area)
{
    switch (area->contents) {
    case NUMBERS: return C205_ONE;
    case HALF_NUMBERS: return HALF_ONES;
    case BIT_STRINGS: return UINT64_MAX;
    default: return 0;
    }
}

/* The first DISTINCT words of an area are generated. Later words repeat them at random,
 * because generating numbers is slow. */
enum { DISTINCT = 200 };

void program_data(const struct random_program *program, const struct random_area *area,
                  c205_word *words)
{
    uint64_t random = program->seed ^ area->address;
    for (size_t i = 0; i < area->words; i++)
        words[i] = program->plain_data ? plain_datum(area)
                   : i < DISTINCT      ? datum(&random, area)
                                       : words[random_bits(&random) % DISTINCT];
}

/* ---- Registers --------------------------------------------------------- */

/* The registers of each role. random_parts.h describes the roles. */
static const struct pool {
    char role;
    unsigned first, count;
} pools[] = {
    { 'n', 1, 15 },   /* numbers */
    { 'i', 16, 16 },  /* integers */
    { 'h', 32, 12 },  /* half registers of numbers */
    { 'j', 44, 4 },   /* half registers of integers */
    { 'v', 48, 28 },  /* vectors of words */
    { 'w', 76, 24 },  /* vectors of half words */
    { 'b', 100, 16 }, /* bit vectors */
    { 'x', 116, 8 },  /* lists of indices */
    { 'k', 128, 8 },  /* code addresses */
    { 's', 136, 8 },  /* short vectors for SWAP */
    { 'p', 144, 16 }, /* vectors and their offsets, alternately */
    { 'o', 160, 16 }, /* half-word vectors and their offsets */
    { 'q', 176, 8 },  /* bit vectors and their offsets */
    { 'f', 184, 8 },  /* fields of a register */
};
enum { POOLS = sizeof pools / sizeof pools[0] };

static const struct pool *pool_of(char role)
{
    for (size_t i = 0; i < POOLS; i++)
        if (pools[i].role == role)
            return pools + i;
    return pools;
}

unsigned draw_register(uint64_t *random, char role)
{
    const struct pool *pool = pool_of(role);
    bool pairs = strchr("poq", role);
    bool halves = strchr("hj", role);
    if (one_in(random, 40))
        return (unsigned)random_between(random, 0, C205_REGISTERS - 1);
    if (!pairs && one_in(random, 25))
        return 0;
    if (pairs)
        return pool->first
               + 2 * (unsigned)random_between(random, 0, pool->count / 2 - 1);
    if (halves)
        return 2 * pool->first
               + (unsigned)random_between(random, 0, 2 * pool->count - 1);
    return pool->first + (unsigned)random_between(random, 0, pool->count - 1);
}

static bool is_of_halves(char role)
{
    return role == 'w' || role == 'o';
}

static bool area_fits(uint64_t *random, const struct random_area *area, char role)
{
    if (area->access == C205_READ_ONLY && !one_in(random, 3))
        return false;
    switch (area->contents) {
    case BIT_STRINGS: return role == 'b';
    case INDICES: return role == 'x';
    case WILD_INDICES: return role == 'x' && one_in(random, 3);
    case FAR_INDICES: return role == 'x' && one_in(random, 2);
    case HALF_NUMBERS: return is_of_halves(role) || (role != 'b' && one_in(random, 6));
    default: return !strchr("bx", role) && (!is_of_halves(role) || one_in(random, 4));
    }
}

static const struct random_area *draw_area(uint64_t *random, char role)
{
    const struct random_area *area;
    do
        area = random_areas + random_between(random, 0, (int64_t)random_area_count - 1);
    while (!area_fits(random, area, role) && !one_in(random, 400));
    return area;
}

c205_word draw_descriptor(uint64_t *random, char role)
{
    const struct random_area *area = draw_area(random, role);
    int64_t words = (int64_t)area->words;
    int64_t at = one_in(random, 3) ? random_between(random, 0, words - 1)
                                   : random_between(random, 0, words / 3);
    uint64_t address = area->address + WORD * (uint64_t)at;
    if (role == 'b')
        address += (uint64_t)random_between(random, 0, WORD - 1);
    else if (one_in(random, 100))
        address += (uint64_t)random_between(random, 1, WORD - 1);
    else if (is_of_halves(role))
        address += HALF * (random_bits(random) & 1);
    if (role == 's')
        return (c205_word)random_between(random, 0, 6) << 48 | address;
    return draw_length(random) << 48 | address;
}

c205_word draw_code_address(uint64_t *random, const struct random_program *program)
{
    size_t i = (size_t)random_between(random, 0, (int64_t)program->insn_count - 1);
    uint64_t address = program_address(program, i);
    return one_in(random, 30) ? address + 8 : address;
}

/* Returns a vector of words of the program's own code. */
static c205_word code_vector(uint64_t *random, const struct random_program *program)
{
    uint64_t address = draw_code_address(random, program);
    return (c205_word)random_between(random, 1, 5) << 48 | address / WORD * WORD;
}

/* Returns a table in the code, on a read-only page, or at the end of a page. */
static c205_word table_elsewhere(uint64_t *random, const struct random_program *program)
{
    uint64_t before = (uint64_t)random_between(random, 0, 90);
    switch (random_between(random, 0, 2)) {
    case 0: return code_vector(random, program);
    case 1: return draw_length(random) << 48 | IN_PAGE(6, before);
    default:
        return draw_length(random) << 48
               | IN_PAGE(random_between(random, 2, 5), -before);
    }
}

static c205_word half_integers(uint64_t *random)
{
    c205_word left = (c205_word)draw_integer(random) & LOW_24;
    return left << HALF | ((c205_word)draw_integer(random) & LOW_24);
}

static c205_word preset(uint64_t *random, const struct random_program *program,
                        char role, unsigned i)
{
    c205_word length;
    switch (role) {
    case 'n': return word_number(random);
    case 'h': return half_numbers(random);
    case 'j': return half_integers(random);
    case 'i': return (c205_word)draw_integer(random) & UINT64_C(0xFFFFFFFFFFFF);
    case 'f':
        length = (c205_word)random_between(random, 0, 20);
        return length << 48 | (c205_word)random_between(random, 0, 50);
    case 'k': return draw_code_address(random, program);
    case 'p':
    case 'o':
    case 'q':
        if (i % 2 == 1)
            return (c205_word)random_between(random, one_in(random, 30) ? -2 : 0, 9)
                   & UINT64_C(0xFFFFFFFFFFFF);
        return draw_descriptor(random, role == 'q' ? 'b' : role);
    default:
        if (program->transfers && one_in(random, 3))
            return table_elsewhere(random, program);
        return one_in(random, 40) ? code_vector(random, program)
                                  : draw_descriptor(random, role);
    }
}

/* Returns a vector near the previous one. A vector of half words may instead be near a
 * vector of words. */
static c205_word near_another(uint64_t *random, const struct random_program *program,
                              char role, unsigned number)
{
    unsigned other = role == 'w' && one_in(random, 2) ? draw_register(random, 'v')
                                                      : number - 1;
    return program->registers[other]
           + (is_of_halves(role) ? HALF : WORD)
                 * (uint64_t)random_between(random, -3, 3);
}

/* Every fourth vector starts near another vector, so that both overlap. */
static void preset_registers(uint64_t *random, struct random_program *program)
{
    for (size_t p = 0; p < POOLS; p++)
        for (unsigned i = 0; i < pools[p].count; i++) {
            unsigned number = pools[p].first + i;
            char role = pools[p].role;
            bool near = strchr("vw", role) && i > 0 && one_in(random, 4);
            program->registers[number] = near ? near_another(random, program, role,
                                                             number)
                                              : preset(random, program, role, i);
        }
}

/* Chooses the start of a loop, which is in the first half of the program. */
static void preset_loop(uint64_t *random, struct random_program *program)
{
    int64_t half = (int64_t)program->insn_count / 2, most = one_in(random, 3) ? 90 : 25;
    program->registers[LOOP_COUNT] = (c205_word)random_between(random, 2, most);
    size_t first = (size_t)random_between(random, 0, half);
    program->registers[LOOP_BEGIN] = program_address(program, first);
}

/* Chooses a table for the scatter: a range of words around a word of the loop. The
 * stored words are numbers, few of which are instructions. */
static void preset_rewrites(uint64_t *random, struct random_program *program)
{
    uint64_t code = draw_code_address(random, program) / WORD * WORD;
    uint64_t before = WORD * (uint64_t)random_between(random, 0, 45);
    uint64_t page = code / PAGE_BITS * PAGE_BITS;
    c205_word length = (c205_word)random_between(random, 1, 6) << 48;
    int64_t list = 5000 + random_between(random, 0, 200);
    program->registers[REWRITE_LIST] = length | IN_PAGE(3, list);
    int64_t from = 100 + random_between(random, 0, 200);
    program->registers[REWRITE_FROM] = length | IN_PAGE(8, from);
    program->registers[REWRITE_TABLE] = code - page < before ? page : code - before;
}

/* ---- Whole programs ---------------------------------------------------- */

uint64_t program_address(const struct random_program *program, size_t i)
{
    uint64_t address = program->code;
    for (size_t k = 0; k < i && k < program->insn_count; k++)
        address += HALF * program->insns[k].halves;
    return address;
}

/* Returns any address of page 1. The program often continues on the next page. */
static uint64_t draw_beginning(uint64_t *random)
{
    uint64_t words = one_in(random, 3)
                         ? C205_PAGE_WORDS - (uint64_t)random_between(random, 1, 20)
                         : (uint64_t)random_between(random, 0, 200);
    return IN_PAGE(1, words) + HALF * (random_bits(random) & 1);
}

enum { ONE_LOOP_IN = 9, ONE_OF_TRANSFERS_IN = 5 };

struct random_program random_program(uint64_t seed)
{
    uint64_t random = seed;
    struct random_program program = { .seed = seed };
    random = random_bits(&random); /* so that seeds have unrelated numbers */
    program.model = (size_t)random_between(&random, 0, (int64_t)random_model_count - 1);
    program.code = draw_beginning(&random);
    program.loop = seed % ONE_LOOP_IN == 0;
    program.transfers = seed % ONE_OF_TRANSFERS_IN == 1;
    program.rewrites = seed % (2 * ONE_LOOP_IN) == 0;
    program.insn_count = (size_t)random_between(&random, 4, PROGRAM_INSNS);
    draw_insns(&random, &program);
    preset_registers(&random, &program);
    if (program.loop)
        preset_loop(&random, &program);
    if (program.rewrites)
        preset_rewrites(&random, &program);
    return program;
}
