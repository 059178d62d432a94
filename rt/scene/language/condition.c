/* condition.c - executes #if, #ifdef, #ifndef, #elseif, #else, #end and #break. */
#include "rt/scene/language/condition.h"

#include "rt/scene/language/scene_expression.h"

#include <math.h>
#include <string.h>

/* ---- The stack ----------------------------------------------------------- */

static bool unclosed(struct reader *reader, const struct scene_token *at)
{
    return reader_fault(reader, at, "'#%.*s' has no matching '#end'", TOKEN_TEXT(at));
}

bool condition_skip(struct reader *reader, const struct scene_token *at,
                    const char *words, size_t depth)
{
    size_t braces = reader->braces;
    bool found = false;
    while (!found && reader->token.kind != TOKEN_END) {
        if (is_directive(&reader->token, CONDITION_OPENERS))
            depth++;
        found = depth == 1 && is_directive(&reader->token, words);
        if (!found && is_directive(&reader->token, "end"))
            depth--;
        if (!found)
            reader_step(reader);
    }
    reader->braces = braces;
    return found || unclosed(reader, at);
}

struct scene_condition *condition_top(struct reader *reader)
{
    size_t serial = lexer_top(&reader->lexer)->serial;
    size_t count = reader->condition_count;
    return count > reader->sealed && reader->conditions[count - 1].frame == serial
               ? &reader->conditions[count - 1]
               : NULL;
}

struct scene_condition *condition_push(struct reader *reader, enum condition_kind kind,
                                       const struct scene_token *at)
{
    struct scene_condition *condition;
    if (reader->condition_count == MAX_CONDITIONS) {
        reader_fault(reader, at, "more than %d nested conditions", MAX_CONDITIONS);
        return NULL;
    }
    condition = &reader->conditions[reader->condition_count++];
    memset(condition, 0, sizeof *condition);
    condition->kind = kind;
    condition->at = *at;
    condition->frame = lexer_top(&reader->lexer)->serial;
    condition->errors = reader->reports->errors;
    return condition;
}

size_t condition_seal(struct reader *reader)
{
    size_t before = reader->sealed;
    reader->sealed = reader->condition_count;
    return before;
}

bool condition_leave(struct reader *reader, struct scene_condition *condition)
{
    struct scene_token at = condition->at;
    reader->condition_count--;
    if (!condition_skip(reader, &at, "end", 1))
        return false;
    reader_step(reader);
    return true;
}

bool condition_leave_out(struct reader *reader, const struct scene_token *at)
{
    if (condition_skip(reader, at, "end", 1))
        reader_step(reader);
    return false;
}

void conditions_close(struct reader *reader)
{
    const struct scene_condition *top;
    while ((top = condition_top(reader))) {
        unclosed(reader, &top->at);
        reader->condition_count--;
    }
}

/* ---- #if ----------------------------------------------------------------- */

bool condition_holds(double value)
{
    return fabs(value) >= EXPRESSION_SAME;
}

/* Reads "(" condition, or "(" name. The current token is then ")". */
static bool read_brackets(struct reader *reader, bool name, double *value)
{
    size_t sealed = condition_seal(reader);
    bool done = reader_require_sign(reader, '(');
    if (done) {
        (name ? reader_step : reader_next)(reader);
        done = (name ? read_defined : read_full_number)(reader, value)
               && reader_require_sign(reader, ')');
    }
    reader->sealed = sealed;
    return done;
}

bool condition_read(struct reader *reader, double *value)
{
    return read_brackets(reader, false, value);
}

static bool choose(struct reader *reader, struct scene_condition *condition)
{
    double value;
    for (;;) {
        struct scene_token at = condition->at;
        if (!condition_skip(reader, &at, "else elseif end", 1)) {
            reader->condition_count--;
            return false;
        }
        at = reader->token;
        reader_step(reader);
        if (is_directive(&at, "end")) {
            reader->condition_count--;
            return true;
        }
        condition->in_else = at.length == strlen("else");
        if (condition->in_else)
            return true;
        if (!condition_read(reader, &value)) {
            condition_leave(reader, condition);
            return false;
        }
        if (condition_holds(value)) {
            reader_step(reader);
            return true;
        }
    }
}

/* Begins an #if. The current token is the last token of the condition. If the condition
 * has an error (`good` is false), the text up to the #end is skipped. */
static bool begin(struct reader *reader, const struct scene_token *at, bool good,
                  bool holds)
{
    struct scene_condition *condition = NULL;
    if (good)
        condition = condition_push(reader, CONDITION_IF, at);
    if (!condition)
        return condition_leave_out(reader, at);
    reader_step(reader);
    return holds || choose(reader, condition);
}

bool condition_if(struct reader *reader, const struct item *item)
{
    double value = 0;
    bool good = condition_read(reader, &value);
    return begin(reader, &item->at, good, condition_holds(value));
}

bool condition_ifdef(struct reader *reader, const struct item *item)
{
    bool wanted = item->keyword->detail == CONDITION_WHEN_DEFINED;
    double defined = 0;
    bool good = read_brackets(reader, true, &defined);
    return begin(reader, &item->at, good, (defined != 0) == wanted);
}

/* Ends the branch that has been read, at #else or #elseif, and skips the rest up to
 * #end. */
bool condition_else(struct reader *reader, const struct item *item)
{
    struct scene_condition *condition = condition_top(reader);
    if (condition && condition->kind == CONDITION_SWITCH && !condition->in_else
        && token_is_text(&item->at, "else"))
        return switch_else(reader, condition);
    if (!condition || condition->kind != CONDITION_IF || condition->in_else)
        return reader_fault(reader, &item->at, "'#%.*s' without a matching '#if'",
                            ITEM_WORD(item));
    return condition_leave(reader, condition);
}

bool condition_end(struct reader *reader, const struct item *item)
{
    struct scene_condition *condition = condition_top(reader);
    if (!condition)
        return reader_fault(reader, &item->at, "'#end' without a matching directive");
    if (condition->kind == CONDITION_WHILE || condition->kind == CONDITION_FOR)
        return loop_end(reader, condition);
    reader->condition_count--;
    return true;
}

/* ---- #break -------------------------------------------------------------- */

/* Returns the innermost loop or #switch of the current frame, or NULL. */
static struct scene_condition *breakable(struct reader *reader)
{
    size_t serial = lexer_top(&reader->lexer)->serial;
    size_t count = reader->condition_count;
    while (count > reader->sealed && reader->conditions[count - 1].frame == serial) {
        struct scene_condition *condition = &reader->conditions[--count];
        if (condition->kind != CONDITION_IF)
            return condition;
    }
    return NULL;
}

/* Ends the macro of a #break that is not in a loop or #switch, as POV-Ray does. */
static bool end_macro(struct reader *reader, const struct scene_token *at)
{
    const struct open_text *top = lexer_top(&reader->lexer);
    struct text_place end = top->place;
    if (!top->is_macro)
        return reader_fault(reader, at,
                            "'#break' outside of a loop, '#switch' or macro");
    while (condition_top(reader))
        reader->condition_count--;
    end.at = top->end;
    reader_jump(reader, &end);
    return true;
}

bool condition_break(struct reader *reader, const struct item *item)
{
    struct scene_condition *condition = breakable(reader);
    size_t inner;
    if (!condition)
        return end_macro(reader, &item->at);
    inner = (size_t)(&reader->conditions[reader->condition_count] - condition);
    reader->condition_count -= inner;
    if (!condition_skip(reader, &condition->at, "end", inner))
        return false;
    reader_step(reader);
    return true;
}
