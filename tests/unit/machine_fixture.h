/* machine_fixture.h - a machine with a small program, for the unit tests. */
#ifndef MACHINE_FIXTURE_H
#define MACHINE_FIXTURE_H

#include "tests/unit/unit.h"
#include "vm/c205.h"

enum { CODE_WORDS = 64 };
#define CODE UINT64_C(0x400000)   /* start of page 1 */
#define DATA UINT64_C(0x10000000) /* start of page 64 */
#define HALF_WORD 32

struct small_machine {
    c205_model *model;
    c205 *machine;
    c205_word code[CODE_WORDS];
    size_t halves;
};

void add_half(struct small_machine *fixture, c205_word half);

#define F(...) ((c205_fields){ __VA_ARGS__ })

/* Appends an instruction and returns its address. */
uint64_t add(struct small_machine *fixture, const char *mnemonic, c205_fields fields);
void begin(struct small_machine *fixture);
struct small_machine make_small_machine(void);
void free_small_machine(struct small_machine *fixture);
#define small_machine_free free_small_machine /* name for SCOPED_VALUE */

/* Loads the code, and data_words zeros at DATA. */
void load(struct small_machine *fixture, size_t data_words);
c205_stop run(struct small_machine *fixture);
void set(struct small_machine *fixture, unsigned number, c205_word word);
c205_word get(const struct small_machine *fixture, unsigned number);
c205_word descriptor(uint64_t address, size_t length);
c205_word word_at(const struct small_machine *fixture, uint64_t address);
void put_at(struct small_machine *fixture, uint64_t address, c205_word word);

#endif
