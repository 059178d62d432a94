/* test_pages.c - which pages are known, which miss, which fault, and what that
 * costs: pages of all sizes, in memories of all sizes.
 *
 * Expected clocks follow from docs/timing.md: 30 for a miss, 1,000 more for a
 * fault.
 */
#include "tests/unit/clock_driver.h"

#include "tests/random.h"
#include "vm/time/pages.h"
#include "vm/tape.h"

enum { WORD = 64, MISS = 30, FAULT = 1000 };

static struct clock *pages_of(unsigned words, unsigned real_words, unsigned registers)
{
    char text[200];
    snprintf(text, sizeof text,
             "title T\nlike cyber205-2pipe-prior\npage.words %u words R\n"
             "memory.real_words %u words R\n"
             "translation.registers %u registers R\n",
             words, real_words, registers);
    return clock_of(text);
}

/* What has been met since the last reset. */
static void assert_met(struct clock *clock, uint64_t misses, uint64_t faults)
{
    clock_drain(clock);
    assert_int_equal(clocks_for(clock, C205_TRANSLATION_MISS), MISS * misses);
    assert_int_equal(clocks_for(clock, C205_PAGE_FAULT), FAULT * faults);
    clock_reset(clock);
}

/* An addition of two vectors of words into a third. */
static void add_vectors(struct clock *clock, const uint64_t words[3], size_t elements)
{
    struct effect effect = no_effect;
    effect.elements = elements;
    effect.touch_count = 3;
    for (size_t i = 0; i < 3; i++) {
        effect.touch[i].address = words[i] * WORD;
        effect.touch[i].bits = elements * WORD;
    }
    charge(clock, insn("ADDNV", 1, 2, 0), &effect);
}

static void gather(struct clock *clock, const c205_word *indices, size_t count,
                   unsigned step)
{
    struct effect effect = no_effect;
    effect.elements = effect.index_count = count;
    effect.indices = indices;
    effect.table_step = step;
    charge(clock, insn("VXTOV", 1, 2, 0), &effect);
}

/* ---- Large pages --------------------------------------------------------- */

TEST(depths)
{
    static const struct {
        uint64_t page;
        unsigned misses, faults;
    } cases
        [] = {
            { 1, 1, 1 }, { 1, 0, 0 }, { 2, 1, 1 }, { 1, 0, 0 },
            { 2, 0, 0 }, { 3, 1, 1 }, { 1, 1, 0 }, { 3, 0, 0 },
            { 4, 1, 1 }, { 2, 1, 0 }, { 5, 1, 1 }, /* page 1, used least recently, leaves */
            { 3, 1, 0 }, { 1, 1, 1 }, { 4, 1, 1 }
        };
    struct clock *clock = pages_of(65536, 4 * 65536, 2);
    for (size_t i = 0; i < COUNT(cases); i++) {
        at_address(clock, "LOD", cases[i].page * PAGE_BITS + 640);
        assert_met(clock, cases[i].misses, cases[i].faults);
    }
    clock_forget_pages(clock);
    at_address(clock, "STO", 4 * PAGE_BITS);
    assert_met(clock, 1, 1);
    clock_free(clock);
}

/* A vector across a page boundary; a gather from three pages. */
TEST(vectors)
{
    static const c205_word indices[] = { 3 * 65536, 4 * 65536, 3 * 65536 + 1,
                                         5 * 65536 };
    struct clock *clock = two_pipes();
    struct effect effect = no_effect;
    effect.elements = 100;
    effect.touch_count = 2;
    effect.touch[0].address = 3 * PAGE_BITS - WORD;
    effect.touch[0].bits = 100 * WORD;
    effect.touch[1].address = 9 * PAGE_BITS; /* an empty range */
    charge(clock, insn("ADDNV", 1, 2, 0), &effect);
    assert_total(clock, 51 + 2 * (MISS + FAULT) + 50);
    gather(clock, indices, 4, WORD);
    assert_met(clock, 2, 2);
    clock_free(clock);
}

/* ---- Small pages --------------------------------------------------------- */

