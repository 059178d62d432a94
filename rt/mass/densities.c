/* densities.c - assigns a density to each part of a scene, by the name of the part or
 * of its material. */
#include "rt/mass/densities.h"

#include <math.h>

#include "vm/error.h"

static bool is_density(double value)
{
    return value > 0 && isfinite(value);
}

const struct value_kind density_kind = {
    .name = "density", .ending = "_Density", .range = "above 0", .allows = is_density
};

bool densities_find(const struct named_values *given, const struct named_parts *parts,
                    double *densities, c205_error *error)
{
    const char *separator = ": ";
    bool good = true;
    error_set(error, "no density is set for");
    for (size_t i = 0; i < parts->count; i++) {
        const struct named_part *part = &parts->list[i];
        densities[i] = named_of_part(given, part);
        if (!isnan(densities[i]) || part->left_out)
            continue;
        good = false;
        named_parts_add_name(error, separator, part->name);
        separator = ", ";
        if (part->mixed)
            named_parts_add_name(error, " ", "(of several materials)");
    }
    if (!good)
        named_parts_add_name(error, "; ",
                             "use --density NAME=VALUE, or --density default=1");
    return good;
}
