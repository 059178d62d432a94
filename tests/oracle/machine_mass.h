/* machine_mass.h - the mass properties of a scene text from the machine. */
#ifndef MACHINE_MASS_H
#define MACHINE_MASS_H

#include "rt/mass/figures.h"
#include "rt/scene/named_parts.h"

enum { MEASURED_PARTS = 4 };

struct measured {
    size_t parts;
    struct mass_figures part[MEASURED_PARTS + 1]; /* the last element is all parts
                                                   * together */
    double overlap, overlap_error;
    double middle[3], width[3]; /* centre and widths of the bounding box */
    uint64_t checksum;
    c205_error error; /* set on failure */
};

/* Measures a scene with density one. The inertia is about the origin. The options need
 * no model and no parts. On failure sets the error and returns false. */
bool measure_scene(const char *text, struct columns_options options,
                   struct measured *measured);

#endif
