/* formula.c - compiles functions to postfix code, and evaluates them.
 *
 *   full        both { "|" both }
 *   both        relation { "&" relation }
 *   relation    sum { ("=" "!=" "<" "<=" ">" ">=") sum }
 *   sum         product { ("+" | "-") product }
 *   product     factor { ("*" | "/") factor }
 *   factor      { "+" | "-" } primary
 *   primary     parameter | constant | "(" full ")"
 *               | a function of floats "(" full, ... ")"
 *               | formula "(" full, ... ")" [ "." component ]
 *
 * As in POV-Ray, comparisons are exact here and & binds tighter than |. In expressions
 * comparisons have a tolerance, and & and | have the same precedence.
 */
#include "rt/scene/language/formula.h"

#include "rt/scene/language/scene_block.h"
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_statement.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum formula_step_kind {
    FORMULA_NUMBER,    /* push the constant */
    FORMULA_PARAMETER, /* push the argument */
    FORMULA_OPERATOR,  /* apply the binary operator `sign` */
    FORMULA_MINUS,
    FORMULA_FUNCTION, /* apply the function to `count` floats */
    FORMULA_CALL      /* apply the formula to `count` floats; push the component `term`
                       * of the result */
};

struct formula_step {
    enum formula_step_kind kind;
    int sign;
    size_t count, term;
    union {
        double number;
        size_t parameter;
        const struct function *function;
        const struct formula *formula;
    } is;
};

struct formula {
    const char *without; /* unsupported word, so that the formula cannot be called;
                          * NULL: none */
    size_t parameter_count;
    bool moves; /* the result is the point transformed by `placement` */
    struct placement placement;
    size_t nesting;           /* depth of nested calls, including this one */
    size_t step_count, depth; /* depth: largest number of floats on the stack */
    const struct formula_step *steps;
};

/* ---- Reading ------------------------------------------------------------- */

struct name {
    const char *text;
    size_t length;
};

struct compiler {
    struct reader *reader;
    struct name parameters[MAX_PARAMETERS];
    struct formula *formula;
    struct formula_step *steps;
    size_t count, capacity;
    size_t depth; /* number of floats on the stack after the last step */
};

/* Appends a step to the code. The step replaces the top `takes` floats of the stack by
 * one float. */
static bool add_step(struct compiler *compiler, const struct formula_step *step,
                     size_t takes)
{
    if (!arena_add(&compiler->reader->arena, &compiler->steps, &compiler->count,
                   &compiler->capacity, step, sizeof *step))
        return reader_no_memory(compiler->reader);
    compiler->depth = compiler->depth - takes + 1;
    if (compiler->formula->depth < compiler->depth)
        compiler->formula->depth = compiler->depth;
    return true;
}

static bool read_whole(struct compiler *compiler);

/* Reads "(" full, ... ")". */
static bool read_arguments(struct compiler *compiler, size_t least, size_t most,
                           size_t *count)
{
    struct reader *reader = compiler->reader;
    *count = 0;
    if (!reader_expect_sign(reader, '('))
        return false;
    while (*count < least || (*count < most && !reader_at_sign(reader, ')'))) {
        if (*count && !reader_expect_sign(reader, ','))
            return false;
        if (!read_whole(compiler))
            return false;
        ++*count;
    }
    return reader_expect_sign(reader, ')');
}

static bool read_function(struct compiler *compiler, const struct function *function)
{
    struct reader *reader = compiler->reader;
    size_t least = strspn(function->takes, "f"), most = least;
    struct formula_step step = { .kind = FORMULA_FUNCTION, .is.function = function };
    if (strchr(function->takes, 'v'))
        return reader_expected(reader, "a function of floats");
    if (function->takes[least] == '?')
        most = least + 1;
    if (function->takes[least] == '+')
        most = MAX_ARGUMENTS;
    reader_next(reader);
    return read_arguments(compiler, least, most, &step.count)
           && add_step(compiler, &step, step.count);
}

/* Reads ".x", ".y" or ".z" after the call of a transform function, and sets *term to
 * the index of the component. */
static bool read_term(struct reader *reader, size_t *term)
{
    static const char names[] = "xyz";
    const char *found = NULL;
    if (!reader_expect_sign(reader, '.'))
        return false;
    if (reader->token.kind == TOKEN_WORD && reader->token.length == 1)
        found = strchr(names, reader->token.text[0]);
    if (!found)
        return reader_expected(reader, "x, y or z");
    *term = (size_t)(found - names);
    reader_next(reader);
    return true;
}

