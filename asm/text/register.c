/* register.c - names of registers, and the warning if two names use the same register.
 *
 * A register has an owner, which is its first name. Another declaration of the same
 * name, or a name defined by that name, has the same owner. A name with another owner
 * causes a warning, with these exceptions:
 *
 *   - The first name belongs to another register now.
 *   - One of the two names was declared between .share and .endshare. Names in such a
 *     block may share with names outside of it, but not with each other. If the block
 *     has a word, they may share only with names in blocks that have the same word.
 */
#include "asm/text/statement.h"

static unsigned whole_number(struct register_name named)
{
    return named.half ? named.number / 2u : named.number;
}

static bool overlap(struct register_name a, struct register_name b)
{
    return a.half && b.half ? a.number == b.number : whole_number(a) == whole_number(b);
}

/* Returns a naming by its index, which counts from 1. Returns NULL for index 0. */
static struct naming *naming_at(const struct registers *registers, size_t index)
{
    return index > 0 ? &registers->namings[index - 1] : NULL;
}

static bool encloses(const struct register_share *outer,
                     const struct register_share *share)
{
    while (share && share != outer)
        share = share->outer;
    return share == outer;
}

/* Returns true if a block around the first name, but not around the other, has this
 * word. Words are unique symbols, so pointers are compared. */
static bool has_word(const struct register_share *share,
                     const struct register_share *other, const char *word)
{
    for (; share; share = share->outer)
        if (share->word == word && !encloses(share, other))
            return true;
    return false;
}

/* Returns true if one of the .share blocks around a name allows it to share its
 * register with the other name. Names in the same block cannot share. */
static bool allows_sharing(const struct register_share *share,
                           const struct register_share *other)
{
    const struct register_share *block;
    for (block = share; block; block = block->outer)
        if (!encloses(block, other)
            && (!block->word || has_word(other, share, block->word)))
            return true;
    return false;
}

static bool may_share(const struct naming *naming, const struct naming *other)
{
    return naming->owner == other->owner || !overlap(naming->named, other->named)
           || allows_sharing(naming->share, other->share)
           || allows_sharing(other->share, naming->share);
}

/* Returns a name with another owner that uses the same register without permission, or
 * NULL. Names that no longer belong to the register are removed from the list. */
static const struct naming *other_owner(struct registers *registers,
                                        const struct naming *naming)
{
    size_t *link = &registers->newest[whole_number(naming->named)], seen = 0;
    while (*link > 0 && seen < MAX_SHARERS) {
        struct naming *other = naming_at(registers, *link);
        if (other->ended) {
            *link = other->below;
            continue;
        }
        if (!may_share(naming, other))
            return other;
        link = &other->below;
        seen++;
    }
    return NULL;
}

static void check_owner(struct cursor *cursor, const struct naming *naming)
{
    const struct naming *other;
    if (naming->named.naming > 0 || whole_number(naming->named) == 0)
        return;
    other = other_owner(&cursor->assembler->registers, naming);
    if (other)
        warn(cursor->assembler, WARNING_SHARED_REGISTER, cursor->line, naming->at,
             "%c%u is already '%s', in %s:%zu; declare names that share a register "
             "with .share",
             naming->named.half ? 'h' : 'r', naming->named.number, other->symbol->name,
             other->line->file, other->line->number);
}

static bool same_register(struct register_name a, struct register_name b)
{
    return a.half == b.half && a.number == b.number;
}

/* Ends the previous naming of the symbol. Returns the owner of the new naming. */
static size_t owner_of(struct registers *registers, const struct symbol *symbol,
                       struct register_name named)
{
    struct naming *before = naming_at(registers, symbol->naming);
    const struct naming *other = naming_at(registers, named.naming);
    if (before)
        before->ended = true;
    if (other)
        return other->owner;
    return before && same_register(before->named, named) ? before->owner
                                                         : registers->count;
}