/* 1,000 words from the last word of a page on. */
TEST(borders)
{
    static const struct {
        unsigned page_words;
        uint64_t pages;
    } cases[] = { { 512, 3 }, { 2048, 2 }, { 8192, 2 }, { 65536, 2 } };
    for (size_t i = 0; i < COUNT(cases); i++) {
        unsigned words = cases[i].page_words;
        uint64_t pages = cases[i].pages;
        struct clock *clock = pages_of(words, 1 << 20, 16);
        uint64_t operands[3] = { words - 1, 8 * words - 1, words - 1 };
        add_vectors(clock, operands, 1000);
        assert_total(clock, 51 + 2 * pages * (MISS + FAULT) + 500);
        add_vectors(clock, operands, 1000);
        assert_total(clock, 51 + 500);
        clock_free(clock);
    }
}

/* One word, then one more, over the border: a page, then two. */
TEST(one_word_over)
{
    struct clock *clock = pages_of(512, 1 << 20, 16);
    uint64_t operands[3] = { 1023, 1023, 1023 };
    add_vectors(clock, operands, 1);
    assert_met(clock, 1, 1);
    add_vectors(clock, operands, 2);
    assert_met(clock, 1, 1);
    at_address(clock, "LOD", 1535 * WORD);
    assert_met(clock, 0, 0);
    at_address(clock, "LOD", 1536 * WORD);
    assert_met(clock, 1, 1);
    clock_free(clock);
}

/* More pages in memory than registers: a long vector misses in every page,
 * each time, and never faults again. */
TEST(misses_without_faults)
{
    struct clock *clock = pages_of(512, 1 << 20, 16);
    uint64_t operands[3] = { 0, 512 * 1000, 512 * 1200 };
    add_vectors(clock, operands, 512 * 100);
    assert_total(clock, 51 + 300 * (MISS + FAULT) + 256 * 100);
    for (int i = 0; i < 3; i++) {
        add_vectors(clock, operands, 512 * 100);
        assert_total(clock, 51 + 300 * MISS + 256 * 100);
    }
    add_vectors(clock, operands, 512 * 5); /* 15 pages */
    assert_met(clock, 15, 0);
    add_vectors(clock, operands, 512 * 5);
    assert_met(clock, 0, 0);
    add_vectors(clock, operands, 512 * 6); /* the 17th page drives out the .. */
    assert_met(clock, 2 + 6, 0);
    add_vectors(clock, operands, 512 * 6); /* .. next, and so on */
    assert_met(clock, 18, 0);
    clock_free(clock);
}

/* 1 Mword holds 2,048 pages of 512 words and not one more. */
TEST(full_memory)
{
    struct clock *clock = pages_of(512, 1 << 20, 16);
    for (uint64_t page = 0; page < 2048; page++)
        at_address(clock, "LOD", page * 512 * WORD);
    assert_met(clock, 2048, 2048);
    for (uint64_t page = 0; page < 2048; page++)
        at_address(clock, "LOD", page * 512 * WORD);
    assert_met(clock, 2048, 0);
    at_address(clock, "LOD", 2048 * 512 * WORD);
    assert_met(clock, 1, 1);
    at_address(clock, "LOD", 512 * WORD); /* the next but one to leave */
    assert_met(clock, 1, 0);
    at_address(clock, "LOD", 0); /* it has left */
    assert_met(clock, 1, 1);
    clock_free(clock);
}

/* ---- Little memory ------------------------------------------------------- */

/* Fewer pages than one instruction needs: each operand drives out what the
 * next run of it wants first. */
TEST(thrashing)
{
    struct clock *clock = pages_of(512, 1100, 16);
    uint64_t operands[3] = { 0, 0, 0 };
    for (int i = 0; i < 3; i++) {
        add_vectors(clock, operands, 3 * 512);
        assert_total(clock, 51 + 9 * (MISS + FAULT) + 768);
    }
    add_vectors(clock, operands, 2 * 512);
    assert_met(clock, 1 + 1, 1 + 1);
    add_vectors(clock, operands, 2 * 512);
    assert_met(clock, 0, 0);
    clock_free(clock);
}

TEST(less_than_a_page)
{
    struct clock *clock = pages_of(65536, 1, 16);
    uint64_t operands[3] = { 0, 65536, 100 };
    add_vectors(clock, operands, 100);
    assert_total(clock, 51 + 3 * (MISS + FAULT) + 50);
    at_address(clock, "LOD", 0);
    at_address(clock, "STO", 65535 * WORD);
    assert_met(clock, 0, 0);
    clock_free(clock);
}

