/* provenance.c - see provenance.h. */
#include "asm/provenance.h"

#include <stdio.h>

static const char sources[] = "PSDRF";

static size_t constants_from(const c205_model *model, char source)
{
    size_t count = 0;
    for (size_t i = 0; i < c205_model_size(model); i++) {
        count += c205_model_constant(model, i)->source == source;
    }
    return count;
}

bool provenance_is_fitted(const c205_model *model)
{
    return constants_from(model, 'F') > 0;
}

const char *provenance_note(const c205_model *model)
{
    return provenance_is_fitted(model)
               ? "Fitted figures: constants of the model (F) were fitted to "
                 "the paper's Table 1 among others."
               : "Unfitted figures: the model's constants are priors, not "
                 "yet fitted to the paper.";
}

void provenance_print(const c205_model *model)
{
    bool fitted = provenance_is_fitted(model);
    printf("model %s: %zu constants, %s", c205_model_name(model),
           c205_model_size(model), fitted ? "fitted" : "unfitted priors");
    for (size_t i = 0; sources[i]; i++) {
        if (sources[i] != 'F' || fitted)
            printf("%s %zu %c", i ? "," : ":",
                   constants_from(model, sources[i]), sources[i]);
    }
    printf(" (P primary source, S secondary, D derived, R recollected%s)\n",
           fitted ? ", F fitted" : "");
}

void provenance_json(const c205_model *model, struct json *json)
{
    char key[2] = "";
    json_object(json, "model");
    json_text(json, "name", c205_model_name(model));
    json_text(json, "title", c205_model_title(model));
    json_truth(json, "fitted", provenance_is_fitted(model));
    json_object(json, "constants");
    for (size_t i = 0; sources[i]; i++) {
        key[0] = sources[i];
        json_count(json, key, constants_from(model, sources[i]));
    }
    json_end(json);
    json_end(json);
}