static bool add_naming(struct cursor *cursor, const char *at, struct symbol *symbol,
                       struct register_name named)
{
    struct registers *registers = &cursor->assembler->registers;
    size_t *newest = &registers->newest[whole_number(named)];
    struct naming naming = { .line = cursor->line,
                             .at = at,
                             .symbol = symbol,
                             .named = named,
                             .share = registers->share,
                             .below = *newest };
    naming.owner = owner_of(registers, symbol, named);
    if (named.naming > 0)
        naming.share = naming_at(registers, named.naming)->share;
    check_owner(cursor, &naming);
    naming.below = *newest;
    if (!arena_add(cursor->assembler->arena, &registers->namings, &registers->count,
                   &registers->capacity, &naming, sizeof naming))
        return false;
    *newest = symbol->naming = registers->count;
    return true;
}

static bool name_register(struct cursor *cursor, const char *name, size_t length,
                          struct register_name named)
{
    struct value value = { VALUE_INTEGER, named.number };
    struct symbol *symbol = symbol_intern(cursor->assembler, name, length);
    return symbol_define(cursor->assembler, cursor->line, name, symbol,
                         named.half ? SYMBOL_HALF_REGISTER : SYMBOL_REGISTER, value)
           && add_naming(cursor, name, symbol, named);
}

bool parse_reg(struct cursor *cursor)
{
    const char *name;
    size_t length;
    struct register_name named;
    return expect_name(cursor, "a name", &name, &length)
           && expect_operator(cursor, ',', "','") && parse_any_register(cursor, &named)
           && name_register(cursor, name, length, named);
}

/* Returns the index of the next naming if it declares the next register, and 0
 * otherwise. */
static size_t naming_behind(const struct registers *registers, size_t index)
{
    const struct naming *naming = naming_at(registers, index);
    const struct naming *next = naming && index < registers->count
                                    ? naming_at(registers, index + 1)
                                    : NULL;
    return next && next->named.half == naming->named.half
                   && next->named.number == naming->named.number + 1
               ? index + 1
               : 0;
}

/* Parses .regs, which names consecutive registers. If the first register is given by
 * name, the new names have the owners of that name and of the names declared directly
 * after it. */
bool parse_regs(struct cursor *cursor)
{
    const char *name;
    size_t length;
    struct register_name named;
    unsigned number;
    if (!parse_any_register(cursor, &named))
        return false;
    for (number = named.number; cursor_take(cursor, ','); number++) {
        if (!expect_name(cursor, "a name", &name, &length))
            return false;
        if (number >= C205_REGISTERS)
            return report_at(cursor, name, "there is no register after %c255",
                             named.half ? 'h' : 'r');
        named.number = (uint8_t)number;
        if (!name_register(cursor, name, length, named))
            return false;
        named.naming = naming_behind(&cursor->assembler->registers, named.naming);
    }
    return true;
}

/* Parses .share with an optional word. */
bool parse_share(struct cursor *cursor)
{
    struct registers *registers = &cursor->assembler->registers;
    struct register_share *share = arena_take(cursor->assembler->arena, sizeof *share);
    const struct symbol *symbol;
    const char *name;
    size_t length;
    if (!share)
        return false;
    share->line = cursor->line;
    share->outer = registers->share;
    share->depth = share->outer ? share->outer->depth + 1 : 1;
    if (share->depth > MAX_SHARES)
        return report_at(cursor, cursor->line->begin, "more than %u nested .share",
                         MAX_SHARES);
    registers->share = share;
    if (cursor_at_end(cursor))
        return true;
    if (!expect_name(cursor, "a word", &name, &length))
        return false;
    symbol = symbol_intern(cursor->assembler, name, length);
    share->word = symbol ? symbol->name : NULL;
    return symbol != NULL;
}

bool parse_endshare(struct cursor *cursor)
{
    struct registers *registers = &cursor->assembler->registers;
    if (!registers->share)
        return report_at(cursor, cursor->line->begin, ".endshare without .share");
    registers->share = registers->share->outer;
    return true;
}

bool mention_register(struct assembler *assembler, struct register_name named)
{
    struct registers *registers = &assembler->registers;
    size_t mention = named.naming - 1;
    return named.naming == 0
           || arena_add(assembler->arena, &registers->mentions,
                        &registers->mention_count, &registers->mention_capacity,
                        &mention, sizeof mention);
}
