/* reference_vector.h - the operands of a vector instruction. */
#ifndef REFERENCE_VECTOR_H
#define REFERENCE_VECTOR_H

#include "tests/oracle/reference_parts.h"

struct source {
    enum { NUMBER, VECTOR, STREAM } kind;
    unsigned width;           /* of an element */
    uint64_t address, length; /* of the vector after its offset */
    c205_word number;         /* broadcast */
    c205_word pad;            /* padding of a short vector */
    bool magnitude, negate;
    const struct pair *stream; /* first of a linked pair */
};

/* One or two sources and the rule that combines them. */
struct pair {
    struct source a, b;
    bool has_b;
    oracle_rule *rule;
    const struct oracle_format *format; /* of the operands */
};

/* A result or a control vector after its offset. */
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

/* Returns a source vector of words, half words or bits, by its registers. */
struct source vector_source(struct reference *reference, const c205_insn *insn,
                            char letter, unsigned number, unsigned offset);
/* Sets the result and the control vector. */
void take_targets(struct reference *reference, struct vector *vector);
/* Sets all operands.  Returns false if one is bad; its fault is recorded. */
bool take_operands(struct reference *reference, const c205_insn *insn,
                   const c205_fields *fields, struct vector *vector);

bool has_bad_operand(const struct reference *reference);

/* Returns element i of a source. */
c205_word element(struct reference *reference, const struct source *source, uint64_t i);
/* Combines elements i of both sources by the rule. */
c205_word join(struct reference *reference, const struct pair *pair, uint64_t i,
               uint64_t *flags);

/* Record the memory that n elements use, in the order A, B, Z, C. */
void use_source(struct reference *reference, const struct source *source, uint64_t n);
/* Records n elements that are used but perhaps not needed. */
void may_need(struct reference *reference, const struct source *source, uint64_t n);
void use_target(struct reference *reference, const struct target *target, uint64_t n);
void use_control(struct reference *reference, const struct vector *vector, uint64_t n);

/* Returns whether the control vector permits element i. */
bool permitted(struct reference *reference, const struct vector *vector, uint64_t i);
/* Stores element i, and sets its flags, if the control vector permits it. */
void write_element(struct reference *reference, const struct vector *vector, uint64_t i,
                   c205_word word, uint64_t flags);

/* Stores element i of the result, or excludes it, regardless of the control vector. */
void store_element(struct reference *reference, const struct target *target, uint64_t i,
                   c205_word word);
void leave_element(struct reference *reference, const struct target *target,
                   uint64_t i);

/* Sets the number of elements for an instruction without a result vector: those of A,
 * or of B if A is a single number.  Returns false, a fault, if both are. */
bool scan_length(struct reference *reference, const struct vector *vector,
                 uint64_t *length);
/* Sets the length in the descriptor of a register. */
void set_length(struct reference *reference, unsigned number, uint64_t length);

/* Returns whether element i of a source overlaps the first `stored` elements of the
 * result, including those that the control vector excludes. */
bool lies_on_results(const struct source *source, uint64_t i, const struct target *c,
                     uint64_t stored);

void do_sparse(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields);
void do_reduction(struct reference *reference, const struct vector *vector);
/* Returns false if the instruction does not move elements. */
bool do_move(struct reference *reference, const struct vector *vector);

#endif
