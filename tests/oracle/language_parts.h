/* language_parts.h - what draws a scene text by chance: the drawing, and its
 * parts from values up to objects.
 *
 * Each part writes whole lines but for values, which stand in a line: what may
 * be left out is a line, or a block from its opening to its closing line
 * (text_shrink.h).
 */
#ifndef LANGUAGE_PARTS_H
#define LANGUAGE_PARTS_H

#include "tests/oracle/chance.h"

#include <stdio.h>

/* Names declared so far, by their kinds: N0, N1 .. are floats. */
enum language_name {
    NAME_FLOAT,
    NAME_VECTOR,
    NAME_COLOR,
    NAME_ARRAY,   /* of floats */
    NAME_PALETTE, /* of colours */
    NAME_FUNCTION,
    NAME_VALUE, /* a macro that is a float */
    NAME_PIGMENT,
    NAME_FINISH,
    NAME_TEXTURE,
    NAME_MOTION,
    NAME_SOLID,
    LANGUAGE_NAMES
};
enum { LANGUAGE_ELEMENTS = 4 }; /* of an array */

struct language {
    uint64_t state;
    FILE *text;
    FILE *text_of_all; /* where text goes to again behind an image, or NULL */
    int depth;         /* of blocks */
    size_t names[LANGUAGE_NAMES];
    bool streams;  /* Stream is a seed */
    bool library;  /* colors.inc is there */
    bool turning;  /* I is a loop's float */
    bool calling;  /* a macro may be called */
    bool clear;    /* light may pass: no fog */
    bool metals;   /* it passes nowhere */
    bool clipping; /* what is drawn clips: it is no mesh */
};

/* --- lines ---------------------------------------------------------------- */

/* Words in the line that is begun. */
void say(struct language *draw, const char *format, ...);
void begin_line(struct language *draw);
void end_line(struct language *draw);
/* A whole line. */
void say_line(struct language *draw, const char *format, ...);
/* A line that opens a block: "sphere {"; and one that closes it. */
void open_block(struct language *draw, const char *format, ...);
void close_block(struct language *draw, const char *end);

/* --- values --------------------------------------------------------------- */

/* What comes next of these; the words are drawn with the same chance. */
#define SAY_ONE_OF(draw, ...) say_one_of(draw, (const char *[]){ __VA_ARGS__, NULL })
void say_one_of(struct language *draw, const char *const *words);
/* A name of that kind; there is one. */
void say_name(struct language *draw, enum language_name kind);
/* A new one: "N3". */
void say_new_name(struct language *draw, enum language_name kind);

/* Expressions of any value. */
void say_float(struct language *draw, int depth);
void say_vector(struct language *draw, int depth);
/* Of a value between these, written down or computed. */
void say_number(struct language *draw, double low, double high);
/* A line of a word and such a value. */
void say_amount(struct language *draw, const char *word, double low, double high);
/* A vector of three such. */
void say_point(struct language *draw, double low, double high);
/* Its length is between these. */
void say_arrow(struct language *draw, double low, double high);
/* A colour that lets nothing pass, for where one stands: with its words. */
void say_color(struct language *draw);

/* --- looks and motions ---------------------------------------------------- */

void say_pigment(struct language *draw, bool clear);
/* Of what goes on for ever: far out a gradient is another one in POV-Ray, whose
 * values go round at 1.00001 below -1. */
void say_far_pigment(struct language *draw);
/* Of one pigment of so many the lines that make it an image, clear around that or not
 * anywhere.  What else is drawn of
 * it is drawn as ever, up to end_image, but not said. */
void begin_image(struct language *draw, size_t one_of, bool clear);
void end_image(struct language *draw);
void say_finish(struct language *draw, bool mirror);
/* Lines of an object: its texture, or pigment and finish, or nothing. */
void say_look(struct language *draw);
/* Of one that lets light pass, bent if it is told so. */
void say_clear_look(struct language *draw, bool bent);
/* Lines of turns and sizes; what they move stays about the origin. */
void say_turns(struct language *draw);
void declare_look(struct language *draw);
void declare_motion(struct language *draw);

/* --- things ---------------------------------------------------------------- */

/* One thing, whose middle comes to a place by chance. */
void say_thing(struct language *draw);
/* A macro and calls of it: once in a scene. */
void say_macro(struct language *draw);
void declare_solid(struct language *draw);

#endif
