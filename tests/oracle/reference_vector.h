/* reference_vector.h - the operands of a vector instruction, plainly. */
#ifndef REFERENCE_VECTOR_H
#define REFERENCE_VECTOR_H

#include "tests/oracle/reference_parts.h"

struct source {
    enum { NUMBER, VECTOR, STREAM } kind;
    unsigned width;           /* of an element */
    uint64_t address, length; /* of the vector, its offset applied */
    c205_word number;         /* broadcast */
    c205_word pad;            /* what a short vector continues with */
    bool magnitude, negate;
    const struct pair *stream; /* the first of a linked pair */
};

/* One or two sources and the rule that joins them. */
struct pair {
    struct source a, b;
    bool has_b;
    oracle_rule *rule;
    const struct oracle_format *format; /* of the operands */
};

/* A result or a control vector, its offset applied. */
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

/* A vector, of words, half words or bits, by its registers. */
struct source vector_source(struct reference *reference, const c205_insn *insn,
                            char letter, unsigned number, unsigned offset);
/* The result and the control vector. */
void take_targets(struct reference *reference, struct vector *vector);
/* False: an operand is bad, and its fault noted. */
bool take_operands(struct reference *reference, const c205_insn *insn,
                   const c205_fields *fields, struct vector *vector);

bool has_bad_operand(const struct reference *reference);

/* Element i of a source. */
c205_word element(struct reference *reference, const struct source *source, uint64_t i);
/* Of both sources, joined by the rule. */
c205_word join(struct reference *reference, const struct pair *pair, uint64_t i,
               uint64_t *flags);

/* The memory that n elements use, in the order A, B, Z, C. */
void use_source(struct reference *reference, const struct source *source, uint64_t n);
/* n elements that are looked at but perhaps not needed. */
void may_need(struct reference *reference, const struct source *source, uint64_t n);
void use_target(struct reference *reference, const struct target *target, uint64_t n);
void use_control(struct reference *reference, const struct vector *vector, uint64_t n);

/* What the control vector says of element i. */
bool permitted(struct reference *reference, const struct vector *vector, uint64_t i);
/* Where it permits: stored, and the flags with it. */
void write_element(struct reference *reference, const struct vector *vector, uint64_t i,
                   c205_word word, uint64_t flags);

/* Element i of the result, whatever the control vector says. */
void store_element(struct reference *reference, const struct target *target, uint64_t i,
                   c205_word word);
void leave_element(struct reference *reference, const struct target *target,
                   uint64_t i);

/* How many elements an instruction without a result vector looks at: those
 * of A, or of B when A is one number; false: of two numbers, a fault. */
bool scan_length(struct reference *reference, const struct vector *vector,
                 uint64_t *length);
void set_length(struct reference *reference, const struct vector *vector,
                uint64_t length);

/* Whether element i of a source lies where so many of the result have been
 * stored, whatever the control vector held back of them. */
bool lies_on_results(const struct source *source, uint64_t i, const struct target *c,
                     uint64_t stored);

void do_sparse(struct reference *reference, const c205_insn *insn,
               const c205_fields *fields);
void do_reduction(struct reference *reference, const struct vector *vector);
/* False: it is none of these. */
bool do_move(struct reference *reference, const struct vector *vector);

#endif
