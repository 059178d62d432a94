/* expression.c - parses expressions and folds integer constants. */
#include "asm/text/expression_tree.h"

#include <string.h>

static int precedence(const struct cursor *cursor)
{
    const struct token *token = &cursor->token;
    return token->kind == TOKEN_OPERATOR ? operator_precedence(token->code) : 0;
}

static struct expression *new_node(struct cursor *cursor, const char *at,
                                   enum operation operation)
{
    struct expression *node = arena_take(cursor->assembler->arena, sizeof *node);
    if (node) {
        node->operation = operation;
        node->at = at;
    }
    return node;
}

/* Computes a node whose operands are integer constants. If it fails, the node remains,
 * and evaluate() reports the error. */
static void fold(struct expression *node)
{
    const struct expression *left = node->left, *right = node->right;
    uint64_t bits;
    if (left->operation != VALUE || left->value.kind == VALUE_FLOATING)
        return;
    if (node->operation == UNARY)
        bits = integer_negation(node->code, left->value.bits);
    else if (right->operation != VALUE || right->value.kind == VALUE_FLOATING
             || integer_operation(node->code, (int64_t)left->value.bits,
                                  (int64_t)right->value.bits, &bits))
        return;
    node->operation = VALUE;
    node->value.kind = VALUE_INTEGER;
    node->value.bits = bits;
    node->depth = 0;
}

static struct expression *join_nodes(struct cursor *cursor, struct expression *node,
                                     int code, const struct expression *left,
                                     const struct expression *right)
{
    if (!node)
        return NULL;
    node->code = code;
    node->left = left;
    node->right = right;
    node->depth = 1 + left->depth;
    if (right && right->depth >= node->depth)
        node->depth = 1 + right->depth;
    fold(node);
    if (node->depth > MAX_EXPRESSION_DEPTH) {
        report_at(cursor, node->at, "the expression has more than %u nested levels",
                  MAX_EXPRESSION_DEPTH);
        return NULL;
    }
    return node;
}

static const struct expression *parse_binary(struct cursor *cursor, int level);

static const struct expression *parse_symbol(struct cursor *cursor)
{
    struct expression *node = new_node(cursor, cursor->token.begin, SYMBOL);
    struct symbol *symbol;
    const char *name;
    size_t length;
    if (!node || !expect_name(cursor, "a name", &name, &length))
        return NULL;
    node->symbol = symbol = symbol_intern(cursor->assembler, name, length);
    if (!symbol)
        return NULL;
    symbol->used = true;
    return node;
}

static const struct expression *parse_brackets(struct cursor *cursor)
{
    const struct expression *inside;
    if (!expect_operator(cursor, '(', "'('"))
        return NULL;
    inside = parse_binary(cursor, 1);
    if (!inside || !expect_operator(cursor, ')', "')'"))
        return NULL;
    return inside;
}

/* Parses bits(value) or word(integer). bits() is the integer with the bits of a word.
 * word() is the word with the bits of an integer. */
static const struct expression *parse_function(struct cursor *cursor,
                                               enum operation operation)
{
    struct expression *node = new_node(cursor, cursor->token.begin, operation);
    cursor_next(cursor);
    if (!node || !(node->left = parse_brackets(cursor)))
        return NULL;
    node->depth = 1 + node->left->depth;
    return node;
}

/* Parses sin(x), atan2(y, x) and similar calls. */
static const struct expression *
parse_computed(struct cursor *cursor, const struct constant_folder_function *function)
{
    struct expression *node = new_node(cursor, cursor->token.begin, FUNCTION);
    cursor_next(cursor);
    if (!node || !expect_operator(cursor, '(', "'('")
        || !(node->left = parse_binary(cursor, 1)))
        return NULL;
    node->function = function;
    node->depth = 1 + node->left->depth;
    if (function->arguments == 2) {
        if (!expect_operator(cursor, ',', "','")
            || !(node->right = parse_binary(cursor, 1)))
            return NULL;
        if (node->right->depth >= node->depth)
            node->depth = 1 + node->right->depth;
    }
    return expect_operator(cursor, ')', "')'") ? node : NULL;
}

/* Parses length("text"), which is the number of bytes. */
static const struct expression *parse_length(struct cursor *cursor)
{
    struct expression *node = new_node(cursor, cursor->token.begin, VALUE);
    size_t length;
    cursor_next(cursor);
    if (!node || !expect_operator(cursor, '(', "'('") || !expect_string(cursor, &length)
        || !expect_operator(cursor, ')', "')'"))
        return NULL;
    node->value.bits = length;
    return node;
}

static const struct expression *parse_number(struct cursor *cursor)
{
    struct expression *node = new_node(cursor, cursor->token.begin, VALUE);
    if (!node)
        return NULL;
    node->value = cursor->token.value;
    cursor_next(cursor);
    return node;
}