/* Without registers each look-up is a search. */
TEST(no_registers)
{
    struct clock *clock = pages_of(512, 1024, 0);
    for (int i = 0; i < 5; i++)
        at_address(clock, "LOD", 64);
    assert_met(clock, 5, 1);
    clock_free(clock);
}

/* ---- Gathers ------------------------------------------------------------- */

TEST(gathers)
{
    enum { RUN = 300 };
    c205_word indices[2 * RUN];
    struct clock *clock = pages_of(512, 1 << 20, 1);
    for (size_t i = 0; i < 2 * RUN; i++)
        indices[i] = i < RUN ? i : 512 - RUN + i; /* in two pages */
    gather(clock, indices, 2 * RUN, WORD);
    assert_met(clock, 2, 2);
    for (size_t i = 0; i < 2 * RUN; i++)
        indices[i] = 512 * (i % 2) + i / 2; /* by turns */
    gather(clock, indices, 2 * RUN, WORD);
    assert_met(clock, 2 * RUN, 0);
    gather(clock, indices, 2 * RUN, WORD / 2); /* half words: all in one */
    assert_met(clock, 1, 0);
    gather(clock, indices, 2 * RUN, WORD / 2);
    assert_met(clock, 0, 0);
    clock_free(clock);
}

/* From the end of the address space a gather goes on at its beginning. */
TEST(wrapped_gather)
{
    static const c205_word indices[] = { 0, (ADDRESS_MASK + 1) / WORD,
                                         (ADDRESS_MASK + 1) / WORD - 1 };
    struct clock *clock = pages_of(512, 1 << 20, 1);
    gather(clock, indices, 3, WORD);
    assert_met(clock, 2, 2);
    clock_free(clock);
}

/* ---- The list itself ----------------------------------------------------- */

/* The list as docs/timing.md has it, walked from its front. */
struct plain_list {
    size_t registers, capacity, count;
    uint64_t page[4096];
};

static void plain_touch(struct plain_list *list, uint64_t page, struct translation *met)
{
    size_t depth = 0;
    while (depth < list->count && list->page[depth] != page)
        depth++;
    bool resident = depth < list->count;
    met->misses += !resident || depth >= list->registers;
    met->faults += !resident;
    if (!resident && list->count < list->capacity)
        list->count++;
    else if (!resident)
        depth--;
    memmove(list->page + 1, list->page, depth * sizeof *list->page);
    list->page[0] = page;
}

static uint64_t chance = RANDOM_SEED;

/* Mostly pages used lately, some from anywhere, some at a stride. */
static uint64_t draw_page(uint64_t last, size_t capacity)
{
    uint64_t random = xorshift(&chance);
    switch (random % 4) {
    case 0: return xorshift(&chance) >> 31;
    case 1: return last + 1;
    case 2: return (last + 4096) & (ADDRESS_MASK >> 15);
    default: return xorshift(&chance) % (capacity + capacity / 2 + 2);
    }
}

/* Some words of records in a few pages, mostly, one word of all after another. */
static void touch_list(struct pages *pages, struct plain_list *list,
                       struct index_list *met_list, uint64_t page,
                       struct translation *expected, struct translation *met)
{
    enum { LIST = 700 };
    c205_word indices[LIST];
    size_t count = xorshift(&chance) % LIST;
    uint64_t spread = xorshift(&chance) % 3 ? 12 : 400, table = 0;
    for (size_t i = 0; i < count; i++)
        indices[i] = 512 * (page + xorshift(&chance) % (spread + 1))
                     + xorshift(&chance) % (i % 2 ? 512 : 8);
    for (int turn = 0; turn < 4; turn++) {
        for (size_t i = 0; i < count; i++)
            plain_touch(list,
                        (table + indices[i] * WORD) % (ADDRESS_MASK + 1) / (512 * WORD),
                        expected);
        index_list_meet(met_list, indices, count);
        pages_touch_indexed(pages, table, WORD, met_list, met);
        table += xorshift(&chance) % 3 ? WORD : 200 * WORD;
        if (count > 0)
            indices[0] += xorshift(&chance) % 8 / 7;
    }
}

