/* word_text.c - writes words and half words as numbers and in hex. */
#include "asm/view/word_text.h"

enum { HALF_DIGITS = 9 }; /* 8 digits and a blank */

struct word_text word_text(c205_word word, bool half)
{
    struct word_text text = { .hex = "" };
    (half ? c205_half_to_text : c205_to_text)(word, text.number);
    c205_to_hex(word, text.hex);
    if (half)
        text.hex[HALF_DIGITS] = '\0';
    return text;
}

void word_print(c205_word word, bool half, const struct sink *sink)
{
    struct word_text text = word_text(word, half);
    sink_print(sink, "X'%s' (%s)", text.hex, text.number);
}
