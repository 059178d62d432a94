/* reference_vector.h - the operands of a vector instruction. */
#ifndef REFERENCE_VECTOR_H
#define REFERENCE_VECTOR_H

#include "tests/oracle/reference_parts.h"

struct source {
    enum { NUMBER, VECTOR, STREAM } kind;
    unsigned width;           /* width of an element */
    uint64_t address, length; /* address and length of the vector after its offset */
    c205_word number;         /* number, if the operand is broadcast */
    c205_word pad;            /* padding of a short vector */
    bool magnitude, negate;
    const struct pair *stream; /* the first instruction of a linked pair */
};

/* One or two sources, and the rule that combines them. */
struct pair {
    struct source a, b;
    bool has_b;
    oracle_rule *rule;
    const struct oracle_format *format; /* format of the operands */
};

/* A result or a control vector, after its offset. */
struct target {
    unsigned width;
    uint64_t address, length;
};

struct vector {
    const c205_insn *insn;
    const c205_fields *fields;
    struct pair sources;
    struct target c, z;
};

/* Returns a source vector of words, half words or bits, from its registers. */
struct source vector_source(struct reference *reference, const c205_insn *insn,
                            char letter, unsigned number, unsigned offset);
/* Sets the result and the control vector. */
void take_targets(struct reference *reference, struct vector *vector);
/* Sets all operands. If an operand is invalid, records the fault and returns false. */
bool take_operands(struct reference *reference, const c205_insn *insn,
                   const c205_fields *fields, struct vector *vector);

bool has_bad_operand(const struct reference *reference);

/* Returns element i of a source. */
c205_word element(struct reference *reference, const struct source *source, uint64_t i);
/* Applies the rule to element i of both sources. */
c205_word join(struct reference *reference, const struct pair *pair, uint64_t i,
               uint64_t *flags);

/* Records that n elements of a source are read. The recording functions are called in
 * the order A, B, Z, C. */
void use_source(struct reference *reference, const struct source *source, uint64_t n);
/* Records that n elements of a source are used, but may not be needed. */
void may_need(struct reference *reference, const struct source *source, uint64_t n);
void use_target(struct reference *reference, const struct target *target, uint64_t n);
void use_control(struct reference *reference, const struct vector *vector, uint64_t n);

/* Returns true if the control vector permits element i. */
bool permitted(struct reference *reference, const struct vector *vector, uint64_t i);
/* Stores element i and sets its flags if the control vector permits it. */
void write_element(struct reference *reference, const struct vector *vector, uint64_t i,
                   c205_word word, uint64_t flags);

/* Stores element i of the result. Ignores the control vector. */
void store_element(struct reference *reference, const struct target *target, uint64_t i,
                   c205_word word);
void leave_element(struct reference *reference, const struct target *target,
                   uint64_t i);

/* Sets the number of elements of an instruction without a result vector. It is the
 * length of A, or of B if A is broadcast. Returns false if both are. */
bool scan_length(struct reference *reference, const struct vector *vector,
                 uint64_t *length);
/* Sets the length in the descriptor of a register. */
void set_length(struct reference *reference, unsigned number, uint64_t length);

/* Returns true if element i of a source overlaps one of the first `stored` elements of
 * the result, including elements that the control vector excludes. */
bool lies_on_results(const struct source *source, uint64_t i, const struct target *c,
                     uint64_t stored);

void do_sparse(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields);
void do_reduction(struct reference *reference, const struct vector *vector);
/* Executes an instruction that moves elements. Returns false for other kinds. */
bool do_move(struct reference *reference, const struct vector *vector);

#endif
