/* viewpoints.h - viewpoints that many rays pass through: the positions of cameras and
 * lights. */
#ifndef RT_VIEWPOINTS_H
#define RT_VIEWPOINTS_H

#include <stddef.h>

/* Only the first viewpoints of a scene are used, because a large mesh has a table for
 * each. */
enum { MAX_VIEWPOINTS = 4 };

struct viewpoints {
    size_t count;
    double places[MAX_VIEWPOINTS][3];
};

#endif
