/* language_values.c - lines, names, and expressions by chance. */
#include "tests/oracle/language_parts.h"

#include <stdarg.h>

/* --- lines ---------------------------------------------------------------- */

void say(struct language *draw, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    vfprintf(draw->text, format, values);
    va_end(values);
}

void begin_line(struct language *draw)
{
    say(draw, "%*s", 4 * draw->depth, "");
}

void end_line(struct language *draw)
{
    say(draw, "\n");
}

static void say_words(struct language *draw, const char *format, va_list values)
{
    begin_line(draw);
    vfprintf(draw->text, format, values);
    end_line(draw);
}

void say_line(struct language *draw, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say_words(draw, format, values);
    va_end(values);
}

void open_block(struct language *draw, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say_words(draw, format, values);
    va_end(values);
    draw->depth++;
}

void close_block(struct language *draw, const char *end)
{
    draw->depth--;
    say_line(draw, "%s", end);
}

/* --- names ---------------------------------------------------------------- */

void say_one_of(struct language *draw, const char *const *words)
{
    size_t count = 0;
    while (words[count])
        count++;
    say(draw, "%s", words[below(&draw->state, count)]);
}

static const char *const name_of[LANGUAGE_NAMES] = {
    [NAME_FLOAT] = "N",      [NAME_VECTOR] = "V",        [NAME_COLOR] = "Color",
    [NAME_ARRAY] = "List",   [NAME_PALETTE] = "Palette", [NAME_FUNCTION] = "Wave",
    [NAME_VALUE] = "Bent",   [NAME_PIGMENT] = "Paint",   [NAME_FINISH] = "Shine",
    [NAME_TEXTURE] = "Look", [NAME_MOTION] = "Motion",   [NAME_SOLID] = "Solid",
};

void say_name(struct language *draw, enum language_name kind)
{
    say(draw, "%s%zu", name_of[kind], below(&draw->state, draw->names[kind]));
}

void say_new_name(struct language *draw, enum language_name kind)
{
    say(draw, "%s%zu", name_of[kind], draw->names[kind]);
}

/* --- floats --------------------------------------------------------------- */

/* A pattern of an expression: # stands for a float, @ for a vector, all else for
 * itself. */
static void say_pattern(struct language *draw, const char *pattern, int depth)
{
    for (; *pattern; pattern++)
        if (*pattern == '#')
            say_float(draw, depth);
        else if (*pattern == '@')
            say_vector(draw, depth);
        else
            say(draw, "%c", *pattern);
}

static void say_element(struct language *draw)
{
    say_name(draw, NAME_ARRAY);
    if (one_in(&draw->state, 4))
        say(draw, "[dimension_size(List0, 1) - 1]");
    else
        say(draw, "[%zu]", below(&draw->state, LANGUAGE_ELEMENTS));
}

static void say_call(struct language *draw, enum language_name kind, int depth)
{
    say_name(draw, kind);
    say_pattern(draw, "(#, #)", depth);
}

/* Names if there are any; else a number. */
static void say_float_leaf(struct language *draw)
{
    size_t *names = draw->names;
    size_t kind = below(&draw->state, 12);
    if (kind == 0 && draw->turning)
        say(draw, "I");
    else if (kind < 4 && names[NAME_FLOAT])
        say_name(draw, NAME_FLOAT);
    else if (kind == 4 && names[NAME_ARRAY])
        say_element(draw);
    else if (kind == 5 && names[NAME_VECTOR]) {
        say_name(draw, NAME_VECTOR);
        SAY_ONE_OF(draw, ".x", ".y", ".z");
    } else if (kind == 6 && names[NAME_COLOR]) {
        say_name(draw, NAME_COLOR);
        SAY_ONE_OF(draw, ".red", ".green", ".blue", ".gray", ".transmit");
    } else if (kind == 7)
        SAY_ONE_OF(draw, "pi", "true", "no", "on", "clock", "version", "image_width/20",
                   "1.5e-1", "2.5E+0", ".5");
    else if (kind == 8 && draw->streams)
        say(draw, "rand(Stream)");
    else
        say(draw, "%.3f", between(&draw->state, 0, 3));
}

