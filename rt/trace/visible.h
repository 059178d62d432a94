/* visible.h - the methods by which the vector form finds the nearest visible
 * crossing of a solid. They are the values of VISIBLE in
 * rt/kernels/solids/visible_vector.s, which also has the default. */
#ifndef RT_VISIBLE_H
#define RT_VISIBLE_H

enum visible {
    VISIBLE_DEFAULT,
    VISIBLE_STEPPING, /* one crossing after another, until one is visible */
    VISIBLE_EVERY,
    CSG_METHODS
};
const char *visible_name(enum visible method);

#endif
