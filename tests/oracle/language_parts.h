/* language_parts.h - the generator of random scene texts: its state and its parts, from
 * values to objects.
 *
 * Texts are generated from patterns. A pattern is a text that contains parts, which are
 * evaluated from left to right.
 *
 *     ~LOW:HIGH~     a number between these, as a literal or an expression
 *     @LOW:HIGH@     a vector of three such numbers
 *     ^DLOW:HIGH^    a number with D digits.  If several follow each other without
 *                    another part between them, the last is generated first; $. is
 *                    an empty part that separates them
 *     ^#LOW:COUNT^   an integer from LOW to LOW + COUNT - 1
 *     $N[A|B..$]     one of the patterns, at random.  Each pattern but the last has the
 *                    probability 1/N; without N all patterns have the same one
 *     $?CN[A|B$]     if the condition C holds, A with the probability 1/N (without N:
 *                    always); otherwise B.  C is a flag of struct language, or the
 *                    letter of a kind of names, which holds if a name is declared
 *     $*LOW:COUNT[A$]  A, repeated LOW to LOW + COUNT - 1 times
 *     $f2; $v2;      an expression, a float or a vector, at most two levels deep
 *     $=N; $+N; $!N; a declared name N0, N1 ..; a new name; the end of its declaration
 *     $rule;         the rule of this name (language_rules.c)
 *
 * A line, or a block from its opening to its closing line, can be removed
 * (solid_text.h).
 */
#ifndef LANGUAGE_PARTS_H
#define LANGUAGE_PARTS_H

#include "tests/oracle/chance.h"

#include <stdio.h>

/* Kinds of declared names, which are numbered: N0, N1 and so on are the floats. */
enum language_name {
    NAME_FLOAT,
    NAME_VECTOR,
    NAME_COLOR,
    NAME_ARRAY,   /* array of floats */
    NAME_PALETTE, /* array of colours */
    NAME_FUNCTION,
    NAME_VALUE, /* a macro whose value is a float */
    NAME_PIGMENT,
    NAME_FINISH,
    NAME_TEXTURE,
    NAME_MOTION,
    NAME_SOLID,
    LANGUAGE_NAMES
};

struct language {
    uint64_t state;
    FILE *text;
    FILE *text_of_all; /* the stream of the whole text while an image replaces a
                        * pigment, or NULL */
    size_t names[LANGUAGE_NAMES];
    double steep;  /* largest slope of a normal */
    bool streams;  /* `Stream` is declared and is a random stream */
    bool library;  /* colors.inc has been included */
    bool turning;  /* `I` is declared and is the variable of a loop */
    bool calling;  /* macros may be called */
    bool clear;    /* objects may transmit light, because there is no fog */
    bool metals;   /* metals are allowed, because no light is transmitted */
    bool clipping; /* the object clips, so it must not be a mesh */
    bool copied;   /* the next normal may replace a copy of a declared normal */
};

typedef void language_writer(struct language *draw);

/* A rule: a pattern, or a function if the text depends on previous choices. */
struct language_rule {
    const char *name;
    language_writer *write_text;
    const char *pattern;
};
extern const struct language_rule language_rules[];
extern const size_t language_rule_count;

/* Evaluates the pattern that printf makes of the format. */
void write_text(struct language *draw, const char *format, ...);
void write_pattern(struct language *draw, const char *pattern);

/* Writes an image as the pigment, with the probability 1/one_of. Then the pattern up to
 * end_image is not printed. `clear` surrounds the image with a clear colour. */
void begin_image(struct language *draw, size_t one_of, bool clear);
void end_image(struct language *draw);

/* Opens the block of a shape, which modifiers may follow. The shape is at the origin,
 * within a ball of radius 1.3. closed: the shape has an inside and no opening. */
void open_solid_shape(struct language *draw, bool closed);

/* The functions that rules call. */
language_writer write_map, write_plain_color, write_clear_look, write_steepness,
    write_bump_map, write_slopes, begin_copy, write_normal, write_steep_normal,
    write_component, write_looking_camera, write_area, write_clip, write_listed_solid,
    write_great_solid, write_for, write_macro, open_solid, open_quadric,
    open_lone_triangle, open_bent_triangle, open_net, open_bicubic, declare_array,
    declare_palette, declare_solid;

#endif
