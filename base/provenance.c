/* provenance.c - prints the comparison of a model with published figures, and the
 * sources of its constants.
 */
#include "base/provenance.h"
#include "base/plural.h"

#include <stdio.h>

static const struct {
    char letter;
    const char *name;
} sources[] = {
    { 'P', "from a primary source" }, { 'S', "secondary" }, { 'D', "derived" },
    { 'R', "reconstructed" },         { 'F', "fitted" },    { 0, NULL }
};

static size_t constants_from(const c205_model *model, char source)
{
    size_t count = 0;
    for (size_t i = 0; i < c205_model_size(model); i++)
        count += c205_model_constant(model, i)->source == source;
    return count;
}

bool provenance_is_fitted(const c205_model *model)
{
    return constants_from(model, 'F') > 0;
}

/* ---- Comparison with figures -------------------------------------------- */

static const char left_out[] =
    "instruction fetch, memory conflicts except those of gathers, the disc";
static const char left_out_projected[] =
    "its own compiler and words, memory conflicts, channels";

const char *provenance_left_out(const c205_model *model)
{
    return c205_model_is_projection(model) ? left_out_projected : left_out;
}

static const char unknown[] = "not compared with published figures";

/* Formats the number of figures that a model was compared with, and the largest error.
 * Returns false if there are no figures. */
static bool format_belief(const char *how, c205_belief belief,
                          char line[PROVENANCE_LINE])
{
    snprintf(line, PROVENANCE_LINE,
             "%s %u published figure%s, the largest error %+.1f %% (%.120s)", how,
             belief.figures, belief.figures == 1 ? "" : "s", belief.largest,
             belief.worst ? belief.worst : "");
    return belief.figures > 0;
}

void provenance_line(const c205_model *model, char line[PROVENANCE_LINE])
{
    if (!format_belief("fitted to", c205_model_fitted(model), line)
        && !format_belief("compared with", c205_model_compared(model), line))
        snprintf(line, PROVENANCE_LINE, "%s", unknown);
}

static bool print_belief_line(const char *how, c205_belief belief, const char *before,
                              FILE *file)
{
    char line[PROVENANCE_LINE];
    bool known = format_belief(how, belief, line);
    if (known)
        fprintf(file, ",\n%s%s", before, line);
    return known;
}

/* Returns the fitted model from which this model is derived, or NULL. Its errors are
 * not those of the derived model. */
static const c205_model *fitted_origin(const c205_model *model)
{
    bool known = c205_model_fitted(model).figures > 0
                 || c205_model_compared(model).figures > 0;
    const c205_model *like = known ? NULL : c205_model_like(model);
    while (like && c205_model_fitted(like).figures == 0)
        like = c205_model_like(like);
    return like;
}

static void print_origin(const c205_model *model, const char *before, FILE *file)
{
    const c205_model *origin = fitted_origin(model);
    fprintf(file, ",\n%s%s", before, unknown);
    if (origin) {
        fprintf(file, "; it is derived from %s", c205_model_name(origin));
        print_belief_line("which was fitted to", c205_model_fitted(origin), before,
                          file);
    }
}

static void print_claim(const c205_model *model, const char *before, FILE *file)
{
    fprintf(file, "%s%s on the model %s", before,
            c205_model_is_projection(model) ? "Projected, not emulated,"
                                            : "Cycle-accounted, not cycle-accurate,",
            c205_model_name(model));
}

static void print_belief(const c205_model *model, const char *before, FILE *file)
{
    bool said = print_belief_line("fitted to", c205_model_fitted(model), before, file);
    said |= print_belief_line("compared with", c205_model_compared(model), before,
                              file);
    if (!said)
        print_origin(model, before, file);
    fprintf(file, ".\n%sNot modelled: %s.\n", before, provenance_left_out(model));
}

static void print_sources(const c205_model *model, const char *before, FILE *file)
{
    const char *before_next = "";
    fprintf(file, "%s%zu constant%s:", before, c205_model_size(model),
            plural(c205_model_size(model)));
    for (size_t i = 0; sources[i].letter; i++) {
        size_t count = constants_from(model, sources[i].letter);
        if (count > 0) {
            fprintf(file, "%s %zu %s (%c)", before_next, count, sources[i].name,
                    sources[i].letter);
            before_next = ",";
        }
    }
    putc('\n', file);
}

void provenance_print(const c205_model *model, bool whole, const char *before,
                      FILE *file)
{
    print_claim(model, before, file);
    if (!whole) {
        fputs("; details: --provenance\n", file);
        return;
    }
    print_belief(model, before, file);
    print_sources(model, before, file);
}

/* ---- JSON --------------------------------------------------------------- */

static void write_belief(const char *key, c205_belief belief, struct json *json)
{
    if (belief.figures == 0) {
        json_null(json, key);
        return;
    }
    json_object(json, key);
    json_count(json, "figures", belief.figures);
    json_number(json, "largest_error_percent", belief.largest);
    json_text(json, "of", belief.worst);
    json_end(json);
}

static void write_origin(const c205_model *model, struct json *json)
{
    const c205_model *origin = fitted_origin(model);
    if (origin) {
        json_object(json, "changes");
        json_text(json, "name", c205_model_name(origin));
        write_belief("fit", c205_model_fitted(origin), json);
        json_end(json);
    }
}

void provenance_json(const c205_model *model, struct json *json)
{
    char key[2] = "";
    json_object(json, "model");
    json_text(json, "name", c205_model_name(model));
    json_text(json, "title", c205_model_title(model));
    json_bool(json, "fitted", provenance_is_fitted(model));
    write_belief("fit", c205_model_fitted(model), json);
    write_belief("comparison", c205_model_compared(model), json);
    write_origin(model, json);
    json_text(json, "not_modelled", provenance_left_out(model));
    json_object(json, "constants");
    for (size_t i = 0; sources[i].letter; i++) {
        key[0] = sources[i].letter;
        json_count(json, key, constants_from(model, key[0]));
    }
    json_end(json);
    json_end(json);
}
