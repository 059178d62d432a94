/* test_data_map.c - the types and sizes of data that the assembler records for labels
 * are compared with random texts. A label with another type, or a count that includes
 * data of the next label, fails here. */
#include <inttypes.h>

#include "tests/oracle/chance.h"
#include "tests/unit/asm_helper.h"

enum { TRIES = 200, LABELS = 40 };

static uint64_t state = RANDOM_SEED;

struct labelled {
    enum asm_contents contents;
    uint64_t count;
};

struct random_text {
    struct labelled label[LABELS];
    struct text_buffer text;
    struct sink out; /* writes to the text */
};

/* Adds a line of data. Returns the number of elements of its type. */
static uint64_t put_data(struct random_text *drawn, enum asm_contents contents)
{
    uint64_t n = below(&state, 4) + 1;
    switch (contents) {
    case ASM_WORDS:
        if (one_in(&state, 3)) {
            sink_print(&drawn->out, "        .space  %" PRIu64 "\n", n);
            return n;
        }
        sink_print(&drawn->out, one_in(&state, 2) ? "        .word   1, 2.5\n"
                                                  : "        .descriptor 1, 0\n"
                                                    "        .word   .\n");
        return 2;
    case ASM_HALF_WORDS: /* whole words, so that the next data is aligned */
        sink_print(&drawn->out, "        .halfword 1, 2\n        .half   3, 4\n");
        return 4;
    case ASM_BYTES: sink_print(&drawn->out, "        .text   \"eight of\"\n"); return 8;
    case ASM_CODE:
        sink_print(&drawn->out, "        ADDN    r1, r2, r3\n        EX      r1, 5\n");
        return 3;
    default: return 0;
    }
}

/* Adds a vector, which defines its own label. */
static void put_vector(struct random_text *drawn, size_t i)
{
    static const struct {
        const char *name;
        enum asm_contents contents;
    } kinds[] = { { "vector", ASM_WORDS },
                  { "halfvector", ASM_HALF_WORDS },
                  { "bitvector", ASM_BITS } };
    size_t kind = below(&state, 3);
    drawn->label[i].contents = kinds[kind].contents;
    drawn->label[i].count = below(&state, 100) + !one_in(&state, 4);
    sink_print(&drawn->out, "        .%s l%zu, %" PRIu64 "%s\n", kinds[kind].name, i,
               drawn->label[i].count,
               !drawn->label[i].count || one_in(&state, 2) ? ""
               : kind == 2                                 ? ", \"1\""
                                                           : ", 7");
}

static void put_labelled(struct random_text *drawn, size_t i)
{
    static const enum asm_contents kinds[] = { ASM_WORDS, ASM_HALF_WORDS, ASM_BYTES,
                                               ASM_CODE };
    enum asm_contents contents = kinds[below(&state, 4)];
    drawn->label[i] = (struct labelled){ contents, 0 };
    sink_print(&drawn->out,
               contents == ASM_CODE ? "        .code\n" : "        .data\n");
    sink_print(&drawn->out, "l%zu:\n", i);
    for (size_t k = below(&state, 3) + 1; k > 0; k--)
        drawn->label[i].count += put_data(drawn, contents);
    /* Other data, with or without a label, ends the counted data. */
    if (contents == ASM_WORDS && one_in(&state, 2))
        sink_print(&drawn->out, "        .text   \"abc\"\n");
}

static void check(const struct random_text *drawn)
{
    SCOPED(object) *object = good(drawn->text.text);
    for (size_t i = 0; i < LABELS; i++) {
        const char *name = formatted("l%zu", i);
        const struct asm_symbol *symbol = object_symbol(object, name);
        if (symbol->contents != drawn->label[i].contents
            || symbol->count != drawn->label[i].count) {
            fail_msg("%s: %d, %" PRIu64 " of them; should be %d, %" PRIu64 ", in\n%s",
                     name, (int)symbol->contents, symbol->count,
                     (int)drawn->label[i].contents, drawn->label[i].count,
                     drawn->text.text);
        }
    }
}

TEST(labels)
{
    static struct random_text drawn;
    for (int try = 0; try < TRIES; try++) {
        drawn.out = text_buffer_sink(&drawn.text);
        for (size_t i = 0; i < LABELS; i++) {
            if (one_in(&state, 3)) {
                sink_print(&drawn.out, "        .data\n");
                put_vector(&drawn, i);
            } else {
                put_labelled(&drawn, i);
            }
        }
        sink_print(&drawn.out, "        .code\nlast:   EXIT\n");
        sink_print(&drawn.out, "        .equ    five, 5\n");
        check(&drawn);
        text_buffer_free(&drawn.text);
    }
}

/* A label at the end of the data, and a constant, have no data. */
TEST(ends)
{
    SCOPED(object) *object = good("        .data\nx:      .word 1\nend:\n"
                                  "        .equ five, 5\n        .code\n"
                                  "        EXIT\n");
    assert_int_equal(object_symbol(object, "end")->contents, ASM_NOTHING);
    assert_int_equal(object_symbol(object, "end")->count, 0);
    assert_int_equal(object_symbol(object, "five")->contents, ASM_NOTHING);
    assert_int_equal(object_symbol(object, "x")->count, 1);
}
