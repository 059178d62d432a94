/* heat_picture.h - draws a scene with its surfaces coloured by the heat that they
 * lose, or by the radiation of one surface that they receive.
 *
 * The machine traces the frame from the scene's shapes alone, with a lamp at the
 * camera. Flows range from blue, the largest gain, over white, 0, to red, the
 * largest loss. Factors range from dark blue, 0, to yellow, the largest. The
 * surface that the factors are from is green, unless it sees itself. A surface
 * without a value is grey. A scale with its unit is below the frame, in rows of
 * its own. Pictures with linear colours also have the value, flow or factor, as a
 * channel. It is 0 where nothing is seen, and in the scale.
 */
#ifndef RT_HEAT_PICTURE_H
#define RT_HEAT_PICTURE_H

#include "rt/heat/heat.h"
#include "rt/picture/picture.h"

enum heat_shown {
    SHOWN_FLOW,   /* per unit of area: W/m^2 if lengths are in metres */
    SHOWN_FACTOR, /* from a surface; the smoothed one if available */
    HEAT_SHOWN
};
const char *heat_shown_name(enum heat_shown shown);
/* Returns the text after a number: " W/m^2", or "" without a unit. */
const char *heat_shown_unit(enum heat_shown shown);

struct heat_look {
    enum heat_shown shown;
    const char *from;           /* the emitting surface of factors */
    struct trace_options trace; /* of the frame; its model is that of the heat */
    const char *path;
};

/* The range of the drawn values, and the cost. */
struct heat_drawn {
    double least, most; /* values */
    uint64_t clocks;    /* of the frame */
};

/* Returns false if no surface has that name, if there is no value, after a trap,
 * if out of memory, or if the picture cannot be written. */
bool heat_draw(const struct heat *heat, const struct heat_look *look,
               struct heat_drawn *drawn, c205_error *error);

#endif
