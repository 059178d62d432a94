/* expand.c - the pass that executes includes, macros and repetitions. */
#include "asm/text/shown_line.h"

#include <string.h>

#include "asm/text/expression.h"
#include "asm/text/suggest.h"

/* ---- The stack of texts ---- */

/* Stops the expansion with a report. The message has a %zu for the limit. */
static bool halt(struct expander *expander, const struct line *line,
                 const char *message, size_t limit)
{
    expander->halted = true;
    return report(expander->assembler, line, line->begin, message, limit);
}

static struct expansion *push(struct expander *expander, const struct line *line,
                              enum frame_kind kind)
{
    static const struct expansion empty;
    struct expansion *frame;
    if (expander->depth == MAX_FRAMES) {
        halt(expander, line,
             "more than %zu nested includes and macros; does one contain itself?",
             MAX_FRAMES);
        return NULL;
    }
    frame = &expander->frames[expander->depth++];
    *frame = empty;
    frame->kind = kind;
    frame->conditions = expander->condition_depth;
    return frame;
}

/* Pushes the body of a macro or .rept. line is the line that calls it. */
static struct expansion *push_body(struct expander *expander, const struct line *line,
                                   enum frame_kind kind, const struct macro *body)
{
    struct call *call = arena_take(expander->assembler->arena, sizeof *call);
    struct expansion *frame = call ? push(expander, line, kind) : NULL;
    if (!frame)
        return NULL;
    call->line = line;
    call->macro = kind == FRAME_MACRO ? body : NULL;
    frame->call = call;
    frame->body = body;
    return frame;
}

static void push_source(struct expander *expander, const struct line *line,
                        const struct asm_source *source)
{
    struct expansion *frame = push(expander, line, FRAME_FILE);
    if (frame) {
        frame->name = source->name;
        frame->at = source->text;
        frame->end = source->end;
    }
}

/* Starts the next repetition of a .rept. After the last one, pops the text on top of
 * the stack and returns false. */
static bool repeat_or_pop(struct expander *expander)
{
    struct expansion *frame = &expander->frames[expander->depth - 1];
    condition_close(expander, frame->conditions);
    if (frame->kind == FRAME_REPEAT && ++frame->count < frame->repeats) {
        frame->next = 0;
        return true;
    }
    expander->depth--;
    return false;
}

/* ---- Reading lines ---- */

/* The use of a line: for the parser, or for the body of a repetition or macro. */
enum purpose { TO_PARSE, FOR_REPEAT, FOR_MACRO };

static bool spend(struct expander *expander, const struct line *line, size_t bytes)
{
    expander->expansion += bytes + sizeof(struct line);
    if (expander->expansion <= MAX_EXPANSION)
        return true;
    return halt(expander, line, "macros and repetitions expand to more than %zu bytes",
                MAX_EXPANSION);
}

static struct line *file_line(struct expander *expander, struct expansion *frame)
{
    struct line *line = NULL;
    const char *newline;
    if (frame->at < frame->end)
        line = arena_take(expander->assembler->arena, sizeof *line);
    if (!line)
        return NULL;
    newline = memchr(frame->at, '\n', (size_t)(frame->end - frame->at));
    if (!newline)
        newline = frame->end;
    line->file = frame->name;
    line->number = ++frame->number;
    line->text = line->begin = frame->at;
    line->text_end = newline;
    line->end = line->text_end;
    frame->at = newline + (newline < frame->end);
    if ((size_t)(line->end - line->begin) > MAX_LINE) {
        line->text_end = line->end = line->begin + 40;
        halt(expander, line, "the line has more than %zu bytes", MAX_LINE);
    }
    return line;
}

/* Returns the substitutions of a line. \@ is not replaced in the definition of a macro
 * within a macro, because it belongs to the expansions of the inner macro. \+ is not
 * replaced while the body of a .rept is captured. */
static struct substitution rules(const struct expansion *frame, enum purpose purpose)
{
    struct substitution rules = { NULL, NULL, NULL, NULL };
    if (frame->kind == FRAME_MACRO) {
        rules.macro = frame->body;
        rules.arguments = frame->arguments;
        rules.unique = purpose == FOR_MACRO ? NULL : &frame->unique;
    } else if (purpose == TO_PARSE) {
        rules.count = &frame->count;
    }
    return rules;
}

