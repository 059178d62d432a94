/* measured.h - the mass properties of a scene's text, as the machine finds them, for
 * tests. */
#ifndef MEASURED_H
#define MEASURED_H

#include "rt/mass/figures.h"
#include "rt/scene/scene_internal.h"

enum { MEASURED_PARTS = 4 };

struct measured {
    size_t parts;
    struct mass_figures part[MEASURED_PARTS + 1]; /* the last one: all of them */
    double overlap, overlap_error;
    double middle[3], width[3]; /* of the box about all of it */
    uint64_t checksum;
    c205_error error; /* if there is one */
};

/* All of density one, inertia about the origin.  Options without model and parts, which
 * are found here.  False: it cannot be measured; the error says why. */
bool measure_scene(const char *text, struct columns_options options,
                   struct measured *measured);

#endif
