/* test_memory.c - the memory of a machine is compared with its rules: access rights,
 * pages that are allocated on access or unmapped, words across pages, and code marks.
 * Strings of bits at every alignment are compared with a loop over bits. A span that
 * ends at another bit, or a page that keeps an old word or right, fails here. */
#include "tests/unit/unit.h"
#include "vm/memory.h"

#define PAGE_BITS (UINT64_C(1) << PAGE_SHIFT)
#define SPACE (ADDRESS_MASK + 1)

static struct memory *memory_of(uint64_t address, size_t words)
{
    struct memory *memory = NON_NULL(calloc(1, sizeof *memory));
    memory_init(memory);
    assert_true(memory_map(memory, address, words, C205_READ_WRITE, &failure));
    return memory;
}

static void free_memory_at(struct memory **memory)
{
    memory_free(*memory);
    free(*memory);
}

/* Checks that an access has the expected trap and fault address. The expected address
 * is 1 if the access sets no address. */
static void assert_check(const struct memory *memory, uint64_t address, uint64_t count,
                         bool stores, c205_trap trap, uint64_t expected)
{
    uint64_t fault = 1;
    assert_int_equal(memory_check(memory, address, count, stores, &fault), trap);
    assert_int_equal(fault, expected);
}

static void assert_word(struct memory *memory, uint64_t address, c205_word expected)
{
    c205_word word = ~expected;
    assert_int_equal(memory_load(memory, address, &word), C205_TRAP_NONE);
    assert_int_equal(word, expected);
}

static void assert_stores(struct memory *memory, uint64_t address, c205_word word)
{
    assert_int_equal(memory_store(memory, address, word), C205_TRAP_NONE);
}

TEST(check)
{
    SCOPED(memory) *memory = memory_of(PAGE_BITS, 2 * C205_PAGE_WORDS);
    assert_check(memory, 0, 0, true, C205_TRAP_NONE, 1);
    assert_check(memory, PAGE_BITS, 2 * PAGE_BITS, true, C205_TRAP_NONE, 1);
    assert_check(memory, PAGE_BITS + 1, 2 * PAGE_BITS, false,
                 C205_TRAP_UNMAPPED_ADDRESS, 3 * PAGE_BITS);
    assert_true(memory_map(memory, 2 * PAGE_BITS, 1, C205_READ_ONLY, &failure));
    assert_check(memory, PAGE_BITS, PAGE_BITS + 1, true, C205_TRAP_PROTECTED_ADDRESS,
                 2 * PAGE_BITS);
    assert_check(memory, PAGE_BITS, PAGE_BITS + 1, false, C205_TRAP_NONE, 1);
}

/* A page is allocated on its first access. */
TEST(untouched)
{
    size_t pages = 200000; /* corresponds to 105 GB */
    SCOPED(memory) *memory = memory_of(0, 1);
    uint64_t last = (pages - 1) * PAGE_BITS;
    assert_true(
        memory_map(memory, 0, pages * C205_PAGE_WORDS, C205_WHEN_TOUCHED, &failure));
    assert_int_equal(memory_next_page(memory, 7 * PAGE_BITS), 7 * PAGE_BITS);
    assert_int_equal(memory_next_page(memory, last + PAGE_BITS), SPACE);
    assert_word(memory, last, 0);
    assert_stores(memory, last - PAGE_BITS, 5);
    assert_word(memory, last, 0);
    assert_check(memory, 9 * PAGE_BITS - 64, 128, true, C205_TRAP_NONE, 1);
    assert_true(memory_map(memory, 3 * PAGE_BITS, 1, C205_READ_ONLY, &failure));
    assert_int_equal(memory_store(memory, 3 * PAGE_BITS, 5),
                     C205_TRAP_PROTECTED_ADDRESS);
    assert_word(memory, 3 * PAGE_BITS, 0);
    assert_true(memory_map(memory, 3 * PAGE_BITS, 1, C205_READ_WRITE, &failure));
    assert_stores(memory, 3 * PAGE_BITS, 5);
    assert_word(memory, 4 * PAGE_BITS, 0);
    memory_clear(memory);
    assert_int_equal(memory_next_page(memory, 0), SPACE);
}

/* Pages that are unmapped and mapped again have no words, code marks or protection. */
TEST(clear)
{
    SCOPED(memory) *memory = memory_of(PAGE_BITS, 1);
    assert_stores(memory, PAGE_BITS, 5);
    memory_mark_code(memory, PAGE_BITS);
    memory_clear(memory);
    assert_check(memory, PAGE_BITS, 64, false, C205_TRAP_UNMAPPED_ADDRESS, PAGE_BITS);
    assert_true(memory_map(memory, 0, 1, C205_READ_WRITE, &failure));
    assert_word(memory, 0, 0);
    assert_false(memory_page(memory, 0)->holds_code);
    assert_check(memory, PAGE_BITS, 64, false, C205_TRAP_UNMAPPED_ADDRESS, PAGE_BITS);
}

