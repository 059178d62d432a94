/* bounding.h - the choice of the bounding volumes that the machine tests before
 * primitives. */
#ifndef RT_BOUNDING_H
#define RT_BOUNDING_H

/* The bounding volumes that rays test, to skip primitives that they cannot hit. */
enum bounding {
    BOUNDING_HIERARCHY, /* a hierarchy over the regions' bounds, and over the parts
                         * of large trees */
    BOUNDING_FLAT,      /* the bounds of all regions in the order of the scene, and the
                         * bounds of trees as written */
    BOUNDING_NONE
};

#endif
