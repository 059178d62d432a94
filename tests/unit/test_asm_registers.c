/* test_asm_registers.c - names of registers. Warnings about declarations, written by
 * hand and random, are compared with a rule that decides which of them share a register
 * without .share. A missing or misplaced warning fails here. */
#include "tests/unit/asm_helper.h"

#include "tests/random.h"

static const struct asm_error warnings[] = {
    { " .reg a, r5\n .reg b, r6\n .reg h, h8\n .reg i, h9\n", 0, 0, "" },
    { " .reg a, r5\n .reg b, r5\n", 2, 7,
      "r5 is already 'a', in test.s:1; declare names that share a register"
      " with .share" },
    { " .regs r5, a, b\n .regs r4, c, d\n", 2, 15, "r5 is already 'a'" },
    { " .reg a, r5\n .reg h, h11\n", 2, 7, "h11 is already 'a'" },
    { " .reg h, h10\n .reg a, r5\n", 2, 7, "r5 is already 'h'" },
    { " .reg h, h10\n .reg i, h10\n", 2, 7, "h10 is already 'h'" },
    /* Names of r0 never conflict. */
    { " .reg a, r0\n .reg b, r0\n .reg h, h1\n", 0, 0, "" },
    /* A repeated declaration, and aliases. */
    { " .reg a, r5\n .reg a, r5\n", 0, 0, "" },
    { " .reg a, r5\n .reg b, a\n .reg a, a\n .reg c, b\n", 0, 0, "" },
    { " .regs r5, a, b\n .regs a, c, d\n", 0, 0, "" },
    { " .reg b, r6\n .reg a, r5\n .regs a, c, d\n", 3, 14,
      "r6 is already 'b', in test.s:1" },
    { " .reg a, r5\n .reg b, a\n .reg a, r6\n .reg c, r5\n", 4, 7,
      "r5 is already 'b', in test.s:2" },
    /* A name may be given to another register. */
    { " .reg a, r5\n .reg a, r6\n .reg b, r5\n", 0, 0, "" },
    { " .reg a, r5\n .reg a, r6\n .reg b, r6\n", 3, 7, "already 'a'" },
    /* .share */
    { " .reg a, r5\n .share\n .reg b, r5\n .endshare\n", 0, 0, "" },
    { " .share\n .reg a, r5\n .endshare\n .reg b, r5\n", 0, 0, "" },
    { " .share\n .reg a, r5\n .reg b, r5\n .endshare\n", 3, 7, "'a'" },
    { " .reg a, r5\n .share x\n .reg b, r5\n .endshare\n", 3, 7, "'a'" },
    { " .share x\n .reg a, r5\n .endshare\n .share x\n .reg b, r5\n .endshare\n", 0, 0,
      "" },
    { " .share x\n .reg a, r5\n .endshare\n .share y\n .reg b, r5\n .endshare\n", 5, 7,
      "already 'a'" },
    { " .share x\n .reg a, r5\n .endshare\n"
      " .share y\n .share x\n .reg b, r5\n .endshare\n .endshare\n",
      0, 0, "" },
    { " .share\n .share x\n .reg a, r5\n .endshare\n"
      " .share y\n .reg b, r5\n .endshare\n .endshare\n",
      6, 7, "already 'a'" },
    { " .share\n .reg a, r5\n .share x\n .reg b, r5\n .endshare\n .endshare\n", 4, 7,
      "already 'a'" },
    { " .share\n .reg a, r5\n .share\n .reg b, r5\n .endshare\n .endshare\n", 0, 0,
      "" },
    /* An alias belongs to the block of the name to which it refers. */
    { " .share x\n .reg a, r5\n .endshare\n .reg b, a\n"
      " .share x\n .reg c, r5\n .endshare\n",
      0, 0, "" },
    /* Every earlier name of a register is an owner, not only the last one. */
    { " .reg a, r5\n .share\n .reg b, r5\n .endshare\n .reg c, r5\n", 5, 7,
      "already 'a', in test.s:1" },
};

TEST_CALL(warnings, assert_asm_warnings(warnings, COUNT(warnings)))

TEST(errors)
{
    static const char nested[] = " .rept 65\n .share\n .endr\n"
                                 " .rept 65\n .endshare\n .endr\n";
    static const struct asm_error errors[] = {
        { " .share\n", 1, 2, "this .share has no .endshare" },
        { " .endshare\n", 1, 2, ".endshare without .share" },
        { " .share 5\n .endshare\n", 1, 9, "expected a word" },
        { " .share a b\n .endshare\n", 1, 11, "the end of the statement" },
        { " .share\n .endshare 5\n", 2, 12, "the end of the statement" },
    };
    struct diagnostics found = { 0 }, first;
    assert_asm_errors(errors, COUNT(errors));
    /* Only the first error is compared. */
    assert_null(assemble_text("test.s", nested, NULL, &found));
    first = found;
    first.count = 1;
    assert_one_error(&first, nested, 2, 2, "more than 64 nested");
    diagnostics_free(&found);
}