static const struct expression *parse_here(struct cursor *cursor)
{
    struct expression *node = new_node(cursor, cursor->token.begin, VALUE);
    if (!node)
        return NULL;
    node->value.bits = cursor->assembler->section->at;
    cursor_next(cursor);
    return node;
}

/* Returns true if the token is a name before an opening parenthesis. */
static bool is_call(const struct token *token)
{
    const char *at = token->end;
    while (*at == ' ' || *at == '\t')
        at++;
    return token->kind == TOKEN_NAME && *at == '(';
}

static bool is_function(const struct token *token, const char *name)
{
    return is_call(token) && token_is(token, name);
}

static const struct constant_folder_function *computed(const struct token *token)
{
    return is_call(token)
               ? constant_folder_find(token->begin, (size_t)(token->end - token->begin))
               : NULL;
}

static const struct expression *parse_primary(struct cursor *cursor)
{
    const struct token *token = &cursor->token;
    if (token->kind == TOKEN_NUMBER)
        return parse_number(cursor);
    if (is_function(token, "bits"))
        return parse_function(cursor, BITS);
    if (is_function(token, "word"))
        return parse_function(cursor, WORD);
    if (is_function(token, "length"))
        return parse_length(cursor);
    if (computed(token))
        return parse_computed(cursor, computed(token));
    if (token->kind == TOKEN_NAME)
        return parse_symbol(cursor);
    if (cursor_at(cursor, '.'))
        return parse_here(cursor);
    if (cursor_at(cursor, '('))
        return parse_brackets(cursor);
    expected(cursor, "a number, a name or '('");
    return NULL;
}

/* Parses a negative number. It is converted with its sign, so it is rounded once.
 * Negating the rounded positive number could give another word. */
static const struct expression *parse_negative_number(struct cursor *cursor,
                                                      const char *at)
{
    struct expression *node = new_node(cursor, at, VALUE);
    char text[80] = "-";
    size_t length = (size_t)(cursor->token.end - cursor->token.begin);
    const char *end;
    if (!node)
        return NULL;
    if (length > sizeof text - 2) {
        report_at(cursor, at, "a negative number has at most %zu characters",
                  sizeof text - 2);
        return NULL;
    }
    memcpy(text + 1, cursor->token.begin, length);
    node->value.kind = VALUE_FLOATING;
    node->value.bits = c205_from_text(text, &end);
    cursor_next(cursor);
    return node;
}

static const struct expression *parse_unary(struct cursor *cursor)
{
    const char *at = cursor->token.begin;
    const struct expression *left;
    struct expression *node;
    int code = cursor->token.code;
    if (!cursor_at(cursor, '-') && !cursor_at(cursor, '~') && !cursor_at(cursor, '!'))
        return parse_primary(cursor);
    cursor_next(cursor);
    if (code == '-' && cursor->token.kind == TOKEN_NUMBER
        && cursor->token.value.kind == VALUE_FLOATING)
        return parse_negative_number(cursor, at);
    node = new_node(cursor, at, UNARY);
    left = parse_binary(cursor, 11);
    return left ? join_nodes(cursor, node, code, left, NULL) : NULL;
}

/* Parses an operand and all binary operators of at least this level, by precedence
 * climbing. A right operand takes only operators of higher levels, so operators of the
 * same level associate to the left. */
static const struct expression *parse_chain(struct cursor *cursor, int level)
{
    const struct expression *left = parse_unary(cursor), *right;
    int found;
    while (left && (found = precedence(cursor)) >= level && found) {
        int code = cursor->token.code;
        struct expression *node = new_node(cursor, cursor->token.begin, BINARY);
        cursor_next(cursor);
        right = parse_binary(cursor, found + 1);
        left = right ? join_nodes(cursor, node, code, left, right) : NULL;
    }
    return left;
}

/* Parses operators of at least this level. Every level of nesting passes through this
 * function, so it checks the limit of the depth. */
static const struct expression *parse_binary(struct cursor *cursor, int level)
{
    const struct expression *result;
    if (cursor->depth >= MAX_EXPRESSION_DEPTH) {
        report_at(cursor, cursor->token.begin,
                  "the expression has more than %u nested levels",
                  MAX_EXPRESSION_DEPTH);
        return NULL;
    }
    cursor->depth++;
    result = parse_chain(cursor, level);
    cursor->depth--;
    return result;
}

const struct expression *parse_expression(struct cursor *cursor)
{
    return parse_binary(cursor, 1);
}

bool parse_value(struct cursor *cursor, struct value *value)
{
    const struct expression *expression = parse_expression(cursor);
    return expression && evaluate(cursor->assembler, cursor->line, expression, value);
}

bool parse_integer(struct cursor *cursor, int64_t low, int64_t high, const char *what,
                   int64_t *integer)
{
    const struct expression *expression = parse_expression(cursor);
    return expression
           && evaluate_range(cursor->assembler, cursor->line, expression, low, high,
                             what, integer);
}
