/* heat_picture.h - draws a scene. The colour of a surface is the heat that it loses, or
 * the radiation that it receives from another surface.
 *
 * The machine traces only the scene's shapes, with a lamp at the camera. Flows have
 * colours from blue (the largest gain) over white (0) to red (the largest loss).
 * Factors have colours from dark blue (0) to yellow (the largest factor). The surface
 * that emits the factors is green, unless it sees itself. A surface without a value is
 * grey. A scale with the unit is below the frame. Pictures with linear colours also
 * have the flow or factor as a channel, which is 0 in the background and in the scale.
 */
#ifndef RT_HEAT_PICTURE_H
#define RT_HEAT_PICTURE_H

#include "rt/heat/heat.h"
#include "rt/picture/picture.h"

enum heat_shown {
    SHOWN_FLOW,   /* per unit of area: W/m^2 if lengths are in metres */
    SHOWN_FACTOR, /* factors from a surface; the smoothed factors if available */
    HEAT_SHOWN
};
const char *heat_shown_name(enum heat_shown shown);
/* Returns the text after a number: " W/m^2", or "" for no unit. */
const char *heat_shown_unit(enum heat_shown shown);

struct heat_look {
    enum heat_shown shown;
    const char *from;           /* surface that emits the factors */
    struct trace_options trace; /* options of the frame; the model is the model of the
                                 * heat */
    const char *path;
};

/* The range of the drawn values, and the cost. */
struct heat_drawn {
    double least, most; /* range of the values */
    uint64_t clocks;    /* clocks of the frame */
};

/* Traces the scene and writes the picture. Returns false if there is no surface with
 * the name look->from, if no surface has a value, after a trap, if out of memory, or if
 * the picture cannot be written. */
bool heat_draw(const struct heat *heat, const struct heat_look *look,
               struct heat_drawn *drawn, c205_error *error);

#endif
