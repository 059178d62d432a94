/* visible.c - the names of the methods for visible crossings. */
#include "rt/trace/visible.h"

static const char *const csg_methods[CSG_METHODS] = {
    [VISIBLE_DEFAULT] = "default",
    [VISIBLE_STEPPING] = "stepping",
    [VISIBLE_EVERY] = "every",
};

const char *visible_name(enum visible method)
{
    return csg_methods[method];
}
