/* machine_fixture.c - builds programs instruction by instruction and runs them. */
#include "machine_fixture.h"

void add_half(struct small_machine *fixture, c205_word half)
{
    c205_word *word = &fixture->code[fixture->halves / 2];
    assert_true(fixture->halves < 2 * CODE_WORDS);
    *word |= fixture->halves % 2 ? half : half << 32;
    fixture->halves++;
}

uint64_t add(struct small_machine *fixture, const char *mnemonic, c205_fields fields)
{
    const c205_insn *insn = NON_NULL(c205_insn_named(mnemonic, strlen(mnemonic)));
    uint64_t address = CODE + fixture->halves * HALF_WORD;
    c205_word word = c205_encode(insn, &fields);
    add_half(fixture, word >> 32);
    if (c205_format_halves(insn->format) == 2)
        add_half(fixture, word & UINT32_MAX);
    return address;
}

void begin(struct small_machine *fixture)
{
    memset(fixture->code, 0, sizeof fixture->code);
    fixture->halves = 0;
}

struct small_machine make_small_machine(void)
{
    struct small_machine fixture;
    begin(&fixture);
    fixture.model = NON_NULL(c205_model_find("cyber205-2pipe-prior", &failure));
    fixture.machine = NON_NULL(c205_new(fixture.model, &failure));
    return fixture;
}

void free_small_machine(struct small_machine *fixture)
{
    c205_free(fixture->machine);
    c205_model_free(fixture->model);
}

void load(struct small_machine *fixture, size_t data_words)
{
    c205_segment segments[] = { { CODE, CODE_WORDS, fixture->code },
                                { DATA, data_words, NULL } };
    c205_program program = { CODE, 2, segments, 0, NULL, false };
    REQUIRE(c205_load(fixture->machine, &program, &failure));
}

c205_stop run(struct small_machine *fixture)
{
    return c205_run(fixture->machine, 1000000000);
}

void set(struct small_machine *fixture, unsigned number, c205_word word)
{
    c205_set_register(fixture->machine, number, word);
}

c205_word get(const struct small_machine *fixture, unsigned number)
{
    return c205_register(fixture->machine, number);
}

c205_word descriptor(uint64_t address, size_t length)
{
    return (c205_word)length << 48 | address;
}

c205_word word_at(const struct small_machine *fixture, uint64_t address)
{
    c205_word word = 0;
    assert_true(c205_read(fixture->machine, address, &word, 1));
    return word;
}

void put_at(struct small_machine *fixture, uint64_t address, c205_word word)
{
    assert_true(c205_write(fixture->machine, address, &word, 1));
}
