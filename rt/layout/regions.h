/* regions.h - writes the regions of a scene as records in the machine's memory. */
#ifndef RT_REGIONS_H
#define RT_REGIONS_H

#include "rt/layout/bounding.h"
#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* The rows of other records to which the record of a region refers. */
struct region_places {
    struct row primitives;
    struct row values; /* values of a tree */
};

/* Returns true if a region is invisible to some rays. The kernels then need
 * R_HIDDEN_FROM. */
bool scene_hides(const struct scene *scene);

/* Writes all regions, and reserves the work lists of the kernels, which are long enough
 * for every region. */
void layout_regions(struct record_layout *layout, const struct scene *scene,
                    enum bounding bounding, const struct region_places *places);

#endif
