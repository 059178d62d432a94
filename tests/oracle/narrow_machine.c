/* narrow_machine.c - compiles the machine's exact rules for the narrow format. */
#include "narrow_oracle.h"
#include "vm/number/word.h"

static const word_format narrow_words = { NARROW_EXPONENT_BITS, NARROW_DIGITS };

#define RULE_FORMAT narrow_words
#define RULE(name) narrow_##name
#include "vm/number/rule.h"