/* Arguments are within the functions' domains; nothing grows beyond what a sine
 * of it tells. */
static const char *const float_patterns[] = {
    "(# + #)",
    "(# - #)",
    "(# * #)",
    "#*#",
    "(# + # * #)",
    "(# - # - #)",
    "(# / (1.5 + abs(#)))",
    "(#/2/4*3)",
    "(-#)",
    "(2 - -#)",
    "(!#)",
    "(# < #)",
    "(# >= # | # = 1)",
    "(# != # & # <= #)",
    "(# > # ? # : #)",
    "(# < # ? # : # > # ? # : #)",
    "abs(#)",
    "acos(cos(#))",
    "asin(sin(#))",
    "acosh(1 + abs(#))",
    "asinh(#)",
    "atan(#)",
    "atan2(#, .7 + abs(#))",
    "atanh(.9*sin(#))",
    "bitwise_and(int(mod(10*abs(#), 1e9)), 21)",
    "bitwise_or(int(mod(4*abs(#), 1e9)), 3)",
    "bitwise_xor(int(mod(4*abs(#), 1e9)), int(mod(9*abs(#), 1e9)))",
    "ceil(#)",
    "cos(#)",
    "cosh(sin(#))",
    "degrees(#)/40",
    "div(9*#, 2)",
    "exp(sin(#))",
    "floor(1.37*#)",
    "int(2.13*#)",
    "ln(1 + abs(#))",
    "log(.5 + abs(#))",
    "max(#, #)",
    "max(#, #, #, #)",
    "min(#, #)",
    "min(#, #, #)",
    "mod(#, 1.19)",
    "pow(.2 + abs(#), sin(#))",
    "pow(#, 2)",
    "radians(47*#)",
    "select(#, #, #)",
    "select(# - 1, #, #, #)",
    "sin(#)",
    "sinh(cos(#))",
    "sqrt(abs(#))",
    "tan(sin(#))",
    "tanh(#)",
    "vdot(@, @)",
    "vlength(@)",
    "vcross(@, @).x",
    "vrotate(@, 40*@).y",
    "@.z",
    "val(str(#, 0, 3))",
    "strlen(concat(\"ab\", str(#, 3, 1)))",
    "(asc(\"B\")/50 + #)",
    "strcmp(\"ab\", \"b\")",
    "(strupr(\"x\") = \"X\" ? # : 2)",
    "<#, #, #, #>.t",
    "<#, #>.v",
};
enum { FLOAT_PATTERNS = sizeof float_patterns / sizeof *float_patterns };

void say_float(struct language *draw, int depth)
{
    size_t call = below(&draw->state, 16);
    if (depth <= 0 || one_in(&draw->state, 4))
        say_float_leaf(draw);
    else if (call == 0 && draw->names[NAME_FUNCTION])
        say_call(draw, NAME_FUNCTION, depth - 1);
    else if (call == 1 && draw->names[NAME_VALUE] && draw->calling)
        say_call(draw, NAME_VALUE, depth - 1);
    else
        say_pattern(draw, float_patterns[below(&draw->state, FLOAT_PATTERNS)],
                    depth - 1);
}

/* --- vectors -------------------------------------------------------------- */

static const char *const vector_patterns[] = {
    "<#, #, #>",
    "<#, #, #>",
    "(@ + @)",
    "(@ - @)",
    "(@*#)",
    "(#*@)",
    "(@/(2 + abs(#)))",
    "(@*@)",
    "(-@)",
    "(@ + #)",
    "(<#, #> + @)",
    "(#*x + #*y)",
    "(# > # ? @ : @)",
    "vcross(@, @)",
    "vrotate(@, 60*@)",
    "vrotate(@, #*90*y)",
    "vaxis_rotate(@, <.3, .5, -.4>, 70*#)",
    "vnormalize(@ + <1.7, 2.3, 9>)",
};
enum { VECTOR_PATTERNS = sizeof vector_patterns / sizeof *vector_patterns };

