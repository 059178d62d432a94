/* model.c - machine models: text files of constants, each with its source. */
#include "model.h"
#include "text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum kind { WHOLE, DECIMAL, RATE };

#define SCALAR(name) \
    { "latency." #name, WHOLE, "clk", 1, MILLION }, \
    { "busy." #name, WHOLE, "clk", 1, MILLION }
#define VECTOR(name) \
    { "startup." #name, WHOLE, "clk", 1, MILLION }, \
    { "stream." #name, RATE, "", 0, MILLION }

/* What a machine has to say, and behind it what a projection has. */
static const struct rule {
    const char *name;
    enum kind kind;
    const char *unit;
    uint64_t least, most;
} rules[CONSTANTS + PROJECTION_CONSTANTS] = {
#define CONSTANT(id, name, kind, unit, least, most) \
    { name, kind, unit, least, most },
#include "constants.def"
#define TIMING(name, kind) kind(name),
#include "insn.def"
#define CONSTANT(id, name, kind, unit, least, most) \
    { name, kind, unit, least, most },
#include "projection.def"
};

static const char shared_rate[] = "clk*pipe/element";
static const char *const rate_units[] = { shared_rate, "clk/element",
                                          "clk/bit" };
enum { RATE_UNITS = sizeof rate_units / sizeof rate_units[0] };

struct c205_model {
    char *name;
    char *text;       /* cut into the strings that the constants point to */
    c205_model *like; /* whose constants it took over, or NULL */
    const char *title;
    const struct rule *rules; /* that hold for it .. */
    size_t count;             /* .. so many */
    uint64_t ticks;           /* in which its times count, of a clock */
    struct {
        c205_constant shown;
        uint64_t millionths;
        unsigned line; /* where this text gives it; 0: it does not */
    } constant[CONSTANTS];
};

struct reader {
    c205_model *model;
    unsigned line;
    c205_error *error;
};

static bool fail(const struct reader *reader, const char *format, ...)
{
    char *message = reader->error->message;
    size_t size = sizeof reader->error->message;
    va_list arguments;
    va_start(arguments, format);
    int used = snprintf(message, size, "%.80s:%u: ", reader->model->name,
                        reader->line);
    if (used >= 0 && (size_t)used < size)
        vsnprintf(message + used, size - (size_t)used, format, arguments);
    va_end(arguments);
    return false;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

static char *skip_blanks(char *at)
{
    while (is_blank(*at))
        at++;
    return at;
}

/* Cut the next word off a line; "" when there is none. */
static char *next_word(char **line)
{
    char *word = skip_blanks(*line), *end = word;
    while (*end && !is_blank(*end))
        end++;
    *line = *end ? end + 1 : end;
    *end = '\0';
    return word;
}

/* What is left of a line, without the blanks around it. */
static char *rest_of(char *line)
{
    line = skip_blanks(line);
    size_t length = strlen(line);
    while (length > 0 && is_blank(line[length - 1]))
        line[--length] = '\0';
    return line;
}

/* "3.25" as 3250000.  At most nine digits before the point, six after. */
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

static bool check_value(const struct reader *reader, const struct rule *rule,
                        const char *text, uint64_t millionths)
{
    if (rule->kind == WHOLE && millionths % MILLION)
        return fail(reader, "%s must be a whole number, not %.20s",
                    rule->name, text);
    if (millionths < rule->least * MILLION ||
        millionths > rule->most * MILLION)
        return fail(reader, "%s must lie between %lu and %lu", rule->name,
                    (unsigned long)rule->least, (unsigned long)rule->most);
    return true;
}

static bool check_unit(const struct reader *reader, const struct rule *rule,
                       const char *unit)
{
    if (rule->kind != RATE)
        return !strcmp(unit, rule->unit) ||
               fail(reader, "the unit of %s is %s, not '%.20s'", rule->name,
                    rule->unit, unit);
    for (size_t i = 0; i < RATE_UNITS; i++)
        if (!strcmp(unit, rate_units[i]))
            return true;
    return fail(reader, "the unit of %s is %s, %s or %s, not '%.20s'",
                rule->name, rate_units[0], rate_units[1], rate_units[2], unit);
}

static bool find_rule(const c205_model *model, const char *name,
                      size_t *index)
{
    for (*index = 0; *index < model->count; ++*index)
        if (!strcmp(model->rules[*index].name, name))
            return true;
    return false;
}

/* name value unit source # remark */
static bool read_constant(const struct reader *reader, const char *name,
                          char *line, char *remark)
{
    c205_model *model = reader->model;
    size_t i;
    if (!find_rule(model, name, &i))
        return fail(reader, "there is no constant '%.60s'", name);
    if (model->constant[i].line)
        return fail(reader, "%s is already given in line %u", name,
                    model->constant[i].line);
    const char *text = next_word(&line), *unit = next_word(&line);
    const char *source = next_word(&line);
    uint64_t millionths;
    if (!read_millionths(text, &millionths))
        return fail(reader, "'%.20s' is not a number with at most six "
                            "decimals", text);
    if (!check_value(reader, &model->rules[i], text, millionths) ||
        !check_unit(reader, &model->rules[i], unit))
        return false;
    if (strlen(source) != 1 || !strchr("PSDRF", *source))
        return fail(reader, "the source of %s must be P, S, D, R or F, "
                            "not '%.20s'", name, source);
    if (*rest_of(line))
        return fail(reader, "'%.40s' is not expected here", rest_of(line));
    c205_constant shown = { model->rules[i].name, text, (double)millionths / MILLION,
                            unit, *source, rest_of(remark) };
    model->constant[i].shown = shown;
    model->constant[i].millionths = millionths;
    model->constant[i].line = reader->line;
    return true;
}

static bool is_path(const char *name)
{
    size_t length = strlen(name);
    return strchr(name, '/') ||
           (length >= 6 && !strcmp(name + length - 6, ".model"));
}

static void take_rules(c205_model *model, bool projection)
{
    model->rules = projection ? rules + CONSTANTS : rules;
    model->count = projection ? PROJECTION_CONSTANTS : CONSTANTS;
}

/* The times of another machine follow, with constants of their own. */
static bool read_projection(const struct reader *reader, char *line)
{
    c205_model *model = reader->model;
    if (*rest_of(line))
        return fail(reader, "'%.40s' is not expected here", rest_of(line));
    for (size_t i = 0; i < model->count; i++)
        if (model->constant[i].shown.text)
            return fail(reader, "'projection' must stand before the "
                                "constants");
    take_rules(model, true);
    return true;
}

/* Take over all constants of a built-in model. */
static bool read_like(const struct reader *reader, char *line)
{
    c205_model *model = reader->model;
    c205_error why;
    const char *name = rest_of(line);
    if (is_path(name))
        return fail(reader, "'like' names a built-in model");
    if (model->like)
        return fail(reader, "'like' stands here for the second time");
    model->like = c205_model_find(name, &why);
    if (!model->like)
        return fail(reader, "%.160s", why.message);
    take_rules(model, c205_model_is_projection(model->like));
    for (size_t i = 0; i < model->count; i++) {
        if (model->constant[i].line)
            return fail(reader, "'like' must stand before the constants");
        model->constant[i] = model->like->constant[i];
        model->constant[i].line = 0;
    }
    return true;
}

static bool read_title(const struct reader *reader, char *line)
{
    if (reader->model->title)
        return fail(reader, "'title' stands here for the second time");
    reader->model->title = rest_of(line);
    return true;
}

static bool read_line(const struct reader *reader, char *line)
{
    char *remark = strchr(line, '#');
    if (remark)
        *remark++ = '\0';
    else
        remark = line + strlen(line);
    const char *first = next_word(&line);
    if (!*first)
        return true;
    if (!strcmp(first, "title"))
        return read_title(reader, line);
    if (!reader->model->title)
        return fail(reader, "a model begins with 'title TEXT'");
    if (!strcmp(first, "projection"))
        return read_projection(reader, line);
    if (!strcmp(first, "like"))
        return read_like(reader, line);
    return read_constant(reader, first, line, remark);
}

static bool check_complete(const struct reader *reader)
{
    if (!reader->model->title)
        return fail(reader, "a model begins with 'title TEXT'");
    const c205_model *model = reader->model;
    for (size_t i = 0; i < model->count; i++)
        if (!model->constant[i].shown.text)
            return fail(reader, "the constant %s is missing",
                        model->rules[i].name);
    return true;
}

static bool read_model(c205_model *model, c205_error *error)
{
    struct reader reader = { model, 0, error };
    take_rules(model, false);
    char *line = model->text;
    while (line) {
        char *end = strchr(line, '\n');
        if (end)
            *end = '\0';
        reader.line++;
        if (!read_line(&reader, line))
            return false;
        line = end ? end + 1 : NULL;
    }
    return check_complete(&reader);
}

static void *out_of_memory(c205_error *error)
{
    snprintf(error->message, sizeof error->message,
             "no memory left for a machine model");
    return NULL;
}

static char *copy_text(const char *text)
{
    size_t size = strlen(text) + 1;
    char *copy = malloc(size);
    return copy ? memcpy(copy, text, size) : NULL;
}

c205_model *c205_model_parse(const char *name, const char *text,
                             c205_error *error)
{
    c205_model *model = calloc(1, sizeof *model);
    error->message[0] = '\0';
    if (!model)
        return out_of_memory(error);
    model->ticks = 1;
    model->name = copy_text(name);
    model->text = copy_text(text);
    if (!model->name || !model->text)
        out_of_memory(error);
    else if (read_model(model, error))
        return model;
    c205_model_free(model);
    return NULL;
}

void c205_model_free(c205_model *model)
{
    if (!model)
        return;
    c205_model_free(model->like);
    free(model->text);
    free(model->name);
    free(model);
}

/* ---- Where models come from ---------------------------------------------- */

static char *join_lines(const char *const *lines)
{
    size_t size = 1;
    for (size_t i = 0; lines[i]; i++)
        size += strlen(lines[i]);
    char *text = malloc(size), *end = text;
    if (!text)
        return NULL;
    for (size_t i = 0; lines[i]; i++) {
        size_t length = strlen(lines[i]);
        memcpy(end, lines[i], length);
        end += length;
    }
    *end = '\0';
    return text;
}

/* The whole of a file; NULL with a message. */
static char *read_file(const char *path, c205_error *error)
{
    FILE *file = fopen(path, "rb");
    size_t size = 0, room = 1 << 16;
    char *text = file ? malloc(room) : NULL;
    while (text) {
        size += fread(text + size, 1, room - size - 1, file);
        if (size + 1 < room)
            break;
        char *larger = realloc(text, room *= 2);
        if (!larger)
            free(text);
        text = larger;
    }
    bool whole = text && !ferror(file) && !memchr(text, '\0', size);
    if (file)
        fclose(file);
    if (whole)
        return text[size] = '\0', text;
    free(text);
    snprintf(error->message, sizeof error->message,
             "cannot read the machine model %.200s", path);
    return NULL;
}

static char *built_in_text(const char *name, c205_error *error)
{
    for (size_t i = 0; model_texts_names[i]; i++)
        if (!strcmp(model_texts_names[i], name)) {
            char *text = join_lines(model_texts[i].lines);
            return text ? text : out_of_memory(error);
        }
    snprintf(error->message, sizeof error->message,
             "there is no machine model '%.100s'", name);
    return NULL;
}

c205_model *c205_model_find(const char *name, c205_error *error)
{
    char *text = is_path(name) ? read_file(name, error)
                               : built_in_text(name, error);
    c205_model *model = text ? c205_model_parse(name, text, error) : NULL;
    free(text);
    return model;
}

const char *const *c205_model_names(void)
{
    return model_texts_names;
}

/* ---- What a model says ---------------------------------------------------- */

const char *c205_model_name(const c205_model *model)
{
    return model->name;
}

const char *c205_model_title(const c205_model *model)
{
    return model->title;
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

const c205_constant *c205_model_lookup(const c205_model *model,
                                       const char *name)
{
    size_t i;
    return find_rule(model, name, &i) ? &model->constant[i].shown : NULL;
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

struct rate model_rate(const c205_model *model, enum constant id)
{
    struct rate rate = { model_millionths(model, id), MILLION };
    if (is_shared(model, id))
        rate.per *= model_whole(model, CONSTANT_PIPES);
    return rate;
}

struct rate model_half_rate(const c205_model *model, enum constant id)
{
    struct rate rate = model_rate(model, id);
    if (is_shared(model, id))
        rate.per *= model_whole(model, CONSTANT_HALF_RATE);
    return rate;
}

uint64_t model_ticks(const c205_model *model)
{
    return model->ticks;
}

/* ---- The same with other values, in ticks --------------------------------- */

static bool is_time(const c205_constant *shown)
{
    return !strncmp(shown->unit, "clk", 3);
}

static bool set_value(c205_model *model, const c205_setting *setting,
                      c205_error *error)
{
    size_t i;
    if (!find_rule(model, setting->name, &i))
        snprintf(error->message, sizeof error->message,
                 "there is no constant '%.60s'", setting->name);
    else if (!(setting->value >= (double)model->rules[i].least
               && setting->value <= (double)model->rules[i].most))
        snprintf(error->message, sizeof error->message,
                 "%.60s cannot be %g", setting->name, setting->value);
    else {
        model->constant[i].millionths =
            (uint64_t)(setting->value * MILLION + .5);
        return true;
    }
    return false;
}

/* Whole numbers must be whole in ticks. */
static void scale(c205_model *model, uint64_t ticks)
{
    model->ticks = ticks;
    for (size_t i = 0; i < model->count; i++) {
        uint64_t *millionths = &model->constant[i].millionths;
        if (is_time(&model->constant[i].shown))
            *millionths *= ticks;
        if (model->rules[i].kind == WHOLE)
            *millionths = (*millionths + MILLION / 2) / MILLION * MILLION;
    }
}

c205_model *model_in_ticks(const c205_model *model,
                           const c205_setting *settings, size_t count,
                           uint64_t ticks, c205_error *error)
{
    c205_model *changed = malloc(sizeof *changed);
    if (!changed)
        return out_of_memory(error);
    *changed = *model;
    changed->name = changed->text = NULL;
    changed->like = NULL;
    for (size_t i = 0; i < count; i++)
        if (!set_value(changed, &settings[i], error)) {
            free(changed);
            return NULL;
        }
    scale(changed, ticks);
    return changed;
}
