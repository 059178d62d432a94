/* regions.h - what is traced as one thing, as records in the machine's memory. */
#ifndef RT_REGIONS_H
#define RT_REGIONS_H

#include "rt/layout/bounding.h"
#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* What they refer to. */
struct region_places {
    struct row primitives;
    struct row values; /* of a tree */
};

/* Whether some rays do not see a region: the kernels need R_HIDDEN_FROM. */
bool scene_hides(const struct scene *scene);

/* All regions, and the lists for one of them. */
void layout_regions(struct record_layout *layout, const struct scene *scene,
                    enum bounding bounding, const struct region_places *places);

#endif
