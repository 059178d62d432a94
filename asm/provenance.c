/* provenance.c - see provenance.h. */
#include "asm/provenance.h"

#include <stdio.h>

static const char sources[] = "PSDR";

static size_t constants_from(const c205_model *model, char source)
{
    size_t count = 0;
    for (size_t i = 0; i < c205_model_size(model); i++) {
        count += c205_model_constant(model, i)->source == source;
    }
    return count;
}

void provenance_print(const c205_model *model)
{
    printf("model %s: %zu constants, unfitted priors",
           c205_model_name(model), c205_model_size(model));
    for (size_t i = 0; sources[i]; i++) {
        printf("%s %zu %c", i ? "," : ":",
               constants_from(model, sources[i]), sources[i]);
    }
    puts(" (P primary source, S secondary, D derived, R recollected)");
}

void provenance_json(const c205_model *model, struct json *json)
{
    char key[2] = "";
    json_object(json, "model");
    json_text(json, "name", c205_model_name(model));
    json_text(json, "title", c205_model_title(model));
    json_truth(json, "fitted", false);
    json_object(json, "constants");
    for (size_t i = 0; sources[i]; i++) {
        key[0] = sources[i];
        json_count(json, key, constants_from(model, sources[i]));
    }
    json_end(json);
    json_end(json);
}
