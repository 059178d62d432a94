/* language_values.c - evaluates patterns, generates names and random expressions. */
#include "tests/oracle/language_parts.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* ---- Names --------------------------------------------------------------- */

static const char *const name_of[LANGUAGE_NAMES] = {
    [NAME_FLOAT] = "N",      [NAME_VECTOR] = "V",        [NAME_COLOR] = "Color",
    [NAME_ARRAY] = "List",   [NAME_PALETTE] = "Palette", [NAME_FUNCTION] = "Wave",
    [NAME_VALUE] = "Bent",   [NAME_PIGMENT] = "Paint",   [NAME_FINISH] = "Shine",
    [NAME_TEXTURE] = "Look", [NAME_MOTION] = "Motion",   [NAME_SOLID] = "Solid",
};

static bool is_word(const char *word, const char *text, size_t length)
{
    return strlen(word) == length && strncmp(word, text, length) == 0;
}

/* Prints an existing name, or a new name. */
static void write_name(struct language *draw, enum language_name kind, char use)
{
    size_t *count = &draw->names[kind];
    if (use == '!')
        ++*count;
    else
        fprintf(draw->text, "%s%zu", name_of[kind],
                use == '=' ? below(&draw->state, *count) : *count);
}

/* ---- Expressions --------------------------------------------------------- */

static void write_float(struct language *draw, int depth);
static void write_vector(struct language *draw, int depth);

/* Prints an operation. # becomes a float, @ a vector. Other characters are copied. */
static void write_operation(struct language *draw, const char *operation, int depth)
{
    for (; *operation; operation++)
        if (*operation == '#')
            write_float(draw, depth);
        else if (*operation == '@')
            write_vector(draw, depth);
        else
            putc(*operation, draw->text);
}

/* Arguments are in the functions' domains, and no value is too large for a sine. */
static const char *const float_patterns[] = {
    /* operators */
    "(# + #)", "(# - #)", "(# * #)", "#*#", "(# + # * #)", "(# - # - #)",
    "(# / (1.5 + abs(#)))", "(#/2/4*3)", "(-#)", "(2 - -#)", "(!#)", "(# < #)",
    "(# >= # | # = 1)", "(# != # & # <= #)", "(# > # ? # : #)",
    "(# < # ? # : # > # ? # : #)",
    /* functions */
    "abs(#)", "acos(cos(#))", "asin(sin(#))", "acosh(1 + abs(#))", "asinh(#)",
    "atan(#)", "atan2(#, .7 + abs(#))", "atanh(.9*sin(#))",
    "bitwise_and(int(mod(10*abs(#), 1e9)), 21)",
    "bitwise_or(int(mod(4*abs(#), 1e9)), 3)",
    "bitwise_xor(int(mod(4*abs(#), 1e9)), int(mod(9*abs(#), 1e9)))", "ceil(#)",
    "cos(#)", "cosh(sin(#))", "degrees(#)/40", "div(9*#, 2)", "exp(sin(#))",
    "floor(1.37*#)", "int(2.13*#)", "ln(1 + abs(#))", "log(.5 + abs(#))", "max(#, #)",
    "max(#, #, #, #)", "min(#, #)", "min(#, #, #)", "mod(#, 1.19)",
    "pow(.2 + abs(#), sin(#))", "pow(#, 2)", "radians(47*#)", "select(#, #, #)",
    "select(# - 1, #, #, #)", "sin(#)", "sinh(cos(#))", "sqrt(abs(#))", "tan(sin(#))",
    "tanh(#)", "vdot(@, @)", "vlength(@)", "vcross(@, @).x", "vrotate(@, 40*@).y",
    "@.z", "val(str(#, 0, 3))", "strlen(concat(\"ab\", str(#, 3, 1)))",
    "(asc(\"B\")/50 + #)", "strcmp(\"ab\", \"b\")", "(strupr(\"x\") = \"X\" ? # : 2)",
    "<#, #, #, #>.t", "<#, #>.v"
};