/* The object records the names of registers, and the places where they are used. */
TEST(mentions)
{
    SCOPED(object) *object = good(" .regs r5, a, b\n"
                                  " .reg h, h20\n"
                                  " .reg c, b\n"
                                  " ADDN a, c, r9\n"
                                  " .reg a, r5\n"
                                  " ADDNV [a, b], c, [a] ? [b]\n"
                                  " EXH h, 5\n"
                                  " EXIT\n");
    static const struct {
        uint64_t address;
        size_t name;
    } mentions[] = {
        { 0x400000, 0 }, { 0x400000, 3 }, { 0x400020, 4 }, { 0x400020, 1 },
        { 0x400020, 3 }, { 0x400020, 4 }, { 0x400020, 1 }, { 0x400060, 2 }
    };
    assert_int_equal(object->register_count, 5);
    assert_string_equal(object->registers[2].name, "h");
    assert_true(object->registers[2].half);
    assert_int_equal(object->registers[2].number, 20);
    assert_int_equal(object->registers[3].line, 3);
    assert_int_equal(object->registers[3].owner, 1); /* c is b */
    assert_int_equal(object->registers[4].owner, 0); /* a is a */
    assert_int_equal(object->mention_count, COUNT(mentions));
    for (size_t i = 0; i < object->mention_count; i++) {
        assert_int_equal(object->mentions[i].address, mentions[i].address);
        assert_int_equal(object->mentions[i].name, mentions[i].name);
    }
}

/* ---- Random declarations ------------------------------------------------ */

enum { LINES = 40, NAMES = 6, REGISTERS = 4, WORDS = 3, DEPTH = 4 };

/* A declaration in its blocks, each with a number and a word (0: no word). */
struct given {
    size_t name, depth;
    unsigned number, blocks[DEPTH], words[DEPTH];
    size_t owner;
    bool holds;
};

static bool stands_in(const struct given *given, unsigned block)
{
    for (size_t i = 0; i < given->depth; i++)
        if (given->blocks[i] == block)
            return true;
    return false;
}

static bool agree(const struct given *a, const struct given *b)
{
    for (size_t i = 0; i < a->depth; i++) {
        if (stands_in(b, a->blocks[i]))
            continue;
        if (a->words[i] == 0)
            return true;
        for (size_t j = 0; j < b->depth; j++)
            if (a->words[i] == b->words[j] && !stands_in(a, b->blocks[j]))
                return true;
    }
    return false;
}

static bool clashes(const struct given *given, size_t last)
{
    const struct given *new = &given[last];
    for (size_t i = 0; i < last; i++)
        if (given[i].holds
            && given[i].number == new->number &&given[i].owner != new->owner
            && !agree(&given[i], new) && !agree(new, &given[i]))
            return true;
    return false;
}

struct declarations {
    char text[4096];
    struct given given[LINES];
    size_t count, line;
    struct given around; /* the open blocks */
    unsigned blocks;
    bool reported[LINES
                  + 2 * DEPTH]; /* lines for which a warning is expected; the first line
                                 * is 1 */
};

static void say(struct declarations *declarations, const char *text)
{
    strcat(declarations->text, text);
    declarations->line++;
}

static void open_block(struct declarations *declarations, unsigned word)
{
    struct given *around = &declarations->around;
    say(declarations, formatted(word ? " .share w%u\n" : " .share\n", word));
    around->blocks[around->depth] = ++declarations->blocks;
    around->words[around->depth++] = word;
}

static void close_block(struct declarations *declarations)
{
    say(declarations, " .endshare\n");
    declarations->around.depth--;
}

/* Declares a name by a register number, or by another valid name. */
static void name_one(struct declarations *declarations, uint64_t *seed)
{
    struct given *given = declarations->given, *new = &given[declarations->count];
    size_t other = declarations->count > 0 ? xorshift(seed) % declarations->count : 0;
    char text[40];
    *new = declarations->around;
    new->name = xorshift(seed) % NAMES;
    new->number = 5 + (unsigned)(xorshift(seed) % REGISTERS);
    new->owner = declarations->count;
    if (declarations->count > 0 && given[other].holds
        && given[other].name != new->name &&xorshift(seed) % 3 == 0) {
        snprintf(text, sizeof text, " .reg n%zu, n%zu\n", new->name, given[other].name);
        size_t name = new->name;
        *new = given[other];
        new->name = name;
    } else {
        snprintf(text, sizeof text, " .reg n%zu, r%u\n", new->name, new->number);
    }
    for (size_t i = 0; i < declarations->count; i++)
        if (given[i].holds && given[i].name == new->name) {
            given[i].holds = false;
            if (given[i].number == new->number &&new->owner == declarations->count)
                new->owner = given[i].owner;
        }
    say(declarations, text);
    declarations->reported[declarations->line] = !strchr(strchr(text, ','), 'n')
                                                 && clashes(given, declarations->count);
    new->holds = true;
    declarations->count++;
}

static void make_declarations(struct declarations *declarations, uint64_t *seed)
{
    memset(declarations, 0, sizeof *declarations);
    while (declarations->line < LINES) {
        size_t choice = xorshift(seed) % 6, *depth;
        depth = &declarations->around.depth;
        if (choice == 0 && *depth < DEPTH)
            open_block(declarations, (unsigned)(xorshift(seed) % WORDS));
        else if (choice == 1 && *depth > 0)
            close_block(declarations);
        else
            name_one(declarations, seed);
    }
    while (declarations->around.depth > 0)
        close_block(declarations);
}

TEST(random_declarations)
{
    uint64_t seed = RANDOM_SEED;
    size_t reported = 0, silent = 0;
    for (size_t i = 0; i < 2000; i++) {
        static struct declarations declarations;
        SCOPED_VALUE(diagnostics) found = { 0 };
        size_t next = 0;
        make_declarations(&declarations, &seed);
        SCOPED(object) *object = NON_NULL(
            assemble_text("test.s", declarations.text, NULL, &found));
        for (size_t line = 1; line <= LINES; line++) {
            bool here = next < found.count && found.items[next].line == line;
            FAIL_IF(here != declarations.reported[line], "%sline %zu",
                    declarations.text, line);
            next += here;
            reported += here;
            silent += !here;
        }
        assert_int_equal(next, found.count);
    }
    assert_true(reported > 1000 && silent > 1000);
}
