/* declare.c - executes #declare, #local and #undef, and parses the values of names. */
#include "rt/scene/language/declare.h"

#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/array_element.h"
#include "rt/scene/language/formula.h"
#include "rt/scene/language/semicolon.h"
#include "rt/scene/language/scene_statement.h"
#include "rt/scene/language/string_value.h"

#include <string.h>

/* ---- Values -------------------------------------------------------------- */

/* Reads all textures that follow, because the layers of a texture are separate
 * textures. */
static bool read_layers(struct reader *reader, struct texture *texture)
{
    bool done = true;
    while (done && is_token(&reader->token, "texture")) {
        struct scene_token at = reader->token;
        reader_next(reader);
        done = texture_layer_read(reader, &at, texture);
    }
    return done;
}

/* Sets a declared value to the default that its block modifies. */
static void begin_value(const struct reader *reader, struct scene_value *value)
{
    const struct texture *usual = &reader->default_texture;
    switch (value->kind) {
    case VALUE_PIGMENT:
    case VALUE_COLOR_MAP:
    case VALUE_PIGMENT_MAP: value->is.pigment = usual->pigment; break;
    case VALUE_FINISH: value->is.finish = usual->finish; break;
    case VALUE_TEXTURE:
    case VALUE_TEXTURE_MAP: value->is.texture = *usual; break;
    case VALUE_NORMAL: value->is.bumps = usual->bumps; break;
    /* The map may be used for an average, so its numbers are optional. */
    case VALUE_NORMAL_MAP: value->is.bump_list.average = true; break;
    case VALUE_INTERIOR: value->is.interior = 1; break;
    case VALUE_CAMERA: value->is.camera = camera_default; break;
    default: break;
    }
}

bool item_statement(struct reader *reader, const struct item *item)
{
    void *subject = item->subject;
    switch ((enum scene_value_kind)item->keyword->detail) {
    case VALUE_PIGMENT: return pigment_read(reader, subject);
    case VALUE_COLOR_MAP: return color_map_read(reader, subject);
    case VALUE_PIGMENT_MAP: return pigment_map_read(reader, subject);
    case VALUE_FINISH: return finish_read(reader, subject);
    case VALUE_TEXTURE: return texture_read(reader, subject);
    case VALUE_TEXTURE_MAP: return texture_map_read(reader, subject);
    case VALUE_NORMAL: return normal_read(reader, subject);
    case VALUE_NORMAL_MAP: return normal_map_read(reader, subject);
    case VALUE_SLOPE_MAP: return slope_map_read(reader, subject);
    case VALUE_SKY: return sky_read(reader, subject);
    case VALUE_FOG: return fog_read(reader, subject);
    case VALUE_INTERIOR: return interior_read(reader, subject);
    case VALUE_MATERIAL: return material_read(reader, subject);
    case VALUE_TRANSFORM: return transform_read(reader, subject);
    case VALUE_CAMERA: return camera_read(reader, &item->at, subject);
    default: return false;
    }
}

/* Reads a declared value. The keyword's detail is the kind of the value. */
static bool declare(struct reader *reader, const struct item *item)
{
    struct scene_value *value = item->subject;
    struct item own = *item;
    value->kind = (enum scene_value_kind)item->keyword->detail;
    begin_value(reader, value);
    own.subject = &value->is;
    return item_statement(reader, &own)
           && (value->kind != VALUE_TEXTURE || read_layers(reader, &value->is.texture));
}

static bool declare_function(struct reader *reader, const struct item *item)
{
    struct scene_value *value = item->subject;
    value->kind = VALUE_FUNCTION;
    value->is.formula = formula_read(reader);
    return value->is.formula;
}

/* Skips the block of a declared value whose kind is not supported. Only uses of the
 * name are reported. */
static bool declare_look(struct reader *reader, const struct item *item)
{
    struct scene_value *value = item->subject;
    value->kind = VALUE_LOOK;
    if (!reader_require_sign(reader, '{'))
        return false;
    block_skip(reader);
    return true;
}

static bool declare_object(struct reader *reader, const struct item *item)
{
    struct scene_value *value = item->subject;
    value->kind = VALUE_OBJECT;
    return shape_read(reader, &value->is.object, item);
}