/* Reads a call of a function that cannot be evaluated. Any number of arguments and any
 * component are accepted, because the result is not used. */
static bool read_other_call(struct compiler *compiler, const struct formula *called)
{
    struct reader *reader = compiler->reader;
    struct formula_step step = { .kind = FORMULA_CALL, .is.formula = called };
    compiler->formula->without = called->without;
    reader_next(reader);
    if (!read_arguments(compiler, 0, MAX_PARAMETERS, &step.count))
        return false;
    if (reader_accept_sign(reader, '.')) {
        if (reader->token.kind != TOKEN_WORD)
            return reader_expected(reader, "a component");
        reader_next(reader);
    }
    return add_step(compiler, &step, step.count);
}

static bool read_formula_call(struct compiler *compiler, const struct formula *called)
{
    struct reader *reader = compiler->reader;
    struct formula_step step = { .kind = FORMULA_CALL, .is.formula = called };
    size_t count = called->parameter_count;
    if (called->without)
        return read_other_call(compiler, called);
    if (called->nesting == MAX_NESTING)
        return reader_fault(reader, &reader->token,
                            "more than %d nested function calls", MAX_NESTING);
    if (compiler->formula->nesting <= called->nesting)
        compiler->formula->nesting = called->nesting + 1;
    reader_next(reader);
    return read_arguments(compiler, count, count, &step.count)
           && (!called->moves || read_term(reader, &step.term))
           && add_step(compiler, &step, step.count);
}

static bool read_constant(struct compiler *compiler)
{
    struct reader *reader = compiler->reader;
    struct scene_token at = reader->token;
    struct formula_step step = { .kind = FORMULA_NUMBER };
    struct numbers value;
    if (!operand_read(reader, &value) || !operand_float(reader, &at, &value))
        return false;
    step.is.number = value.n[0];
    return add_step(compiler, &step, 0);
}

static bool is_parameter(const struct compiler *compiler,
                         const struct scene_token *token, size_t *number)
{
    for (size_t i = 0; i < compiler->formula->parameter_count; i++) {
        const struct name *name = &compiler->parameters[i];
        *number = i;
        if (token->kind == TOKEN_WORD && token->length == name->length
            && !memcmp(token->text, name->text, name->length))
            return true;
    }
    return false;
}

static bool read_primary(struct compiler *compiler)
{
    struct reader *reader = compiler->reader;
    struct formula_step step = { .kind = FORMULA_PARAMETER };
    const struct scene_value *declared;
    if (reader_accept_sign(reader, '('))
        return read_whole(compiler) && reader_expect_sign(reader, ')');
    if (is_parameter(compiler, &reader->token, &step.is.parameter)) {
        reader_next(reader);
        return add_step(compiler, &step, 0);
    }
    declared = reader_use(reader, VALUE_FUNCTION);
    if (declared)
        return read_formula_call(compiler, declared->is.formula);
    if (function_find(&reader->token))
        return read_function(compiler, function_find(&reader->token));
    return read_constant(compiler);
}

static bool read_factor(struct compiler *compiler)
{
    const struct formula_step step = { .kind = FORMULA_MINUS };
    struct reader *reader = compiler->reader;
    bool minus = reader_at_sign(reader, '-');
    bool done;
    if (!minus && !reader_at_sign(reader, '+'))
        return read_primary(compiler);
    if (!reader_enter(reader))
        return false;
    reader_next(reader);
    done = read_factor(compiler) && (!minus || add_step(compiler, &step, 1));
    reader_leave(reader);
    return done;
}

/* Accepts one of the signs and returns it. Returns 0 if the token is another one. */
static int accept_one_of(struct reader *reader, const int *signs)
{
    for (; *signs; signs++)
        if (reader_accept_sign(reader, *signs))
            return *signs;
    return 0;
}

