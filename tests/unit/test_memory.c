/* test_memory.c - the memory of a machine is compared with its rules, and strings of
 * bits at every alignment with a loop over bits: access rights, pages that are
 * allocated on access or unmapped, words across pages and marks of code. A span that
 * ends at another bit, or a page that keeps an old word or right, fails here.
 */
#include "tests/unit/unit.h"
#include "vm/memory.h"

#define PAGE_BITS (UINT64_C(1) << PAGE_SHIFT)
#define SPACE (ADDRESS_MASK + 1)

static struct memory *memory_of(uint64_t address, size_t words)
{
    struct memory *memory = calloc(1, sizeof *memory);
    c205_error error;
    assert_non_null(memory);
    memory_init(memory);
    assert_true(memory_map(memory, address, words, C205_READ_WRITE, &error));
    return memory;
}

static void let_go(struct memory *memory)
{
    memory_free(memory);
    free(memory);
}

TEST(check)
{
    struct memory *memory = memory_of(PAGE_BITS, 2 * C205_PAGE_WORDS);
    c205_error error;
    uint64_t fault = 1;
    assert_int_equal(memory_check(memory, 0, 0, true, &fault), C205_TRAP_NONE);
    assert_int_equal(memory_check(memory, PAGE_BITS, 2 * PAGE_BITS, true, &fault),
                     C205_TRAP_NONE);
    assert_int_equal(fault, 1);
    assert_int_equal(memory_check(memory, PAGE_BITS + 1, 2 * PAGE_BITS, false, &fault),
                     C205_TRAP_UNMAPPED_ADDRESS);
    assert_int_equal(fault, 3 * PAGE_BITS);
    assert_true(memory_map(memory, 2 * PAGE_BITS, 1, C205_READ_ONLY, &error));
    assert_int_equal(memory_check(memory, PAGE_BITS, PAGE_BITS + 1, true, &fault),
                     C205_TRAP_PROTECTED_ADDRESS);
    assert_int_equal(fault, 2 * PAGE_BITS);
    assert_int_equal(memory_check(memory, PAGE_BITS, PAGE_BITS + 1, false, &fault),
                     C205_TRAP_NONE);
    let_go(memory);
}

/* A page is allocated on its first access. */
TEST(untouched)
{
    size_t pages = 200000; /* 105 GB */
    struct memory *memory = memory_of(0, 1);
    uint64_t last = (pages - 1) * PAGE_BITS, fault;
    c205_error error;
    c205_word word = 1;
    assert_true(
        memory_map(memory, 0, pages * C205_PAGE_WORDS, C205_WHEN_TOUCHED, &error));
    assert_int_equal(memory_next_page(memory, 7 * PAGE_BITS), 7 * PAGE_BITS);
    assert_int_equal(memory_next_page(memory, last + PAGE_BITS), SPACE);
    assert_int_equal(memory_load(memory, last, &word), C205_TRAP_NONE);
    assert_int_equal(word, 0);
    assert_int_equal(memory_store(memory, last - PAGE_BITS, 5), C205_TRAP_NONE);
    assert_int_equal(memory_load(memory, last, &word), C205_TRAP_NONE);
    assert_int_equal(word, 0);
    assert_int_equal(memory_check(memory, 9 * PAGE_BITS - 64, 128, true, &fault),
                     C205_TRAP_NONE);
    assert_true(memory_map(memory, 3 * PAGE_BITS, 1, C205_READ_ONLY, &error));
    assert_int_equal(memory_store(memory, 3 * PAGE_BITS, 5),
                     C205_TRAP_PROTECTED_ADDRESS);
    assert_int_equal(memory_load(memory, 3 * PAGE_BITS, &word), C205_TRAP_NONE);
    assert_int_equal(word, 0);
    assert_true(memory_map(memory, 3 * PAGE_BITS, 1, C205_READ_WRITE, &error));
    assert_int_equal(memory_store(memory, 3 * PAGE_BITS, 5), C205_TRAP_NONE);
    assert_int_equal(memory_load(memory, 4 * PAGE_BITS, &word), C205_TRAP_NONE);
    assert_int_equal(word, 0);
    memory_clear(memory);
    assert_int_equal(memory_next_page(memory, 0), SPACE);
    let_go(memory);
}