static void compare_lists(size_t capacity, size_t registers)
{
    static struct plain_list list;
    struct translation expected = { 0, 0 }, met = { 0, 0 };
    struct pages pages;
    struct index_list met_list = { 0 };
    uint64_t page = 0;
    list.registers = registers;
    list.capacity = capacity;
    list.count = 0;
    assert_true(pages_init(&pages, 512, capacity * 512 + 511, registers));
    for (int i = 0; i < 6000; i++) {
        page = draw_page(page, capacity);
        plain_touch(&list, page, &expected);
        pages_touch(&pages, page * 512 * WORD, 1, &met);
        if (i % 64 == 0)
            touch_list(&pages, &list, &met_list, page, &expected, &met);
        assert_int_equal(met.misses, expected.misses);
        assert_int_equal(met.faults, expected.faults);
        if (xorshift(&chance) % 3000 == 0) {
            pages_forget(&pages);
            list.count = 0;
        }
    }
    index_list_free(&met_list);
    pages_free(&pages);
}

TEST(plain_list)
{
    static const size_t sizes[] = { 1, 2, 3, 16, 100, 2048 };
    enum { SIZES = COUNT(sizes) };
    for (size_t i = 0; i < SIZES; i++) {
        compare_lists(sizes[i], 0);
        for (size_t k = 0; k < SIZES; k++)
            compare_lists(sizes[i], sizes[k]);
    }
}

/* ---- On a tape ----------------------------------------------------------- */

enum { TAPE_BYTES = 1 << 16 };

struct bytes {
    size_t count;
    unsigned char byte[TAPE_BYTES];
};

static bool append(void *context, const void *more, size_t count)
{
    struct bytes *bytes = context;
    assert_true(bytes->count + count <= TAPE_BYTES);
    memcpy(bytes->byte + bytes->count, more, count);
    bytes->count += count;
    return true;
}

static void write_clock(struct clock *clock, struct bytes *bytes)
{
    c205_error error;
    struct tape tape = tape_to(append, bytes, &error);
    bytes->count = 0;
    clock_walk(clock, &tape);
    assert_false(tape.failed);
}

static bool read_clock(struct clock *clock, const struct bytes *bytes,
                       c205_error *error)
{
    struct tape tape = tape_from(bytes->byte, bytes->count, error);
    clock_walk(clock, &tape);
    return !tape.failed;
}

static void use_pages(struct clock *clock, int count, uint64_t seed)
{
    for (int i = 0; i < count; i++)
        at_address(clock, "LOD", xorshift(&seed) % 60 * 512 * WORD);
    clock_drain(clock);
}

/* A clock put in another one's place meets with the same. */
TEST(saved)
{
    static struct bytes bytes, again;
    c205_error error;
    struct clock *clock = pages_of(512, 20000, 7);
    struct clock *other = pages_of(512, 20000, 7);
    for (int uses = 0; uses < 200; uses += 9) {
        use_pages(clock, uses, 5);
        use_pages(other, 30, 6);
        write_clock(clock, &bytes);
        assert_true(read_clock(other, &bytes, &error));
        write_clock(other, &again);
        assert_int_equal(again.count, bytes.count);
        assert_memory_equal(again.byte, bytes.byte, bytes.count);
        use_pages(clock, 300, 7);
        use_pages(other, 300, 7);
        assert_int_equal(clock_now(other), clock_now(clock));
    }
    clock_free(clock);
    clock_free(other);
}

static void assert_refused(struct clock *clock, const struct bytes *bytes)
{
    c205_error error = { "" };
    assert_false(read_clock(clock, bytes, &error));
    assert_string_equal(error.message,
                        "the list of pages of the saved machine is wrong");
}

/* The list ends a clock: its last pages are the last words. */
TEST(damaged)
{
    static struct bytes bytes;
    struct clock *clock = pages_of(512, 20000, 7);
    c205_error error;
    use_pages(clock, 100, 5);
    write_clock(clock, &bytes);
    assert_true(read_clock(clock, &bytes, &error));
    unsigned char *last = bytes.byte + bytes.count - TAPE_WORD_BYTES;
    unsigned char kept[TAPE_WORD_BYTES];
    memcpy(kept, last, sizeof kept);
    memcpy(last, last - TAPE_WORD_BYTES, sizeof kept); /* a page twice */
    assert_refused(clock, &bytes);
    memcpy(last, last - 20 * TAPE_WORD_BYTES, sizeof kept);
    assert_refused(clock, &bytes);
    memcpy(last, kept, sizeof kept);
    last[3] = 2; /* a page beyond the end of the address space */
    assert_refused(clock, &bytes);
    memcpy(last, kept, sizeof kept);
    assert_true(read_clock(clock, &bytes, &error));
    clock_free(clock);
}
