/* viewpoints.h - the points through which many rays go: where a camera is, and lights. */
#ifndef RT_EYES_H
#define RT_EYES_H

#include <stddef.h>

/* The first ones of a scene; for each a large mesh takes room in memory. */
enum { MAX_VIEWPOINTS = 4 };

struct viewpoints {
    size_t count;
    double places[MAX_VIEWPOINTS][3];
};

#endif