/* Pages that are unmapped and mapped again have no words, code marks or protection. */
TEST(clear)
{
    struct memory *memory = memory_of(PAGE_BITS, 1);
    c205_word word = 5;
    c205_error error;
    uint64_t fault;
    assert_int_equal(memory_store(memory, PAGE_BITS, word), C205_TRAP_NONE);
    memory_mark_code(memory, PAGE_BITS);
    memory_clear(memory);
    assert_int_equal(memory_check(memory, PAGE_BITS, 64, false, &fault),
                     C205_TRAP_UNMAPPED_ADDRESS);
    assert_true(memory_map(memory, 0, 1, C205_READ_WRITE, &error));
    assert_int_equal(memory_load(memory, 0, &word), C205_TRAP_NONE);
    assert_int_equal(word, 0);
    assert_false(memory_page(memory, 0)->holds_code);
    assert_int_equal(memory_check(memory, PAGE_BITS, 64, false, &fault),
                     C205_TRAP_UNMAPPED_ADDRESS);
    let_go(memory);
}

TEST(end_of_space)
{
    struct memory *memory = memory_of(SPACE - 64, 1);
    c205_error error = { "" };
    uint64_t fault;
    assert_false(memory_map(memory, SPACE - 64, 2, C205_READ_WRITE, &error));
    assert_string_not_equal(error.message, "");
    assert_false(memory_map(memory, SPACE, 1, C205_READ_WRITE, &error));
    assert_true(memory_map(memory, 0, 1, C205_READ_WRITE, &error));
    assert_int_equal(memory_check(memory, SPACE - 64, 64, true, &fault),
                     C205_TRAP_NONE);
    assert_int_equal(memory_check(memory, SPACE - 64, 65, true, &fault),
                     C205_TRAP_UNMAPPED_ADDRESS);
    let_go(memory);
}

TEST(words_across_pages)
{
    struct memory *memory = memory_of(0, 2 * C205_PAGE_WORDS);
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
    let_go(memory);
}

/* Compared with one bit at a time, at every alignment. */
TEST(bits)
{
    struct memory *memory = memory_of(0, 2 * C205_PAGE_WORDS);
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
    let_go(memory);
}

TEST(code_marks)
{
    struct memory *memory = memory_of(0, C205_PAGE_WORDS);
    uint64_t changes = memory->code_changes;
    c205_word words[200] = { 0 };
    memory_mark_code(memory, 100 * 64);
    assert_int_equal(memory_store(memory, 99 * 64, 1), C205_TRAP_NONE);
    assert_int_equal(memory_store(memory, 101 * 64, 1), C205_TRAP_NONE);
    memory_write_words(memory, 0, words, 100);
    memory_write_words(memory, 101 * 64, words, 99);
    assert_int_equal(memory->code_changes, changes);
    memory_write_words(memory, 0, words, 200);
    assert_int_equal(memory->code_changes, changes + 1);
    memory_mark_code(memory, 100 * 64);
    assert_int_equal(memory_store(memory, 100 * 64, 1), C205_TRAP_NONE);
    assert_int_equal(memory->code_changes, changes + 2);
    assert_int_equal(memory_store(memory, 100 * 64, 1), C205_TRAP_NONE);
    assert_int_equal(memory->code_changes, changes + 2);
    let_go(memory);
}

/* A lookup through the cache gives the same page as a full lookup. */
TEST(near_pages)
{
    uint64_t alike = NEAR_PAGES * PAGE_BITS; /* has the same cache slot as page 0 */
    struct memory *memory = memory_of(0, 2 * C205_PAGE_WORDS);
    c205_error error;
    assert_null(memory_near(memory, alike));
    assert_ptr_equal(memory_near(memory, 64)->word, memory_page(memory, 0)->word);
    assert_true(memory_near(memory, 64)->stores);
    assert_null(memory_near(memory, alike));
    assert_true(memory_map(memory, alike, 1, C205_READ_WRITE, &error));
    assert_ptr_equal(memory_near(memory, alike)->word,
                     memory_page(memory, alike)->word);
    assert_ptr_equal(memory_near(memory, 0)->word, memory_page(memory, 0)->word);
    assert_true(memory_map(memory, 0, 1, C205_READ_ONLY, &error));
    assert_false(memory_near(memory, 0)->stores);
    assert_true(memory_map(memory, 0, 1, C205_READ_WRITE, &error));
    assert_true(memory_near(memory, 0)->stores);
    assert_true(memory_near(memory, PAGE_BITS)->stores);
    memory_mark_code(memory, PAGE_BITS + 640);
    assert_false(memory_near(memory, PAGE_BITS)->stores);
    assert_true(memory_near(memory, 0)->stores);
    memory_clear(memory);
    assert_null(memory_near(memory, 0));
    let_go(memory);
}