static const struct keyword declared_words[] = {
    { "pigment", declare, VALUE_PIGMENT },
    { "finish", declare, VALUE_FINISH },
    { "texture", declare, VALUE_TEXTURE },
    { "normal", declare, VALUE_NORMAL },
    { "normal_map", declare, VALUE_NORMAL_MAP },
    { "slope_map", declare, VALUE_SLOPE_MAP },
    { "color_map colour_map", declare, VALUE_COLOR_MAP },
    { "pigment_map", declare, VALUE_PIGMENT_MAP },
    { "texture_map", declare, VALUE_TEXTURE_MAP },
    { "sky_sphere", declare, VALUE_SKY },
    { "fog", declare, VALUE_FOG },
    { "interior", declare, VALUE_INTERIOR },
    { "material", declare, VALUE_MATERIAL },
    { "transform", declare, VALUE_TRANSFORM },
    { "camera", declare, VALUE_CAMERA },
    { "function", declare_function, 0 },
    { "density density_map media rainbow", declare_look, 0 },
    { "spline", spline_read, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar declared_grammar = { "a value",
                                                 { declared_words },
                                                 .object = declare_object };

static bool copy_array(struct reader *reader, struct scene_value *value,
                       const struct array *array)
{
    struct scene_token at = reader->token;
    if (!shape_count(reader, array_primitives(array), &at)
        || !reader_spend(reader, array->count * TOKEN_COST)
        || !reader_check(reader, &at, array_copy(&value->is.array, array)))
        return false;
    value->kind = VALUE_ARRAY;
    return true;
}

static bool copy_named(struct reader *reader, struct scene_value *value)
{
    const struct scene_value *from = reader_value(reader);
    bool done = true;
    value_warnings_use(&reader->warnings, from->value_warnings);
    if (from->kind == VALUE_OBJECT) {
        value->kind = VALUE_OBJECT;
        done = shape_copy(reader, &value->is.object, &from->is.object);
    } else if (from->kind == VALUE_ARRAY) {
        done = copy_array(reader, value, from->is.array);
    } else {
        done = reader_check(reader, &reader->token, value_copy(value, from));
    }
    reader_pass(reader);
    return done;
}

static bool read_string(struct reader *reader, struct scene_value *value)
{
    if (!string_read(reader, &value->is.string))
        return false;
    value->kind = VALUE_STRING;
    return true;
}

static bool read_numbers(struct reader *reader, struct scene_value *value)
{
    value->kind = VALUE_NUMBERS;
    return is_color_word(&reader->token) ? read_color(reader, &value->is.numbers)
                                         : read_expression(reader, &value->is.numbers);
}

static bool read_statement(struct reader *reader, struct scene_value *value)
{
    struct item item = item_find(reader, &declared_grammar, value);
    const struct scene_value *named = reader_value(reader);
    if (item.keyword) {
        reader_next(reader);
        return item.keyword->read(reader, &item);
    }
    if (!named || named->kind == VALUE_FAULTY)
        return reader_expected(reader, declared_grammar.expected);
    return copy_named(reader, value);
}

/* Reads a value. Warnings are attached to the value, and are reported only if the value
 * is used. */
static bool read_noted(struct reader *reader, struct scene_value *value)
{
    struct warning_page page;
    bool done;
    value_warnings_begin(&reader->warnings, &page);
    done = read_statement(reader, value);
    value->value_warnings = value_warnings_end(&reader->warnings);
    return done;
}

bool value_read(struct reader *reader, struct scene_value *value)
{
    bool done;
    memset(value, 0, sizeof *value);
    if (is_token(&reader->token, "array"))
        done = array_read(reader, value);
    else if (starts_string(reader))
        done = read_string(reader, value);
    else if (is_color_word(&reader->token)
             || (starts_expression(reader) && !spline_is_alone(reader)))
        done = read_numbers(reader, value);
    else
        done = read_noted(reader, value);
    if (!done)
        value_free(value);
    return done;
}

bool is_reserved(const struct scene_token *token)
{
    return is_expression_word(token) || is_color_word(token) || is_string_word(token)
           || is_token(token, "array") || grammar_find(&file_grammar, token)
           || grammar_find(&modifier_grammar, token);
}

bool name_expected(struct reader *reader, const struct scene_token *token)
{
    struct scene_token name = *token;
    if (name.kind != TOKEN_WORD)
        return reader_expected(reader, "a name");
    if (!is_reserved(&name))
        return true;
    reader_step(reader);
    return reader_fault(reader, &name, "'%.*s' is a keyword, not a name",
                        TOKEN_TEXT(&name));
}

/* ---- #declare, #local, #undef -------------------------------------------- */

/* Reads the value and its ";", which is required after numbers. The text after another
 * kind of value is not read yet, because its meaning may depend on the name. */
static bool read_right_side(struct reader *reader, size_t depth,
                            struct scene_value *value)
{
    struct declared_value outside = reader->declared;
    size_t hold = reader_hold(reader);
    bool done;
    reader->declared = (struct declared_value){ .brackets = 1, .depth = depth };
    done = value_read(reader, value);
    reader->hold = hold;
    if (done && value->kind == VALUE_NUMBERS && !reader_at_sign(reader, ';'))
        semicolon_missing(reader);
    reader->declared = outside;
    if (!done)
        return false;
    reader_close_frames(reader, depth);
    if (reader_at_sign(reader, ';'))
        reader_step(reader);
    return true;
}

const char *target_assign(struct reader *reader, const struct target *target,
                          struct scene_value *value)
{
    const struct scene_token *name = &target->name;
    struct declared_names *symbols = &reader->symbols;
    struct declared_name *symbol;
    if (target->is_element)
        return reference_assign(&name->reference, value);
    symbol = target->local
                 ? symbols_find_at(symbols, target->level, name->text, name->length)
                 : symbols_find(symbols, name->text, name->length);
    return symbols_assign(symbols, symbol, target->local ? target->level : 0, name,
                          value);
}

/* Skips the optional [once] and ["text"] in #declare deprecated [once] ["text"] NAME.
 * Uses of the name are not reported. */
static void pass_deprecated(struct reader *reader)
{
    if (!is_token(&reader->token, "deprecated"))
        return;
    reader_step(reader);
    if (is_token(&reader->token, "once"))
        reader_step(reader);
    if (reader->token.kind == TOKEN_STRING)
        reader_step(reader);
}

bool target_read(struct reader *reader, struct target *target)
{
    size_t hops = 0;
    pass_deprecated(reader);
    if (!name_expected(reader, &reader->token))
        return false;
    if (reader_look_up(reader, &reader->token)) {
        hops = reader->token.reference.hops;
        if (reader->token.value->kind == VALUE_ARRAY && !element_read_place(reader))
            return false;
    }
    target->name = reader->token;
    target->is_element = reader->token.reference.hops > hops;
    target->level = reader->lexer.depth;
    reader_step(reader);
    return true;
}

/* Declares a name. If its value has an error, the name is declared as faulty, so that
 * uses of the name do not report the error again. */
static bool declare_value(struct reader *reader, struct target *target)
{
    struct scene_value value;
    bool done = reader_expect_sign(reader, '=')
                && read_right_side(reader, target->level, &value);
    const char *fault;
    if (!done)
        value = (struct scene_value){ .kind = VALUE_FAULTY };
    if (target->level > reader->lexer.depth)
        target->level = reader->lexer.depth;
    fault = target_assign(reader, target, &value);
    return reader_check(reader, &target->name, fault) && done;
}

bool read_declare(struct reader *reader, const struct item *item)
{
    struct target target = { .local = item->keyword->detail };
    struct declared_name *symbol;
    bool done;
    if (!target_read(reader, &target))
        return false;
    symbol = target.name.reference.symbol;
    symbol_hold(symbol);
    done = declare_value(reader, &target);
    symbol_release(symbol);
    return done;
}

bool read_undef(struct reader *reader, const struct item *item)
{
    struct scene_token name = reader->token;
    (void)item;
    if (name.kind != TOKEN_WORD)
        return reader_expected(reader, "a name");
    reader_step(reader);
    if (!symbols_remove(&reader->symbols, name.text, name.length))
        reader_warn(reader, &name, "'%.*s' is not declared", TOKEN_TEXT(&name));
    return true;
}