static void write_float(struct language *draw, int depth)
{
    size_t call = below(&draw->state, 16);
    const char *operation = "(#, #)";
    if (depth <= 0 || one_in(&draw->state, 4)) {
        write_text(draw, "$float_leaf;");
        return;
    }
    if (call == 0 && draw->names[NAME_FUNCTION])
        write_text(draw, "$=Wave;");
    else if (call == 1 && draw->names[NAME_VALUE] && draw->calling)
        write_text(draw, "$=Bent;");
    else
        operation = float_patterns[below(&draw->state, sizeof float_patterns
                                                           / sizeof *float_patterns)];
    write_operation(draw, operation, depth - 1);
}

static const char *const vector_patterns[] = {
    /* operators */
    "<#, #, #>", "<#, #, #>", "(@ + @)", "(@ - @)", "(@*#)", "(#*@)",
    "(@/(2 + abs(#)))", "(@*@)", "(-@)", "(@ + #)", "(<#, #> + @)", "(#*x + #*y)",
    "(# > # ? @ : @)",
    /* functions */
    "vcross(@, @)", "vrotate(@, 60*@)", "vrotate(@, #*90*y)",
    "vaxis_rotate(@, <.3, .5, -.4>, 70*#)", "vnormalize(@ + <1.7, 2.3, 9>)"
};

static void write_vector(struct language *draw, int depth)
{
    size_t count = sizeof vector_patterns / sizeof *vector_patterns;
    if (depth > 0 && !one_in(&draw->state, 4))
        write_operation(draw, vector_patterns[below(&draw->state, count)], depth - 1);
    else if (draw->names[NAME_VECTOR] && one_in(&draw->state, 2))
        write_text(draw, "$=V;");
    else
        write_text(draw, "$2[$[x|y|z$]|<^3-2:2^, ^3-2:2^, ^3-2:2^>$]");
}

static void write_number(struct language *draw, double low, double high)
{
    if (!one_in(&draw->state, 4))
        write_text(draw, "%.4f", between(&draw->state, low, high));
    else
        write_text(draw, "%.3f + %.3f*$2[abs(sin($f2;))|(.5 + .5*cos($f3;))$]", low,
                   high - low);
}

/* --- patterns ------------------------------------------------------------- */

static void expand(struct language *draw, const char *pattern, const char *end);

/* Reads LOW:HIGH. Returns the position of the character that ends the range. */
static const char *read_range(const char *text, double *low, double *high)
{
    char *end;
    *low = strtod(text, &end);
    *high = strtod(end + 1, &end);
    return end + 1;
}

/* Prints the numbers in ^, up to the next part of another kind. */
static const char *write_numbers(struct language *draw, const char *pattern,
                                 const char *end)
{
    double number[8], low, high;
    const char *field[8];
    size_t count = 0;
    for (const char *p = pattern; p < end && !strchr("~@$", *p); p++)
        if (*p == '^') {
            field[count++] = p + 1;
            p = strchr(p + 1, '^');
        }
    for (size_t i = count; i-- > 0;) {
        read_range(field[i] + 1, &low, &high);
        number[i] = *field[i] == '#' ? low + (double)below(&draw->state, (size_t)high)
                                     : between(&draw->state, low, high);
    }
    for (size_t i = 0; i < count; i++) {
        fprintf(draw->text, "%.*f", *field[i] == '#' ? 0 : *field[i] - '0', number[i]);
        pattern = strchr(field[i], '^') + 1;
        for (; i + 1 < count && pattern + 1 < field[i + 1]; pattern++)
            putc(*pattern, draw->text);
    }
    return pattern;
}

static void write_point(struct language *draw, double low, double high)
{
    for (int i = 0; i < 3; i++) {
        fputs(i ? ", " : "<", draw->text);
        write_number(draw, low, high);
    }
    putc('>', draw->text);
}

/* Returns the end of the alternative that begins at p. */
static const char *alternative_end(const char *p)
{
    for (int open = 0; open > 0 || (*p != '|' && strncmp(p, "$]", 2) != 0); p++)
        if (*p == '$')
            open += (p[1 + strcspn(p + 1, "$[];|")] == '[') - (p[1] == ']');
    return p;
}

/* Lists the alternatives of the brackets at p. Returns the place after them. */
static const char *list_alternatives(const char *p, const char *alternative[16],
                                     size_t *count)
{
    for (*count = 0; *p != '$'; p = alternative_end(p))
        alternative[(*count)++] = ++p;
    return p + 2;
}

