/* test_pages.c - known pages, translation misses and page faults. Pages of any size in
 * memories of any size are compared with the list of docs/timing.md, searched from its
 * front, for ranges and index lists. Their clocks, 30 for a miss and 1,000 more for a
 * fault, are compared with cases computed by hand. A page that leaves too early, or a
 * damaged list that is restored, fails here. */
#include "tests/unit/clock_driver.h"
#include "tests/unit/saved_machine.h"

#include "tests/random.h"
#include "vm/time/pages.h"
#include "vm/serializer.h"

enum { WORD = 64, MISS = 30, FAULT = 1000 };

SCOPED_BY_FREE(clock);

static struct clock *pages_of(unsigned words, unsigned real_words, unsigned registers)
{
    return clock_of(
        formatted("title T\nlike cyber205-2pipe-prior\npage.words %u words R\n"
                  "memory.real_words %u words R\n"
                  "translation.registers %u registers R\n",
                  words, real_words, registers));
}

/* Compares the misses and faults since the last reset. */
static void assert_met(struct clock *clock, uint64_t misses, uint64_t faults)
{
    clock_drain(clock);
    assert_int_equal(clocks_for(clock, C205_TRANSLATION_MISS), MISS * misses);
    assert_int_equal(clocks_for(clock, C205_PAGE_FAULT), FAULT * faults);
    clock_reset(clock);
}

TEST(depths)
{
    static const struct {
        uint64_t page;
        unsigned misses, faults;
    } cases
        [] = { { 1, 1, 1 }, { 1, 0, 0 }, { 2, 1, 1 }, { 1, 0, 0 },
               { 2, 0, 0 }, { 3, 1, 1 }, { 1, 1, 0 }, { 3, 0, 0 },
               { 4, 1, 1 }, { 2, 1, 0 }, { 5, 1, 1 }, /* the LRU page, 1, is evicted */
               { 3, 1, 0 }, { 1, 1, 1 }, { 4, 1, 1 } };
    SCOPED(clock) *clock = pages_of(65536, 4 * 65536, 2);
    for (size_t i = 0; i < COUNT(cases); i++) {
        at_address(clock, "LOD", cases[i].page * PAGE_BITS + 640);
        assert_met(clock, cases[i].misses, cases[i].faults);
    }
    clock_forget_pages(clock);
    at_address(clock, "STO", 4 * PAGE_BITS);
    assert_met(clock, 1, 1);
}

/* ---- The list ------------------------------------------------------------ */

/* The list of docs/timing.md, searched from its front. */
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

/* Accesses a range of up to three pages. In one case of four, accesses a single bit. */
static void touch_range(struct pages *pages, struct plain_list *list, uint64_t page,
                        struct translation *expected, struct translation *met)
{
    uint64_t begin = page * 512 * WORD + xorshift(&chance) % (512 * WORD);
    uint64_t bits = xorshift(&chance) % 4 ? xorshift(&chance) % (1024 * WORD) : 1;
    for (uint64_t at = begin / 512 / WORD;
         bits && at <= (begin + bits - 1) / 512 / WORD; at++)
        plain_touch(list, at % ((ADDRESS_MASK + 1) / 512 / WORD), expected);
    pages_touch_all(pages, begin, bits, met);
}

/* Returns a recently used page, a random page, or a page at a stride. */
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

/* Accesses words, usually records in a few pages, one field after another. */
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
    SCOPED_VALUE(pages) pages;
    SCOPED_VALUE(index_list) met_list = { 0 };
    uint64_t page = 0;
    list.registers = registers;
    list.capacity = capacity;
    list.count = 0;
    assert_true(pages_init(&pages, 512, capacity * 512 + 511, registers));
    for (int i = 0; i < 6000; i++) {
        page = draw_page(page, capacity);
        touch_range(&pages, &list, page, &expected, &met);
        if (i % 64 == 0)
            touch_list(&pages, &list, &met_list, page, &expected, &met);
        assert_int_equal(met.misses, expected.misses);
        assert_int_equal(met.faults, expected.faults);
        if (xorshift(&chance) % 3000 == 0) {
            pages_forget(&pages);
            list.count = 0;
        }
    }
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

/* ---- Serialization ------------------------------------------------------- */

static void write_clock(struct clock *clock, struct bytes *bytes)
{
    struct serializer tape = serializer_to(append, bytes, &failure);
    bytes->count = 0;
    clock_walk(clock, &tape);
    assert_false(tape.failed);
}

static bool read_clock(struct clock *clock, const struct bytes *bytes,
                       c205_error *error)
{
    struct serializer tape = serializer_from(bytes->byte, bytes->count, error);
    clock_walk(clock, &tape);
    return !tape.failed;
}

static void use_pages(struct clock *clock, int count, uint64_t seed)
{
    for (int i = 0; i < count; i++)
        at_address(clock, "LOD", xorshift(&seed) % 60 * 512 * WORD);
    clock_drain(clock);
}

/* A restored clock finds the same pages. */
TEST(saved)
{
    static struct bytes bytes, again;
    SCOPED(clock) *clock = pages_of(512, 20000, 7);
    SCOPED(clock) *other = pages_of(512, 20000, 7);
    for (int uses = 0; uses < 200; uses += 9) {
        use_pages(clock, uses, 5);
        use_pages(other, 30, 6);
        write_clock(clock, &bytes);
        assert_true(read_clock(other, &bytes, &failure));
        write_clock(other, &again);
        assert_int_equal(again.count, bytes.count);
        assert_memory_equal(again.byte, bytes.byte, bytes.count);
        use_pages(clock, 300, 7);
        use_pages(other, 300, 7);
        assert_int_equal(clock_now(other), clock_now(clock));
    }
}

static void assert_refused(struct clock *clock, const struct bytes *bytes)
{
    c205_error error = { "" };
    assert_false(read_clock(clock, bytes, &error));
    assert_string_equal(error.message,
                        "the list of pages of the saved machine is invalid");
}

/* The list is at the end of a saved clock. The last words are its last pages. */
TEST(damaged)
{
    static struct bytes bytes;
    SCOPED(clock) *clock = pages_of(512, 20000, 7);
    use_pages(clock, 100, 5);
    write_clock(clock, &bytes);
    assert_true(read_clock(clock, &bytes, &failure));
    unsigned char *last = bytes.byte + bytes.count - SERIALIZER_WORD_BYTES;
    unsigned char kept[SERIALIZER_WORD_BYTES];
    memcpy(kept, last, sizeof kept);
    memcpy(last, last - SERIALIZER_WORD_BYTES, sizeof kept); /* the same page twice */
    assert_refused(clock, &bytes);
    memcpy(last, last - 20 * SERIALIZER_WORD_BYTES, sizeof kept);
    assert_refused(clock, &bytes);
    memcpy(last, kept, sizeof kept);
    last[3] = 2; /* a page after the end of the address space */
    assert_refused(clock, &bytes);
    memcpy(last, kept, sizeof kept);
    assert_true(read_clock(clock, &bytes, &failure));
}