static void say_vector_leaf(struct language *draw)
{
    if (draw->names[NAME_VECTOR] && one_in(&draw->state, 2))
        say_name(draw, NAME_VECTOR);
    else if (one_in(&draw->state, 2))
        SAY_ONE_OF(draw, "x", "y", "z");
    else
        say(draw, "<%.3f, %.3f, %.3f>", between(&draw->state, -2, 2),
            between(&draw->state, -2, 2), between(&draw->state, -2, 2));
}

void say_vector(struct language *draw, int depth)
{
    if (depth <= 0 || one_in(&draw->state, 4))
        say_vector_leaf(draw);
    else
        say_pattern(draw, vector_patterns[below(&draw->state, VECTOR_PATTERNS)],
                    depth - 1);
}

/* --- values within bounds ------------------------------------------------- */

void say_number(struct language *draw, double low, double high)
{
    if (!one_in(&draw->state, 4)) {
        say(draw, "%.4f", between(&draw->state, low, high));
        return;
    }
    say(draw, "%.3f + %.3f*", low, high - low);
    if (one_in(&draw->state, 2)) {
        say(draw, "abs(sin(");
        say_float(draw, 2);
        say(draw, "))");
    } else {
        say(draw, "(.5 + .5*cos(");
        say_float(draw, 3);
        say(draw, "))");
    }
}

void say_point(struct language *draw, double low, double high)
{
    say(draw, "<");
    for (int i = 0; i < 3; i++) {
        say_number(draw, low, high);
        say(draw, i < 2 ? ", " : ">");
    }
}

void say_amount(struct language *draw, const char *word, double low, double high)
{
    begin_line(draw);
    say(draw, "%s ", word);
    say_number(draw, low, high);
    end_line(draw);
}

void say_arrow(struct language *draw, double low, double high)
{
    say_number(draw, low, high);
    say(draw, one_in(&draw->state, 2) ? "*" : " * ");
    say(draw, "vnormalize(<.013, .027, .041> + ");
    say_vector(draw, 2);
    say(draw, ")");
}

/* --- colours -------------------------------------------------------------- */

static void say_made_color(struct language *draw)
{
    switch (below(&draw->state, 6)) {
    case 0:
        SAY_ONE_OF(draw, "rgb ", "color rgb ", "srgb ");
        say_number(draw, .2, 1);
        break;
    case 1:
        say(draw, "red ");
        say_number(draw, 0, 1);
        say(draw, " green ");
        say_number(draw, 0, 1);
        say(draw, " blue ");
        say_number(draw, 0, 1);
        break;
    default:
        SAY_ONE_OF(draw, "rgb ", "rgb ", "color rgb ", "srgb ", "color srgb ");
        say_point(draw, .05, 1);
        break;
    }
}

static void say_named_color(struct language *draw)
{
    SAY_ONE_OF(draw, "", "color ");
    if (draw->library && one_in(&draw->state, 2))
        SAY_ONE_OF(draw, "Red", "SteelBlue", "Gold", "Gray60", "Orange");
    else
        say_name(draw, NAME_COLOR);
    switch (below(&draw->state, 4)) {
    case 0:
        say(draw, "*(");
        say_number(draw, .3, 1);
        say(draw, ")");
        break;
    case 1: say(draw, "*<.6, .8, .9>"); break;
    default: break;
    }
}

static void say_palette_color(struct language *draw)
{
    say_name(draw, NAME_PALETTE);
    if (draw->turning && one_in(&draw->state, 2))
        say(draw, "[mod(I, %d)]", LANGUAGE_ELEMENTS);
    else
        say(draw, "[%zu]", below(&draw->state, LANGUAGE_ELEMENTS));
}

void say_color(struct language *draw)
{
    if (draw->names[NAME_COLOR] && one_in(&draw->state, 3))
        say_named_color(draw);
    else if (draw->names[NAME_PALETTE] && one_in(&draw->state, 5))
        say_palette_color(draw);
    else
        say_made_color(draw);
}
