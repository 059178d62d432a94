/* model_change.c - copies a model with some of its constants changed. */
#include "vm/time/model_parts.h"
#include "vm/error.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VALUE_SIZE = 32 };
#define OUT_OF_RANGE (UINT64_MAX / MILLION * MILLION)

/* ---- Values -------------------------------------------------------------- */

/* Returns a value in millionths, or OUT_OF_RANGE if no constant can have it. */
static uint64_t millionths_of(double value)
{
    return value >= 0 && value < 1e10 ? (uint64_t)(value * MILLION + .5) : OUT_OF_RANGE;
}

/* Writes a value as in a model file, such as "3.25". */
static void write_value(double value, char *text)
{
    uint64_t millionths = millionths_of(value);
    if (millionths == OUT_OF_RANGE) {
        snprintf(text, VALUE_SIZE, "%g", value);
        return;
    }
    int length = snprintf(text, VALUE_SIZE, "%" PRIu64 ".%06" PRIu64,
                          millionths / MILLION, millionths % MILLION);
    while (text[length - 1] == '0')
        length--;
    if (text[length - 1] == '.')
        length--;
    text[length] = '\0';
}

static bool check_value(const struct rule *rule, const char *text, uint64_t millionths,
                        bool whole, c205_error *error)
{
    return (!whole || model_check_whole(rule, text, millionths, error))
           && model_check_range(rule, text, millionths, error);
}

/* Sets a constant of a model. Writes its value to text, which must exist as long as the
 * model. */
static bool set_value(c205_model *model, const c205_setting *setting, bool whole,
                      char *text, c205_error *error)
{
    uint64_t millionths = millionths_of(setting->value);
    size_t i;
    if (!model_find_rule(model, setting->name, &i))
        return error_set(error, "unknown constant '%.60s'", setting->name);
    write_value(setting->value, text);
    if (!check_value(&model->rules[i], text, millionths, whole, error))
        return false;
    c205_constant *shown = &model->constant[i].shown;
    shown->text = text;
    shown->value = (double)millionths / MILLION;
    shown->source = 'R';
    shown->remark = "changed";
    model->constant[i].millionths = millionths;
    return true;
}

/* ---- The changed model --------------------------------------------------- */

/* Returns the buffer for the value of a setting. */
static char *value_text(const c205_model *changed, size_t setting)
{
    return changed->text + setting * VALUE_SIZE;
}

/* Copies a model, with a text buffer for each setting. */
static c205_model *copy_model(const c205_model *model, size_t count)
{
    static const c205_belief none;
    c205_model *copy = malloc(sizeof *copy);
    if (!copy)
        return NULL;
    *copy = *model;
    copy->name = NULL;
    copy->own = NULL;
    copy->like = model;
    copy->fitted = copy->compared = none;
    copy->text = malloc((count + 1) * VALUE_SIZE);
    if (copy->text)
        return copy;
    free(copy);
    return NULL;
}

/* Names the changed model, for example "NAME with machine.pipes 4, page.words 512". */
static bool name_change(c205_model *changed, const c205_setting *settings, size_t count)
{
    const char *name = changed->like->name;
    size_t size = strlen(name) + 1;
    for (size_t i = 0; i < count; i++)
        size += strlen(" with ") + strlen(settings[i].name) + VALUE_SIZE;
    changed->name = malloc(size);
    if (!changed->name)
        return false;
    char *at = changed->name, *end = at + size;
    at += snprintf(at, size, "%s", name);
    for (size_t i = 0; i < count; i++)
        at += snprintf(at, (size_t)(end - at), "%s %s %s", i == 0 ? " with" : ",",
                       settings[i].name, value_text(changed, i));
    return true;
}

static c205_model *change(const c205_model *model, const c205_setting *settings,
                          size_t count, bool whole, c205_error *error)
{
    c205_model *changed = copy_model(model, count);
    if (!changed)
        return model_out_of_memory(error);
    bool good = true;
    for (size_t i = 0; good && i < count; i++)
        good = set_value(changed, &settings[i], whole, value_text(changed, i), error);
    good = good && model_check_together(changed, error);
    if (good && name_change(changed, settings, count))
        return changed;
    if (good)
        model_out_of_memory(error);
    c205_model_free(changed);
    return NULL;
}

c205_model *c205_model_change(const c205_model *model, const c205_setting *settings,
                              size_t count, c205_error *error)
{
    return change(model, settings, count, true, error);
}

/* ---- Models in ticks ---------------------------------------------------- */

static bool is_time(const c205_constant *shown)
{
    return !strncmp(shown->unit, "clk", 3);
}

/* Converts times to ticks. Integer constants are rounded to whole ticks. */
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

c205_model *model_in_ticks(const c205_model *model, const c205_setting *settings,
                           size_t count, uint64_t ticks, c205_error *error)
{
    c205_model *changed = change(model, settings, count, false, error);
    if (changed)
        scale(changed, ticks);
    return changed;
}
