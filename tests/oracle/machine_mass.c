/* machine_mass.c - measures a scene text on the machine. */
#include "tests/oracle/machine_mass.h"

#include "tests/oracle/many_scenes.h"

#include <string.h>

static bool find_all(const struct columns_sums *sums, struct measured *measured)
{
    static const double origin[3] = { 0 };
    bool good = true;
    for (size_t i = 0; good && i <= measured->parts; i++) {
        double density[MEASURED_PARTS] = { 0 };
        for (size_t k = 0; k < measured->parts; k++)
            density[k] = i == k || i == measured->parts;
        const struct mass_body body = { sums, density, origin };
        good = mass_figures_find(&body, &measured->part[i]);
    }
    measured->checksum = columns_checksum(sums);
    memcpy(measured->middle, sums->middle, sizeof sums->middle);
    memcpy(measured->width, sums->width, sizeof sums->width);
    mass_overlap(sums, &measured->overlap, &measured->overlap_error);
    return good;
}

bool measure_scene(const char *text, struct columns_options options,
                   struct measured *measured)
{
    SCOPED(scene) *scene = scene_of(text);
    SCOPED(c205_model) *model = usual_model();
    SCOPED_VALUE(columns_sums) sums = { 0 };
    SCOPED_VALUE(named_parts) parts;
    if (!named_parts_find(scene, &parts) || parts.count > MEASURED_PARTS)
        give_up("the scene cannot be measured");
    measured->parts = parts.count;
    options.part_count = parts.count;
    options.part_of = parts.part_of;
    options.model = model;
    return columns_sum(scene, &options, &sums, &measured->error)
           && find_all(&sums, measured);
}
