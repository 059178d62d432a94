/* machine_fixture.h - a machine with a little program, for the unit tests. */
#ifndef MACHINE_FIXTURE_H
#define MACHINE_FIXTURE_H

#include "vm/c205.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { CODE_WORDS = 64 };
#define CODE UINT64_C(0x400000)   /* page 1 */
#define DATA UINT64_C(0x10000000) /* page 64 */
#define HALF_WORD 32

struct little {
    c205_model *model;
    c205 *machine;
    c205_word code[CODE_WORDS];
    size_t halves;
};

static inline void add_half(struct little *little, c205_word half)
{
    c205_word *word = &little->code[little->halves / 2];
    assert_true(little->halves < 2 * CODE_WORDS);
    *word |= little->halves % 2 ? half : half << 32;
    little->halves++;
}

/* Append an instruction; gives its address. */
static inline uint64_t add(struct little *little, const char *mnemonic,
                           c205_fields fields)
{
    const c205_insn *insn = c205_insn_named(mnemonic, strlen(mnemonic));
    uint64_t address = CODE + little->halves * HALF_WORD;
    assert_non_null(insn);
    c205_word word = c205_encode(insn, &fields);
    add_half(little, word >> 32);
    if (c205_format_halves(insn->format) == 2)
        add_half(little, word & UINT32_MAX);
    return address;
}

static inline void begin(struct little *little)
{
    memset(little->code, 0, sizeof little->code);
    little->halves = 0;
}

static inline struct little make_little(void)
{
    struct little little;
    c205_error error = { "" };
    begin(&little);
    little.model = c205_model_find("cyber205-2pipe-prior", &error);
    assert_non_null(little.model);
    little.machine = c205_new(little.model, &error);
    if (!little.machine)
        fail_msg("%s", error.message);
    return little;
}

static inline void free_little(struct little *little)
{
    c205_free(little->machine);
    c205_model_free(little->model);
}

/* Load code, and data_words of zeros at DATA. */
static inline void load(struct little *little, size_t data_words)
{
    c205_segment segments[] = { { CODE, CODE_WORDS, little->code },
                                { DATA, data_words, NULL } };
    c205_program program = { CODE, 2, segments, 0, NULL };
    c205_error error = { "" };
    if (!c205_load(little->machine, &program, &error))
        fail_msg("%s", error.message);
}

static inline c205_stop run(struct little *little)
{
    return c205_run(little->machine, 1000000000);
}

static inline void set(struct little *little, unsigned number, c205_word word)
{
    c205_set_register(little->machine, number, word);
}

static inline c205_word get(const struct little *little, unsigned number)
{
    return c205_register(little->machine, number);
}

static inline c205_word descriptor(uint64_t address, size_t length)
{
    return (c205_word)length << 48 | address;
}

static inline c205_word word_at(const struct little *little, uint64_t address)
{
    c205_word word = 0;
    assert_true(c205_read(little->machine, address, &word, 1));
    return word;
}

static inline void put_at(struct little *little, uint64_t address,
                          c205_word word)
{
    assert_true(c205_write(little->machine, address, &word, 1));
}

#endif
