/* language_parts.h - what draws a scene random text: the drawing, and its
 * parts from values up to objects.
 *
 * Texts are drawn by patterns: a pattern is text with parts, drawn from left to right.
 *
 *     ~LOW:HIGH~     a number between these, written down or computed
 *     @LOW:HIGH@     a vector of three such
 *     ^DLOW:HIGH^    a number with D digits; of several that no other part separates the
 *                    last is drawn first; $. separates
 *     ^#LOW:COUNT^   .. a whole number, one of COUNT from LOW on
 *     $N[A|B..$]     one of the patterns, of N cases: the last pattern has all that are
 *                    left; without N each has one
 *     $f2; $v2;      an expression, a float's or a vector's, two deep at most
 *     $=N; $+N; $!N; a declared name N0, N1 ..; a new one; from here on it is declared
 *     $rule;         the rule of this name (language_rules.c)
 *
 * What may be left out is a line, or a block from its opening to its closing line
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
    size_t names[LANGUAGE_NAMES];
    double steep;  /* how steep a normal may be */
    bool streams;  /* Stream is a seed */
    bool library;  /* colors.inc is there */
    bool turning;  /* I is a loop's float */
    bool calling;  /* a macro may be called */
    bool clear;    /* light may pass: no fog */
    bool metals;   /* it passes nowhere */
    bool clipping; /* what is drawn clips: it is no mesh */
};

/* A rule is a pattern, or a function where the text depends on what was drawn before. */
struct language_rule {
    const char *name;
    void (*say)(struct language *draw);
    const char *pattern;
};
extern const struct language_rule language_rules[];
extern const size_t language_rule_count;

/* The pattern that the format makes. */
void say(struct language *draw, const char *format, ...);
void say_pattern(struct language *draw, const char *pattern);
void say_number(struct language *draw, double low, double high);

/* Of one pigment of so many the lines that make it an image, clear around that or not
 * anywhere.  What else is drawn of it is drawn as ever, up to end_image, but not said. */
void begin_image(struct language *draw, size_t one_of, bool clear);
void end_image(struct language *draw);

/* An open block of a shape, for modifiers: about the origin, no larger than a ball of 1.3
 * about it.  closed: with an inside, and no way in. */
void open_solid_shape(struct language *draw, bool closed);

/* The functions of the rules. */
void say_color(struct language *draw);
void say_turns(struct language *draw);
void say_map(struct language *draw);
void say_plain_color(struct language *draw);
void say_pigment(struct language *draw);
void say_clear_look(struct language *draw);
void say_metallic(struct language *draw);
void say_finish(struct language *draw);
void say_ground_finish(struct language *draw);
void say_steepness(struct language *draw);
void say_bump_map(struct language *draw);
void say_slopes(struct language *draw);
void say_normal(struct language *draw);
void say_steep_normal(struct language *draw);
void say_texture_words(struct language *draw);
void declare_look(struct language *draw);
void say_component(struct language *draw);
void open_solid(struct language *draw);
void open_quadric(struct language *draw);
void open_lone_triangle(struct language *draw);
void open_mesh(struct language *draw);
void open_net(struct language *draw);
void open_bicubic(struct language *draw);
void say_clip(struct language *draw);
void say_listed_solid(struct language *draw);
void say_great_solid(struct language *draw);
void declare_solid(struct language *draw);
void say_for(struct language *draw);
void say_macro(struct language *draw);
void say_thing(struct language *draw);
void declare_array(struct language *draw);
void declare_palette(struct language *draw);

#endif
