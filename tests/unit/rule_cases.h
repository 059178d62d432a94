/* rule_cases.h - compares an operation's result and flags with the exact rule. */
#ifndef TESTS_RULE_CASES_H
#define TESTS_RULE_CASES_H

#include "tests/unit/unit.h"
#include "vm/number/arith.h"

#define MZ C205_MACHINE_ZERO
#define IND C205_INDEFINITE

#define ZERO_FLAG FLAG_MACHINE_ZERO
#define INDEFINITE_FLAG FLAG_INDEFINITE
#define OVERFLOW_FLAGS (FLAG_EXPONENT_OVERFLOW | FLAG_INDEFINITE)
#define FAULT_FLAGS (FLAG_DIVIDE_FAULT | FLAG_INDEFINITE)
#define ROOT_FLAGS (FLAG_IMAGINARY_ROOT | FLAG_INDEFINITE)

static inline void gives(const char *what, c205_word result, uint64_t flags,
                         c205_word expected, uint64_t expected_flags)
{
    if (result != expected || flags != expected_flags)
        fail_msg("%s gives %016llX, flags %llX, not %016llX, %llX", what,
                 (unsigned long long)result, (unsigned long long)flags,
                 (unsigned long long)expected, (unsigned long long)expected_flags);
}

#define BINARY_GIVES(op, a, b, expected, expected_flags) \
    do { \
        uint64_t flags_ = 0; \
        c205_word result_ = op(a, b, &flags_); \
        gives(#op "(" #a ", " #b ")", result_, flags_, expected, expected_flags); \
    } while (0)

#define UNARY_GIVES(op, a, expected, expected_flags) \
    do { \
        uint64_t flags_ = 0; \
        c205_word result_ = op(a, &flags_); \
        gives(#op "(" #a ")", result_, flags_, expected, expected_flags); \
    } while (0)

#endif