TEST(end_of_space)
{
    SCOPED(memory) *memory = memory_of(SPACE - 64, 1);
    c205_error error = { "" };
    assert_false(memory_map(memory, SPACE - 64, 2, C205_READ_WRITE, &error));
    assert_string_not_equal(error.message, "");
    assert_false(memory_map(memory, SPACE, 1, C205_READ_WRITE, &error));
    assert_true(memory_map(memory, 0, 1, C205_READ_WRITE, &error));
    assert_check(memory, SPACE - 64, 64, true, C205_TRAP_NONE, 1);
    assert_check(memory, SPACE - 64, 65, true, C205_TRAP_UNMAPPED_ADDRESS, 0);
}

TEST(words_across_pages)
{
    SCOPED(memory) *memory = memory_of(0, 2 * C205_PAGE_WORDS);
    c205_word words[100], back[100];
    uint64_t address = PAGE_BITS - 50 * 64;
    for (size_t i = 0; i < 100; i++)
        words[i] = i * 0x0123456789ABCDEF;
    memory_write_words(memory, address, words, 100);
    memory_read_words(memory, address, back, 100);
    assert_memory_equal(words, back, sizeof words);
    size_t count = 100;
    assert_int_equal(*memory_read_span(memory, address, &count), 0);
    assert_int_equal(count, 50);
}

/* The result is compared with a loop over single bits, at every alignment. */
TEST(bits)
{
    SCOPED(memory) *memory = memory_of(0, 2 * C205_PAGE_WORDS);
    uint64_t bits[4] = { 0xF0F1F2F3F4F5F6F7, 0x0123456789ABCDEF, 0xAAAA5555CCCC3333,
                         UINT64_MAX };
    for (size_t count = 0; count < 250; count += 7)
        for (uint64_t skip = 0; skip < 130; skip++) {
            uint64_t back[4] = { 1, 1, 1, 1 }, edge[2];
            uint64_t address = PAGE_BITS - 64 + skip;
            c205_word ones[8];
            memset(ones, 0xFF, sizeof ones);
            memory_write_words(memory, PAGE_BITS - 128, ones, 8);
            memory_write_bits(memory, address, bits, count);
            memory_read_bits(memory, address, back, count);
            for (size_t i = 0; i < (count + 63) / 64 * 64; i++)
                assert_int_equal(back[i / 64] >> (63 - i % 64) & 1,
                                 i < count && bits[i / 64] >> (63 - i % 64) & 1);
            memory_read_bits(memory, address - 1, &edge[0], 1);
            memory_read_bits(memory, address + count, &edge[1], 1);
            assert_int_equal(edge[0] >> 63 & edge[1] >> 63, 1);
        }
}

TEST(code_marks)
{
    SCOPED(memory) *memory = memory_of(0, C205_PAGE_WORDS);
    uint64_t changes = memory->code_changes;
    c205_word words[200] = { 0 };
    memory_mark_code(memory, 100 * 64);
    assert_stores(memory, 99 * 64, 1);
    assert_stores(memory, 101 * 64, 1);
    memory_write_words(memory, 0, words, 100);
    memory_write_words(memory, 101 * 64, words, 99);
    assert_int_equal(memory->code_changes, changes);
    memory_write_words(memory, 0, words, 200);
    assert_int_equal(memory->code_changes, changes + 1);
    memory_mark_code(memory, 100 * 64);
    assert_stores(memory, 100 * 64, 1);
    assert_int_equal(memory->code_changes, changes + 2);
    assert_stores(memory, 100 * 64, 1);
    assert_int_equal(memory->code_changes, changes + 2);
}

/* A lookup through the cache finds the same page as a lookup without it. */
TEST(near_pages)
{
    uint64_t alike = NEAR_PAGES * PAGE_BITS; /* uses the same cache slot as page 0 */
    SCOPED(memory) *memory = memory_of(0, 2 * C205_PAGE_WORDS);
    assert_null(memory_near(memory, alike));
    assert_ptr_equal(memory_near(memory, 64)->word, memory_page(memory, 0)->word);
    assert_true(memory_near(memory, 64)->stores);
    assert_null(memory_near(memory, alike));
    assert_true(memory_map(memory, alike, 1, C205_READ_WRITE, &failure));
    assert_ptr_equal(memory_near(memory, alike)->word,
                     memory_page(memory, alike)->word);
    assert_ptr_equal(memory_near(memory, 0)->word, memory_page(memory, 0)->word);
    assert_true(memory_map(memory, 0, 1, C205_READ_ONLY, &failure));
    assert_false(memory_near(memory, 0)->stores);
    assert_true(memory_map(memory, 0, 1, C205_READ_WRITE, &failure));
    assert_true(memory_near(memory, 0)->stores);
    assert_true(memory_near(memory, PAGE_BITS)->stores);
    memory_mark_code(memory, PAGE_BITS + 640);
    assert_false(memory_near(memory, PAGE_BITS)->stores);
    assert_true(memory_near(memory, 0)->stores);
    memory_clear(memory);
    assert_null(memory_near(memory, 0));
}