static const char *write_choice(struct language *draw, const char *pattern)
{
    const char *alternative[16];
    char *begin;
    size_t cases = strtoul(pattern, &begin, 10), count;
    const char *end = list_alternatives(begin, alternative, &count);
    size_t which = below(&draw->state, cases ? cases : count);
    which = which < count ? which : count - 1;
    expand(draw, alternative[which], alternative_end(alternative[which]));
    return end;
}

static bool holds(const struct language *draw, const char *name, size_t length)
{
    const struct {
        const char *name;
        bool holds;
    } flags[] = {
        { "clear", draw->clear },     { "copied", draw->copied },
        { "library", draw->library }, { "metals", draw->metals },
        { "streams", draw->streams }, { "turning", draw->turning },
    };
    for (size_t i = 0; i < sizeof flags / sizeof *flags; i++)
        if (is_word(flags[i].name, name, length))
            return flags[i].holds;
    for (int kind = 0; kind < LANGUAGE_NAMES; kind++)
        if (is_word(name_of[kind], name, length))
            return draw->names[kind] > 0;
    abort();
}

static const char *write_condition(struct language *draw, const char *name)
{
    const char *alternative[16];
    size_t length = strcspn(name, "0123456789["), count;
    char *begin;
    size_t cases = strtoul(name + length, &begin, 10);
    const char *end = list_alternatives(begin, alternative, &count);
    bool first = holds(draw, name, length) && (!cases || one_in(&draw->state, cases));
    expand(draw, alternative[!first], alternative_end(alternative[!first]));
    return end;
}

static const char *write_repeatedly(struct language *draw, const char *range)
{
    double low, high;
    const char *pattern = read_range(range, &low, &high),
               *end = alternative_end(pattern);
    for (size_t left = (size_t)low + below(&draw->state, (size_t)high); left > 0;
         left--)
        expand(draw, pattern, end);
    return end + 2;
}

static void write_rule(struct language *draw, const char *name, size_t length)
{
    const struct language_rule *rule = language_rules;
    if (length == 2 && strchr("123", name[1])) {
        (*name == 'f' ? write_float : write_vector)(draw, name[1] - '0');
        return;
    }
    for (int kind = 0; strchr("=+!", *name) && kind < LANGUAGE_NAMES; kind++)
        if (is_word(name_of[kind], name + 1, length - 1)) {
            write_name(draw, (enum language_name)kind, *name);
            return;
        }
    while (!is_word(rule->name, name, length))
        if (++rule == language_rules + language_rule_count)
            abort();
    rule->write_text ? rule->write_text(draw) : write_pattern(draw, rule->pattern);
}

static const char *write_part(struct language *draw, const char *name)
{
    size_t length = strcspn(name, ";");
    if (*name == '.')
        return name + 1;
    if (*name == '?')
        return write_condition(draw, name + 1);
    if (*name == '*')
        return write_repeatedly(draw, name + 1);
    if (name[strspn(name, "0123456789")] == '[')
        return write_choice(draw, name);
    write_rule(draw, name, length);
    return name + length + 1;
}

static void expand(struct language *draw, const char *pattern, const char *end)
{
    double low, high;
    while (pattern < end)
        if (*pattern == '~') {
            pattern = read_range(pattern + 1, &low, &high);
            write_number(draw, low, high);
        } else if (*pattern == '@') {
            pattern = read_range(pattern + 1, &low, &high);
            write_point(draw, low, high);
        } else if (*pattern == '^')
            pattern = write_numbers(draw, pattern, end);
        else if (*pattern == '$')
            pattern = write_part(draw, pattern + 1);
        else
            putc(*pattern++, draw->text);
}

void write_pattern(struct language *draw, const char *pattern)
{
    expand(draw, pattern, pattern + strlen(pattern));
}

void write_text(struct language *draw, const char *format, ...)
{
    char pattern[1200];
    va_list values;
    va_start(values, format);
    vsnprintf(pattern, sizeof pattern, format, values);
    va_end(values);
    write_pattern(draw, pattern);
}