static struct line *body_line(struct expander *expander, struct expansion *frame,
                              enum purpose purpose)
{
    struct substitution substitution = rules(frame, purpose);
    const struct line *model;
    struct line *line;
    size_t length;
    if (frame->next == frame->body->line_count)
        return NULL;
    model = &frame->body->lines[frame->next++];
    length = substitute(&substitution, model, expander->scratch);
    line = arena_take(expander->assembler->arena, sizeof *line);
    if (!line || !spend(expander, model, length))
        return NULL;
    *line = *model;
    if (length > MAX_LINE) {
        halt(expander, model, "the line expands to more than %zu bytes", MAX_LINE);
        return NULL;
    }
    line->call = frame->call;
    if (frame->kind == FRAME_MACRO && !line->written) {
        line->written = model->text;
        line->written_end = model->text_end;
    }
    line->text = line->begin = arena_text(expander->assembler->arena, expander->scratch,
                                          length);
    if (!line->text)
        return NULL;
    line->text_end = line->end = line->text + length;
    return line;
}

/* Returns the next line of the text on top of the stack. Returns NULL at its end. */
static struct line *read_line(struct expander *expander, enum purpose purpose)
{
    struct expansion *frame = &expander->frames[expander->depth - 1];
    return frame->kind == FRAME_FILE ? file_line(expander, frame)
                                     : body_line(expander, frame, purpose);
}

/* ---- Bodies of macros and repetitions ---- */

static bool skip_labels(struct cursor *cursor, const char **end)
{
    struct cursor label = *cursor;
    bool found = false;
    while (label.token.kind == TOKEN_NAME) {
        cursor_next(&label);
        if (!cursor_at(&label, ':'))
            break;
        *end = label.token.end;
        cursor_next(&label);
        *cursor = label;
        found = true;
    }
    return found;
}

static int nesting(struct expander *expander, const struct line *line,
                   const char *opening, const char *closing)
{
    struct cursor cursor = cursor_start(expander->assembler, line);
    const char *end;
    skip_labels(&cursor, &end);
    if (cursor.token.kind != TOKEN_DIRECTIVE)
        return 0;
    return token_is(&cursor.token, opening) - token_is(&cursor.token, closing);
}

/* Stores the lines up to the matching end directive. */
static bool capture(struct expander *expander, const struct line *start,
                    struct macro *body, enum purpose purpose)
{
    const char *opening = purpose == FOR_MACRO ? ".macro" : ".rept";
    const char *closing = purpose == FOR_MACRO ? ".endm" : ".endr";
    const struct line *line;
    int depth = 1;
    while ((line = read_line(expander, purpose)) != NULL && !expander->halted) {
        depth += nesting(expander, line, opening, closing);
        if (depth == 0)
            return true;
        if (!macro_add_line(expander->assembler, body, line))
            return false;
    }
    return report(expander->assembler, start, start->begin, "this %s has no %s",
                  opening, closing);
}

/* ---- Directives ---- */

static void define_macro(struct expander *expander, struct cursor *cursor)
{
    const char *at = cursor->token.begin;
    struct macro *macro = macro_parse(cursor), unnamed, *body;
    struct symbol *symbol;
    memset(&unnamed, 0, sizeof unnamed);
    body = macro ? macro : &unnamed; /* the body is skipped even if the head is
                                        invalid */
    if (!capture(expander, cursor->line, body, FOR_MACRO) || !macro)
        return;
    shown_line_define(expander, cursor->line, macro);
    symbol = symbol_intern(expander->assembler, macro->name, strlen(macro->name));
    if (symbol && symbol->macro)
        report_at(cursor, at, "macro '%s' is already defined", symbol->name);
    else if (symbol)
        symbol->macro = macro;
}

static void repeat(struct expander *expander, struct cursor *cursor)
{
    struct macro *body = arena_take(expander->assembler->arena, sizeof *body);
    struct expansion *frame;
    int64_t count = 0;
    bool good;
    if (!body)
        return;
    good = parse_integer(cursor, 0, MAX_WORDS, "a count", &count) && expect_end(cursor);
    if (!capture(expander, cursor->line, body, FOR_REPEAT) || !good || count == 0
        || body->line_count == 0)
        return;
    frame = push_body(expander, cursor->line, FRAME_REPEAT, body);
    if (frame)
        frame->repeats = (uint64_t)count;
}

