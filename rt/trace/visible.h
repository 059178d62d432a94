/* visible.h - which crossings of a solid the vector form looks at to find the
 * nearest that can be seen: the numbers of VISIBLE in
 * rt/kernels/solids/visible_vector.s, which has the default.
 */
#ifndef RT_VISIBLE_H
#define RT_VISIBLE_H

enum visible {
    VISIBLE_DEFAULT,
    VISIBLE_STEPPING, /* one after another, until one is seen */
    VISIBLE_EVERY,
    CSG_METHODS
};
const char *visible_name(enum visible method);

#endif
