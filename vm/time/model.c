/* model.c - parses machine models, which are text files of constants with their
 * sources.
 */
#include "vm/time/model_parts.h"
#include "vm/error.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SCALAR(name) \
    { "latency." #name, WHOLE, "clk", 1, MILLION }, \
    { \
        "busy." #name, WHOLE, "clk", 1, MILLION \
    }
#define VECTOR(name) \
    { "startup." #name, WHOLE, "clk", 1, MILLION }, \
    { \
        "stream." #name, RATE, "", 0, MILLION \
    }

/* The constraints on the constants of machines, followed by those on the constants of
 * projections. */
static const struct rule rules[CONSTANTS + PROJECTION_CONSTANTS] = {
#define CONSTANT(id, name, kind, unit, least, most) { name, kind, unit, least, most },
#include "vm/time/constants.def"
#define TIMING(name, kind) kind(name),
#include "vm/insn.def"
#define CONSTANT(id, name, kind, unit, least, most) { name, kind, unit, least, most },
#include "vm/time/projection.def"
};

static const char shared_rate[] = "clk*pipe/element";
static const char *const rate_units[] = { shared_rate, "clk/element", "clk/bit" };
enum { RATE_UNITS = sizeof rate_units / sizeof rate_units[0] };

struct model_reader {
    c205_model *model;
    const char *line; /* the current line */
    const char *at;   /* the last word read */
    c205_place place; /* the current line; after an error, also its column */
    c205_error *error;
};

static bool model_fail(struct model_reader *reader, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    error_set_list(reader->error, format, arguments);
    va_end(arguments);
    reader->place.column = (unsigned)(reader->at - reader->line) + 1;
    return false;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static char *skip_blanks(char *at)
{
    while (is_blank(*at))
        at++;
    return at;
}

/* Splits the next word off a line. Returns "" if there is none. */
static char *next_word(struct model_reader *reader, char **line)
{
    char *word = skip_blanks(*line), *end = word;
    while (*end && !is_blank(*end))
        end++;
    *line = *end ? end + 1 : end;
    *end = '\0';
    reader->at = word;
    return word;
}

/* Returns the rest of a line without surrounding blanks. */
static char *rest_of(struct model_reader *reader, char *line)
{
    line = skip_blanks(line);
    reader->at = line;
    size_t length = strlen(line);
    while (length > 0 && is_blank(line[length - 1]))
        line[--length] = '\0';
    return line;
}

/* Reads "3.25" as 3250000. The text has at most ten digits, and at most six of them
 * after the point. */
static bool read_millionths(const char *text, uint64_t *millionths)
{
    unsigned before = 0, after = 0;
    uint64_t value = 0;
    for (; *text >= '0' && *text <= '9'; text++, before++)
        value = value * 10 + (uint64_t)(*text - '0');
    if (*text == '.')
        for (text++; *text >= '0' && *text <= '9'; text++, after++)
            value = value * 10 + (uint64_t)(*text - '0');
    if (*text || before == 0 || before > 10 || after > 6)
        return false;
    for (; after < 6; after++)
        value *= 10;
    *millionths = value;
    return true;
}

/* ---- Checks of constants ------------------------------------------------ */

bool model_check_whole(const struct rule *rule, const char *text, uint64_t millionths,
                       c205_error *error)
{
    bool whole = rule->kind == WHOLE || rule->kind == PAGE;
    return !whole || millionths % MILLION == 0
           || error_set(error, "%s must be a whole number, not %.20s", rule->name,
                        text);
}

/* Checks that a value is the number of words in a small page or in a large page. The
 * size of a large page is read in a source, and the sizes of small pages are
 * reconstructed from memory. */
static bool check_page(const struct rule *rule, const char *text, uint64_t millionths,
                       c205_error *error)
{
    static const uint64_t sizes[] = { 512, 2048, 8192, C205_PAGE_WORDS };
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        if (millionths == sizes[i] * MILLION)
            return true;
    return error_set(error, "%s must be 512, 2048, 8192 or 65536, not %.20s",
                     rule->name, text);
}

bool model_check_range(const struct rule *rule, const char *text, uint64_t millionths,
                       c205_error *error)
{
    if (rule->kind == PAGE)
        return check_page(rule, text, millionths, error);
    return (millionths >= rule->least * MILLION && millionths <= rule->most * MILLION)
           || error_set(error, "%s must be between %lu and %lu", rule->name,
                        (unsigned long)rule->least, (unsigned long)rule->most);
}

bool model_check_together(const c205_model *model, c205_error *error)
{
    return c205_model_is_projection(model)
           || model_whole(model, CONSTANT_WORD_RATE)
                  <= model_whole(model, CONSTANT_HALF_RATE)
           || error_set(error, "vector.word_rate must not be more than "
                               "vector.half_rate");
}

static bool check_value(struct model_reader *reader, const struct rule *rule,
                        const char *text, uint64_t millionths)
{
    c205_error why;
    return (model_check_whole(rule, text, millionths, &why)
            && model_check_range(rule, text, millionths, &why))
           || model_fail(reader, "%s", why.message);
}

static bool check_unit(struct model_reader *reader, const struct rule *rule,
                       const char *unit)
{
    if (rule->kind != RATE)
        return !strcmp(unit, rule->unit)
               || model_fail(reader, "the unit of %s must be %s, not '%.20s'",
                             rule->name, rule->unit, unit);
    for (size_t i = 0; i < RATE_UNITS; i++)
        if (!strcmp(unit, rate_units[i]))
            return true;
    return model_fail(reader, "the unit of %s must be %s, %s or %s, not '%.20s'",
                      rule->name, rate_units[0], rate_units[1], rate_units[2], unit);
}

bool model_find_rule(const c205_model *model, const char *name, size_t *index)
{
    for (*index = 0; *index < model->count; ++*index)
        if (!strcmp(model->rules[*index].name, name))
            return true;
    return false;
}

/* Parses a line of the form "name value unit source # remark". */
static bool read_constant(struct model_reader *reader, const char *name, char *line,
                          char *remark)
{
    c205_model *model = reader->model;
    size_t i;
    if (!model_find_rule(model, name, &i))
        return model_fail(reader, "unknown constant '%.60s'", name);
    if (model->constant[i].line)
        return model_fail(reader, "%s is already defined in line %u", name,
                          model->constant[i].line);
    uint64_t millionths;
    const char *text = next_word(reader, &line);
    if (!read_millionths(text, &millionths))
        return model_fail(reader,
                          "'%.20s' is not a number with at most six "
                          "decimals",
                          text);
    if (!check_value(reader, &model->rules[i], text, millionths))
        return false;
    const char *unit = next_word(reader, &line);
    if (!check_unit(reader, &model->rules[i], unit))
        return false;
    const char *source = next_word(reader, &line);
    if (strlen(source) != 1 || !strchr("PSDRF", *source))
        return model_fail(reader,
                          "the source of %s must be P, S, D, R or F, "
                          "not '%.20s'",
                          name, source);
    if (*rest_of(reader, line))
        return model_fail(reader, "expected the end of the line, found '%.40s'",
                          rest_of(reader, line));
    c205_constant shown = {
        model->rules[i].name,   text, (double)millionths / MILLION, unit, *source,
        rest_of(reader, remark)
    };
    model->constant[i].shown = shown;
    model->constant[i].millionths = millionths;
    model->constant[i].line = reader->place.line;
    return true;
}

static void take_rules(c205_model *model, bool projection)
{
    model->rules = projection ? rules + CONSTANTS : rules;
    model->count = projection ? PROJECTION_CONSTANTS : CONSTANTS;
}

/* Parses 'projection', after which the constants of another machine follow. */
static bool read_projection(struct model_reader *reader, char *line)
{
    c205_model *model = reader->model;
    if (*rest_of(reader, line))
        return model_fail(reader, "expected the end of the line, found '%.40s'",
                          rest_of(reader, line));
    for (size_t i = 0; i < model->count; i++)
        if (model->constant[i].shown.text)
            return model_fail(reader, "'projection' must be before the constants");
    take_rules(model, true);
    return true;
}

/* Parses 'like', which inherits all constants of a built-in model. */
static bool read_like(struct model_reader *reader, char *line)
{
    c205_model *model = reader->model;
    c205_error why;
    const char *name = rest_of(reader, line);
    if (c205_model_is_file(name))
        return model_fail(reader, "expected the name of a built-in model after 'like'");
    if (model->like)
        return model_fail(reader, "'like' is given more than once");
    model->own = c205_model_find(name, &why);
    model->like = model->own;
    if (!model->like)
        return model_fail(reader, "%.160s", why.message);
    for (size_t i = 0; i < model->count; i++)
        if (model->constant[i].line)
            return model_fail(reader, "'like' must be before the constants");
    if (c205_model_is_projection(model) && !c205_model_is_projection(model->like))
        return model_fail(reader, "%.60s is not a projection", name);
    take_rules(model, c205_model_is_projection(model->like));
    for (size_t i = 0; i < model->count; i++) {
        model->constant[i] = model->like->constant[i];
        model->constant[i].line = 0;
    }
    return true;
}

static bool read_title(struct model_reader *reader, char *line)
{
    if (reader->model->title)
        return model_fail(reader, "'title' is given more than once");
    reader->model->title = rest_of(reader, line);
    return true;
}

/* Parses a line such as: 13 figures, at most -56.1 % off: NAME */
static bool read_belief(struct model_reader *reader, const char *keyword,
                        c205_belief *belief, char *line)
{
    int used = 0;
    line = skip_blanks(line);
    if (belief->figures)
        return model_fail(reader, "'%s' is given more than once", keyword);
    sscanf(line, "%6u figures, at most %lf %% off: %n", &belief->figures,
           &belief->largest, &used);
    belief->worst = rest_of(reader, line + used);
    return (used && *line != '-' && belief->figures && fabs(belief->largest) < MILLION
            && *belief->worst)
           || model_fail(reader,
                         "expected 'N figures, at most E %% off: NAME' after '%s'",
                         keyword);
}

static bool read_line(struct model_reader *reader, char *line)
{
    char *remark = strchr(line, '#');
    if (remark)
        *remark++ = '\0';
    else
        remark = line + strlen(line);
    const char *first = next_word(reader, &line);
    if (!*first)
        return true;
    if (!strcmp(first, "title"))
        return read_title(reader, line);
    if (!reader->model->title)
        return model_fail(reader,
                          "expected 'title TEXT' at the beginning of the model");
    if (!strcmp(first, "fitted"))
        return read_belief(reader, first, &reader->model->fitted, line);
    if (!strcmp(first, "compared"))
        return read_belief(reader, first, &reader->model->compared, line);
    if (!strcmp(first, "projection"))
        return read_projection(reader, line);
    if (!strcmp(first, "like"))
        return read_like(reader, line);
    return read_constant(reader, first, line, remark);
}

static bool check_complete(struct model_reader *reader)
{
    if (!reader->model->title)
        return model_fail(reader,
                          "expected 'title TEXT' at the beginning of the model");
    const c205_model *model = reader->model;
    for (size_t i = 0; i < model->count; i++)
        if (!model->constant[i].shown.text)
            return model_fail(reader, "the constant %s is missing",
                              model->rules[i].name);
    c205_error why;
    return model_check_together(model, &why) || model_fail(reader, "%s", why.message);
}

static bool read_model(c205_model *model, c205_place *place, c205_error *error)
{
    struct model_reader reader = { .model = model, .error = error };
    bool good = true;
    take_rules(model, false);
    char *line = model->text;
    while (line && good) {
        char *end = strchr(line, '\n');
        if (end)
            *end = '\0';
        reader.place.line++;
        reader.line = reader.at = line;
        good = read_line(&reader, line);
        line = end ? end + 1 : NULL;
    }
    good = good && check_complete(&reader);
    *place = reader.place;
    return good;
}

void *model_out_of_memory(c205_error *error)
{
    error_set(error, "out of memory for a machine model");
    return NULL;
}

static char *copy_text(const char *text)
{
    size_t size = strlen(text) + 1;
    char *copy = malloc(size);
    return copy ? memcpy(copy, text, size) : NULL;
}

static char *copy_plain(const char *text, c205_error *error)
{
    char *copy = copy_text(text);
    size_t length = strlen(text);
    const char *fault = copy ? c205_plain_text(copy, &length) : NULL;
    if (!copy)
        return model_out_of_memory(error);
    if (!fault)
        return copy;
    error_set(error, "%s", fault);
    free(copy);
    return NULL;
}

c205_model *c205_model_read(const char *name, const char *text, c205_place *place,
                            c205_error *error)
{
    c205_model *model = calloc(1, sizeof *model);
    *place = (c205_place){ 0, 0 };
    if (!model)
        return model_out_of_memory(error);
    model->ticks = 1;
    model->name = copy_text(name);
    model->text = copy_plain(text, error);
    if (!model->name)
        model_out_of_memory(error);
    else if (model->text && read_model(model, place, error))
        return model;
    c205_model_free(model);
    return NULL;
}

c205_model *c205_model_parse(const char *name, const char *text, c205_error *error)
{
    c205_error why;
    c205_place place;
    c205_model *model = c205_model_read(name, text, &place, &why);
    if (!model && place.line)
        error_set(error, "%.80s:%u: %.160s", name, place.line, why.message);
    else if (!model)
        *error = why;
    return model;
}

void c205_model_free(c205_model *model)
{
    if (!model)
        return;
    c205_model_free(model->own);
    free(model->text);
    free(model->name);
    free(model);
}

/* ---- Access ------------------------------------------------------------- */

const char *c205_model_name(const c205_model *model)
{
    return model->name;
}

const char *c205_model_title(const c205_model *model)
{
    return model->title;
}

c205_belief c205_model_fitted(const c205_model *model)
{
    return model->fitted;
}

c205_belief c205_model_compared(const c205_model *model)
{
    return model->compared;
}

const c205_model *c205_model_like(const c205_model *model)
{
    return model->like;
}

bool c205_model_is_projection(const c205_model *model)
{
    return model->rules != rules;
}

size_t c205_model_size(const c205_model *model)
{
    return model->count;
}

const c205_constant *c205_model_constant(const c205_model *model, size_t i)
{
    return &model->constant[i].shown;
}

const c205_constant *c205_model_lookup(const c205_model *model, const char *name)
{
    size_t i;
    return model_find_rule(model, name, &i) ? &model->constant[i].shown : NULL;
}

uint64_t model_millionths(const c205_model *model, enum constant id)
{
    return model->constant[id].millionths;
}

uint64_t model_whole(const c205_model *model, enum constant id)
{
    return model_millionths(model, id) / MILLION;
}

static bool is_shared(const c205_model *model, enum constant id)
{
    return !strcmp(model->constant[id].shown.unit, shared_rate);
}

/* Returns a rate of the model. A rate that the pipes share is divided by the number of
 * pipes and by the constant at_once, the elements that each pipe takes per clock. */
static struct rate rate_of(const c205_model *model, enum constant id,
                           enum constant at_once)
{
    struct rate rate = { model_millionths(model, id), MILLION };
    if (is_shared(model, id))
        rate.per *= model_whole(model, CONSTANT_PIPES) * model_whole(model, at_once);
    return rate;
}

struct rate model_rate(const c205_model *model, enum constant id)
{
    return rate_of(model, id, CONSTANT_WORD_RATE);
}

struct rate model_half_rate(const c205_model *model, enum constant id)
{
    return rate_of(model, id, CONSTANT_HALF_RATE);
}

uint64_t model_ticks(const c205_model *model)
{
    return model->ticks;
}