static void include(struct expander *expander, struct cursor *cursor)
{
    const char *at = cursor->token.begin, *from = "";
    struct asm_source source;
    c205_error error;
    size_t length;
    char *name = expect_string(cursor, &length);
    if (!name || !expect_end(cursor))
        return;
    for (unsigned i = 0; i < expander->depth; i++)
        if (expander->frames[i].kind == FRAME_FILE)
            from = expander->frames[i].name;
    if (source_find(expander->assembler, name, from, &source, &error))
        push_source(expander, cursor->line, &source);
    else
        report_at(cursor, at, "cannot read '%.200s': %.200s", name, error.message);
}

static void stray(struct expander *expander, struct cursor *cursor)
{
    (void)expander;
    report_at(cursor, cursor->line->begin,
              ".endm without .macro, or .endr without .rept");
}

static void call(struct expander *expander, struct cursor *cursor,
                 const struct macro *macro)
{
    const struct span *arguments;
    struct expansion *frame;
    cursor_next(cursor);
    arguments = macro_arguments(cursor, macro);
    frame = arguments ? push_body(expander, cursor->line, FRAME_MACRO, macro) : NULL;
    if (frame) {
        frame->arguments = arguments;
        frame->unique = expander->unique++;
        shown_line_call(expander);
    }
}

typedef void directive(struct expander *, struct cursor *);

static const struct {
    const char *name;
    directive *obey;
} directives[] = { { ".macro", define_macro },
                   { ".rept", repeat },
                   { ".include", include },
                   { ".endm", stray },
                   { ".endr", stray } };

const char *expand_name(size_t i)
{
    return i < sizeof directives / sizeof *directives ? directives[i].name : NULL;
}

static directive *find_directive(const struct token *token)
{
    for (size_t i = 0; i < sizeof directives / sizeof *directives; i++)
        if (token->kind == TOKEN_DIRECTIVE && token_is(token, directives[i].name))
            return directives[i].obey;
    return NULL;
}

static const struct macro *find_macro(const struct expander *expander,
                                      const struct token *token)
{
    const struct symbol *symbol;
    if (token->kind != TOKEN_NAME)
        return NULL;
    symbol = symbol_find(expander->assembler, token->begin,
                         (size_t)(token->end - token->begin));
    return symbol ? symbol->macro : NULL;
}

/* ---- The pass ---- */

/* Returns the labels before a directive or macro call as a line, and stores the rest of
 * the line for the next call. */
static const struct line *split(struct expander *expander, const struct line *line,
                                const char *at)
{
    struct line *halves;
    halves = arena_take(expander->assembler->arena, 2 * sizeof *halves);
    if (!halves)
        return NULL;
    halves[0] = halves[1] = *line;
    halves[0].end = halves[1].begin = at;
    expander->pending = &halves[1];
    return &halves[0];
}

/* Executes a directive of this pass or a macro call, and returns NULL. If labels come
 * before it, it is executed at the next call. Labels and all other lines are returned
 * for the parser. */
static const struct line *obey(struct expander *expander, const struct line *line)
{
    struct cursor cursor = cursor_start(expander->assembler, line);
    const char *end = NULL;
    bool labels = skip_labels(&cursor, &end);
    directive *found = find_directive(&cursor.token);
    const struct macro *macro = find_macro(expander, &cursor.token);
    if (condition_skips(expander)) {
        condition_directive(expander, &cursor);
        return NULL;
    }
    if (!found && !macro && !condition_names(&cursor.token))
        return line;
    if (labels)
        return split(expander, line, end);
    if (macro) {
        call(expander, &cursor, macro);
    } else if (found) {
        cursor_next(&cursor);
        found(expander, &cursor);
    } else {
        condition_directive(expander, &cursor);
    }
    return NULL;
}

static const struct line *next_line(struct expander *expander)
{
    const struct line *line = expander->pending;
    expander->pending = NULL;
    while (!line && !expander->halted && expander->depth > 0) {
        line = read_line(expander, TO_PARSE);
        if (!line && expander->assembler->arena->failed)
            return NULL;
        if (!line)
            repeat_or_pop(expander);
    }
    return line;
}

const struct line *expander_next(struct expander *expander)
{
    const struct line *line, *handed;
    while ((line = next_line(expander)) != NULL && !expander->halted) {
        if (too_many_errors(expander->assembler))
            return NULL;
        handed = obey(expander, line);
        if (handed)
            return handed;
    }
    return NULL;
}

struct expander *expander_new(struct assembler *assembler,
                              const struct asm_source *source)
{
    struct expander *expander = arena_take(assembler->arena, sizeof *expander);
    if (expander) {
        expander->assembler = assembler;
        push_source(expander, NULL, source);
    }
    return expander;
}
