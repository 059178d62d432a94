/* arith.c - instantiates the exact rule of rule.h for words of 64 bits. */
#include "vm/number/arith.h"

#define RULE_FORMAT whole_words
#define RULE(name) arith_##name
#include "vm/number/rule.h"
