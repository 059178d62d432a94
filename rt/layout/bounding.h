/* bounding.h - which bounds the machine asks before it meets what they bound. */
#ifndef RT_BOUNDING_H
#define RT_BOUNDING_H

/* What spares rays the primitives that they cannot meet. */
enum bounding {
    BOUNDING_HIERARCHY, /* the bounds of nodes, then of the regions below;
                           of trees with many parts likewise */
    BOUNDING_FLAT,      /* those of all regions, in the scene's order, and
                           of trees as they are written */
    BOUNDING_NONE
};

#endif
