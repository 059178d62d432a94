/* machine_fixture.c - programs made instruction by instruction, and run. */
#include "machine_fixture.h"

void add_half(struct little *little, c205_word half)
{
    c205_word *word = &little->code[little->halves / 2];
    assert_true(little->halves < 2 * CODE_WORDS);
    *word |= little->halves % 2 ? half : half << 32;
    little->halves++;
}

uint64_t add(struct little *little, const char *mnemonic, c205_fields fields)
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

void begin(struct little *little)
{
    memset(little->code, 0, sizeof little->code);
    little->halves = 0;
}

struct little make_little(void)
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

void free_little(struct little *little)
{
    c205_free(little->machine);
    c205_model_free(little->model);
}

void load(struct little *little, size_t data_words)
{
    c205_segment segments[] = { { CODE, CODE_WORDS, little->code },
                                { DATA, data_words, NULL } };
    c205_program program = { CODE, 2, segments, 0, NULL, false };
    c205_error error = { "" };
    if (!c205_load(little->machine, &program, &error))
        fail_msg("%s", error.message);
}

c205_stop run(struct little *little)
{
    return c205_run(little->machine, 1000000000);
}

void set(struct little *little, unsigned number, c205_word word)
{
    c205_set_register(little->machine, number, word);
}

c205_word get(const struct little *little, unsigned number)
{
    return c205_register(little->machine, number);
}

c205_word descriptor(uint64_t address, size_t length)
{
    return (c205_word)length << 48 | address;
}

c205_word word_at(const struct little *little, uint64_t address)
{
    c205_word word = 0;
    assert_true(c205_read(little->machine, address, &word, 1));
    return word;
}

void put_at(struct little *little, uint64_t address, c205_word word)
{
    assert_true(c205_write(little->machine, address, &word, 1));
}
