/* heat_picture.h - a scene as its camera sees it, its surfaces coloured by what they lose or
 * by what of another one's radiation comes to them.
 *
 * The frame is traced by the machine, of the scene's shapes alone, in the light of a lamp
 * at the camera.  Flows go from blue, what gains most, over white, nothing, to red, what loses
 * most; factors from dark blue, none, to yellow, the largest; the surface that they are from
 * is green, unless it sees itself; what has no value is grey.  A scale with its unit is below
 * the frame, in rows of its own.  Pictures of linear colours have the value as a channel, too,
 * flow or factor: 0 where nothing is seen, and in the scale.
 */
#ifndef RT_HEAT_PICTURE_H
#define RT_HEAT_PICTURE_H

#include "rt/heat/heat.h"
#include "rt/picture/picture.h"

enum heat_shown {
    SHOWN_FLOW,   /* of a unit of area: W/m^2 where lengths are metres */
    SHOWN_FACTOR, /* from a surface; smoothed, if they are */
    HEAT_SHOWN
};
const char *heat_shown_name(enum heat_shown shown);
/* After a number: " W/m^2"; "" where there is none. */
const char *heat_shown_unit(enum heat_shown shown);

struct heat_look {
    enum heat_shown shown;
    const char *from;           /* of factors: the surface */
    struct trace_options trace; /* of the frame; its model is the heat's */
    const char *path;
};

/* What was drawn. */
struct heat_drawn {
    double least, most; /* values */
    uint64_t clocks;    /* of the frame */
};

/* False: no surface has that name, nothing has a value; a trap, no memory; the picture cannot
 * be written. */
bool heat_draw(const struct heat *heat, const struct heat_look *look,
               struct heat_drawn *drawn, c205_error *error);

#endif