/* Reads left-associative operators; rank 0 has the lowest precedence. */
static bool read_rank(struct compiler *compiler, size_t rank)
{
    static const int signs[][7] = {
        { '|' },
        { '&' },
        { '=', SIGN_UNEQUAL, '<', SIGN_NOT_ABOVE, '>', SIGN_NOT_BELOW },
        { '+', '-' },
        { '*', '/' },
    };
    enum { RANKS = sizeof signs / sizeof *signs };
    struct formula_step step = { .kind = FORMULA_OPERATOR };
    if (rank == RANKS)
        return read_factor(compiler);
    if (!read_rank(compiler, rank + 1))
        return false;
    while ((step.sign = accept_one_of(compiler->reader, signs[rank])) != 0)
        if (!read_rank(compiler, rank + 1) || !add_step(compiler, &step, 2))
            return false;
    return true;
}

static bool read_whole(struct compiler *compiler)
{
    struct reader *reader = compiler->reader;
    bool done;
    if (!reader_enter(reader))
        return false;
    done = read_rank(compiler, 0);
    reader_leave(reader);
    return done;
}

static bool read_parameter(struct compiler *compiler)
{
    struct reader *reader = compiler->reader;
    const struct scene_token *token = &reader->token;
    size_t number = compiler->formula->parameter_count;
    if (token->kind != TOKEN_WORD)
        return reader_expected(reader, "the name of a parameter or ')'");
    if (number == MAX_PARAMETERS)
        return reader_fault(reader, token, "more than %d parameters", MAX_PARAMETERS);
    compiler->parameters[number] = (struct name){ token->text, token->length };
    compiler->formula->parameter_count++;
    reader_next(reader);
    reader_comma(reader);
    return true;
}

static bool read_parameters(struct compiler *compiler)
{
    static const char *const usual[] = { "x", "y", "z" };
    struct reader *reader = compiler->reader;
    if (!reader_accept_sign(reader, '(')) {
        for (size_t i = 0; i < 3; i++)
            compiler->parameters[i] = (struct name){ usual[i], 1 };
        compiler->formula->parameter_count = 3;
        return true;
    }
    while (!reader_at_sign(reader, ')'))
        if (!read_parameter(compiler))
            return false;
    return reader_expect_sign(reader, ')');
}

/* Returns the keyword of an unsupported kind of function, or NULL. */
static const char *find_other(const struct reader *reader)
{
    static const char *const words[] = { "internal", "pattern", "pigment", "spline" };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (is_token(&reader->token, words[i]))
            return words[i];
    return NULL;
}

static bool read_body(struct compiler *compiler, const struct block *block)
{
    struct reader *reader = compiler->reader;
    struct formula *formula = compiler->formula;
    bool good;
    formula->without = find_other(reader);
    if (formula->without)
        return block_finish(reader, block);
    if (reader_accept(reader, "transform")) {
        formula->moves = true;
        formula->placement = placement_none;
        good = transform_read(reader, &formula->placement);
        if (good && formula->parameter_count != 3)
            good = reader_fault(reader, &block->open,
                                "a transform takes 3 parameters, found %zu",
                                formula->parameter_count);
    } else {
        good = read_whole(compiler);
    }
    formula->steps = compiler->steps;
    formula->step_count = compiler->count;
    return block_items(reader, block, &no_words, NULL, good);
}

const struct formula *formula_read(struct reader *reader)
{
    struct compiler compiler = { .reader = reader };
    struct block block;
    compiler.formula = arena_take(&reader->arena, sizeof *compiler.formula);
    if (!compiler.formula) {
        reader_no_memory(reader);
        return NULL;
    }
    compiler.formula->nesting = 1;
    if (!read_parameters(&compiler) || !block_open(reader, &block, '{')
        || !read_body(&compiler, &block)
        || !reader_spend(reader, MEMORY_COST
                                     * (sizeof *compiler.formula
                                        + compiler.capacity * sizeof *compiler.steps)))
        return NULL;
    return compiler.formula;
}

/* ---- Values -------------------------------------------------------------- */

/* A call of a function. Errors in the function, and in the functions that it calls, are
 * reported at this place. */
struct formula_caller {
    struct reader *reader;
    const struct scene_token *at;
};

static bool evaluate(const struct formula_caller *call, const struct formula *formula,
                     const double *arguments, double *value);

static double operate(int sign, double a, double b)
{
    switch (sign) {
    case '+': return a + b;
    case '-': return a - b;
    case '*': return a * b;
    case '/': return a / b;
    case '=': return a == b;
    case SIGN_UNEQUAL: return a != b;
    case '<': return a < b;
    case '>': return a > b;
    case SIGN_NOT_ABOVE: return a <= b;
    case SIGN_NOT_BELOW: return a >= b;
    case '&': return a != 0 && b != 0;
    default: return a != 0 || b != 0;
    }
}

