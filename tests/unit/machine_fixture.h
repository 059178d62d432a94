/* machine_fixture.h - a machine with a little program, for the unit tests. */
#ifndef MACHINE_FIXTURE_H
#define MACHINE_FIXTURE_H

#include "tests/unit/unit.h"
#include "vm/c205.h"

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

void add_half(struct little *little, c205_word half);

/* Append an instruction; gives its address. */
uint64_t add(struct little *little, const char *mnemonic, c205_fields fields);
void begin(struct little *little);
struct little make_little(void);
void free_little(struct little *little);

/* Load code, and data_words of zeros at DATA. */
void load(struct little *little, size_t data_words);
c205_stop run(struct little *little);
void set(struct little *little, unsigned number, c205_word word);
c205_word get(const struct little *little, unsigned number);
c205_word descriptor(uint64_t address, size_t length);
c205_word word_at(const struct little *little, uint64_t address);
void put_at(struct little *little, uint64_t address, c205_word word);

#endif
