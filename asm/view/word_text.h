/* word_text.h - writes a word or half word of the machine as a number and in hex. */
#ifndef ASM_WORD_TEXT_H
#define ASM_WORD_TEXT_H

#include "base/sink.h"
#include "vm/c205.h"

struct word_text {
    char number[C205_TEXT_SIZE];
    char hex[C205_TEXT_SIZE]; /* in groups of 4 digits */
};

/* Formats a word as a number and in hex. A half word must be left-aligned. */
struct word_text word_text(c205_word word, bool half);
/* Prints a word, as in "X'0000 0000 0000 0005' (5)". */
void word_print(c205_word word, bool half, const struct sink *sink);

#endif
