#include "rt/trace/visible.h"

static const char *const ways[VISIBLE_WAYS] = {
    [VISIBLE_DEFAULT] = "default",
    [VISIBLE_STEPPING] = "stepping",
    [VISIBLE_EVERY] = "every",
};

const char *visible_name(enum visible way)
{
    return ways[way];
}