/* Applies a function to `count` floats. The result replaces the first of them. */
static void apply(const struct function *function, size_t count, double *arguments)
{
    struct numbers taken[MAX_ARGUMENTS], result;
    for (size_t i = 0; i < count; i++)
        taken[i] = numbers_of(arguments[i]);
    function_apply(function, taken, count, &result);
    arguments[0] = result.n[0];
}

static bool take_step(const struct formula_caller *call,
                      const struct formula_step *step, const double *arguments,
                      double **top)
{
    double value[3];
    switch (step->kind) {
    case FORMULA_NUMBER: *(*top)++ = step->is.number; break;
    case FORMULA_PARAMETER: *(*top)++ = arguments[step->is.parameter]; break;
    case FORMULA_OPERATOR:
        --*top;
        (*top)[-1] = operate(step->sign, (*top)[-1], (*top)[0]);
        break;
    case FORMULA_MINUS: (*top)[-1] = -(*top)[-1]; break;
    case FORMULA_FUNCTION:
        *top -= step->count - 1;
        apply(step->is.function, step->count, *top - 1);
        break;
    case FORMULA_CALL:
        *top -= step->count;
        if (!evaluate(call, step->is.formula, *top, value))
            return false;
        *(*top)++ = value[step->term];
        break;
    }
    return isfinite((*top)[-1])
           || reader_fault(call->reader, call->at, "the value is not a finite number");
}

static bool take_steps(const struct formula_caller *call, const struct formula *formula,
                       const double *arguments, double *stack, double *value)
{
    double *top = stack;
    for (size_t i = 0; i < formula->step_count; i++)
        if (!take_step(call, &formula->steps[i], arguments, &top))
            return false;
    value[0] = stack[0];
    return true;
}

/* Evaluates a function. Its steps count as reading, because nested functions may take
 * exponential time. */
static bool evaluate(const struct formula_caller *call, const struct formula *formula,
                     const double *arguments, double *value)
{
    struct reader *reader = call->reader;
    double *stack;
    bool done;
    if (formula->moves) {
        memcpy(value, arguments, 3 * sizeof *value);
        transform_point(&formula->placement.to_world, value);
        return true;
    }
    if (!reader_spend(reader, (formula->step_count + 1) * TOKEN_COST))
        return false;
    stack = malloc(formula->depth * sizeof *stack);
    if (!stack)
        return reader_no_memory(reader);
    done = take_steps(call, formula, arguments, stack, value);
    free(stack);
    return done;
}

/* Reads the arguments of a function of floats, in parentheses. */
static bool take_arguments(struct reader *reader, size_t count, double *arguments)
{
    reader_next(reader);
    if (!reader_expect_sign(reader, '('))
        return false;
    for (size_t i = 0; i < count; i++)
        if ((i && !reader_expect_sign(reader, ','))
            || !read_full_number(reader, &arguments[i]))
            return false;
    return reader_expect_sign(reader, ')');
}

static bool can_call(struct reader *reader, const struct formula *formula,
                     const struct scene_token *at)
{
    return !formula->without
           || reader_fault(reader, at,
                           "the value of a function with '%s' is not supported",
                           formula->without);
}

bool formula_call(struct reader *reader, const struct formula *formula,
                  struct numbers *value)
{
    struct scene_token at = reader->token;
    const struct formula_caller call = { reader, &at };
    double arguments[MAX_PARAMETERS];
    if (!can_call(reader, formula, &at))
        return false;
    *value = numbers_of(0);
    value->count = formula->moves ? 3 : 1;
    return take_arguments(reader, formula->parameter_count, arguments)
           && evaluate(&call, formula, arguments, value->n)
           && operand_finite(reader, &at, value);
}

bool formula_value(struct reader *reader, const struct formula *formula,
                   const struct scene_token *at, const double arguments[3],
                   double *value)
{
    const struct formula_caller call = { reader, at };
    struct numbers result = numbers_of(0);
    if (!can_call(reader, formula, at))
        return false;
    if (formula->moves || formula->parameter_count > 3)
        return reader_fault(reader, at,
                            "expected a function that returns a float for x, y and z");
    if (!evaluate(&call, formula, arguments, result.n)
        || !operand_finite(reader, at, &result))
        return false;
    *value = result.n[0];
    return true;
}
