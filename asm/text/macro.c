/* macro.c - definitions of macros, their arguments, and substitution in their
 * bodies. */
#include "asm/text/macro.h"
#include "base/plural.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* ---- Splitting text at commas ---- */

static const char *skip_string(const char *at, const char *end)
{
    for (at++; at < end && *at != '"'; at++)
        if (*at == '\\' && end - at > 1)
            at++;
    return at < end ? at + 1 : end;
}

/* Returns the comma or comment after an argument. Commas in brackets and strings belong
 * to the argument. */
static const char *end_of_argument(const char *at, const char *end)
{
    int depth = 0;
    while (at < end && *at != ';' && (*at != ',' || depth > 0)) {
        depth += *at == '[' || *at == '(';
        depth -= *at == ']' || *at == ')';
        at = *at == '"' ? skip_string(at, end) : at + 1;
    }
    return at;
}

static struct span trim(const char *begin, const char *end)
{
    struct span span;
    while (begin < end && isspace((unsigned char)*begin))
        begin++;
    while (begin < end && isspace((unsigned char)end[-1]))
        end--;
    span.begin = begin;
    span.end = end;
    return span;
}

/* Continues lexing at another position of the line. */
static void move_to(struct cursor *cursor, const char *at)
{
    cursor->token.end = at;
    cursor_next(cursor);
}

static struct span take_argument(struct cursor *cursor)
{
    const char *begin = cursor->token.begin;
    const char *end = end_of_argument(begin, cursor->line->end);
    move_to(cursor, end);
    return trim(begin, end);
}

/* ---- Definition ---- */

static bool parse_parameter(struct cursor *cursor, struct macro *macro)
{
    struct parameter *parameter = arena_add(cursor->assembler->arena,
                                            &macro->parameters, &macro->parameter_count,
                                            &macro->parameter_capacity, NULL,
                                            sizeof *parameter);
    size_t length;
    if (!parameter)
        return false;
    if (!expect_name(cursor, "a parameter's name", &parameter->name.begin, &length))
        return false;
    parameter->name.end = parameter->name.begin + length;
    if (cursor_take(cursor, '='))
        parameter->otherwise = take_argument(cursor);
    return true;
}

struct macro *macro_parse(struct cursor *cursor)
{
    struct macro *macro = arena_take(cursor->assembler->arena, sizeof *macro);
    const char *name;
    size_t length;
    if (!macro || !expect_name(cursor, "the macro's name", &name, &length))
        return NULL;
    if (c205_insn_named(name, length)) {
        report_at(cursor, name, "'%.*s' is an instruction", (int)length, name);
        return NULL;
    }
    macro->name = arena_text(cursor->assembler->arena, name, length);
    if (!macro->name)
        return NULL;
    while (!cursor_at_end(cursor)) {
        if (!parse_parameter(cursor, macro))
            return NULL;
        if (!cursor_at_end(cursor) && !expect_operator(cursor, ',', "','"))
            return NULL;
    }
    return macro;
}

bool macro_add_line(struct assembler *assembler, struct macro *macro,
                    const struct line *line)
{
    return arena_add(assembler->arena, &macro->lines, &macro->line_count,
                     &macro->line_capacity, line, sizeof *line);
}

/* ---- Call ---- */

static bool fill_defaults(struct cursor *cursor, const struct macro *macro,
                          struct span *arguments)
{
    for (size_t i = 0; i < macro->parameter_count; i++) {
        const struct parameter *parameter = &macro->parameters[i];
        if (arguments[i].begin < arguments[i].end)
            continue;
        arguments[i] = parameter->otherwise;
        if (!parameter->otherwise.begin)
            return report_at(cursor, cursor->token.begin,
                             "expected argument '%.*s' of macro %s",
                             (int)(parameter->name.end - parameter->name.begin),
                             parameter->name.begin, macro->name);
    }
    return true;
}

const struct span *macro_arguments(struct cursor *cursor, const struct macro *macro)
{
    struct span *arguments;
    size_t i = 0;
    arguments = arena_take(cursor->assembler->arena,
                           (macro->parameter_count + 1) * sizeof *arguments);
    if (!arguments)
        return NULL;
    while (!cursor_at_end(cursor)) {
        if (i == macro->parameter_count) {
            report_at(cursor, cursor->token.begin,
                      "too many arguments: macro %s has %zu parameter%s", macro->name,
                      i, plural(i));
            return NULL;
        }
        arguments[i++] = take_argument(cursor);
        cursor_take(cursor, ',');
    }
    return fill_defaults(cursor, macro, arguments) ? arguments : NULL;
}

/* ---- Substitution ---- */

struct macro_text {
    char *text;
    size_t length;
    bool full;
};

static void append(struct macro_text *output, const char *text, size_t length)
{
    output->full = output->full || length > MAX_LINE - output->length;
    if (output->full)
        return;
    memcpy(output->text + output->length, text, length);
    output->length += length;
}

static void append_number(struct macro_text *output, uint64_t number)
{
    char text[24];
    snprintf(text, sizeof text, "%" PRIu64, number);
    append(output, text, strlen(text));
}

static const struct span *find_argument(const struct substitution *substitution,
                                        const char *name, size_t length)
{
    const struct macro *macro = substitution->macro;
    for (size_t i = 0; macro && i < macro->parameter_count; i++) {
        const struct span *known = &macro->parameters[i].name;
        if ((size_t)(known->end - known->begin) == length
            && memcmp(known->begin, name, length) == 0)
            return &substitution->arguments[i];
    }
    return NULL;
}

static size_t name_length(const char *at, const char *end)
{
    const char *begin = at;
    if (at < end && is_name_start(*at))
        while (at < end && is_name_part(*at) && *at != '.')
            at++;
    return (size_t)(at - begin);
}

/* Substitutes the text after the backslash at `at`. Returns where to continue. An
 * unknown sequence is copied, so strings keep their escapes. */
static const char *substitute_one(const struct substitution *substitution,
                                  const char *at, const char *end,
                                  struct macro_text *output)
{
    char next = end - at > 1 ? at[1] : '\0';
    size_t length = name_length(at + 1, end);
    const struct span *argument = find_argument(substitution, at + 1, length);
    if (length && argument) {
        append(output, argument->begin, (size_t)(argument->end - argument->begin));
        return at + 1 + length;
    }
    if (next == '@' && substitution->unique)
        append_number(output, *substitution->unique);
    else if (next == '+' && substitution->count)
        append_number(output, *substitution->count);
    else if (next == '(' && end - at > 2 && at[2] == ')' && substitution->macro)
        return at + 3; /* \() ends a name and has no other effect */
    else
        append(output, at, next ? 2 : 1);
    return at + (next ? 2 : 1);
}

size_t substitute(const struct substitution *substitution, const struct line *line,
                  char text[MAX_LINE])
{
    struct macro_text output = { NULL, 0, false };
    const char *at = line->text, *next;
    output.text = text;
    while (at < line->text_end) {
        next = memchr(at, '\\', (size_t)(line->text_end - at));
        if (!next)
            next = line->text_end;
        append(&output, at, (size_t)(next - at));
        at = next;
        if (at < line->text_end)
            at = substitute_one(substitution, at, line->text_end, &output);
    }
    return output.full ? MAX_LINE + 1 : output.length;
}
