#include "rt/trace/visible.h"

#include <string.h>

static const char *const ways[VISIBLE_WAYS] = {
    [VISIBLE_DEFAULT] = "default",
    [VISIBLE_STEPPING] = "stepping",
    [VISIBLE_EVERY] = "every",
};

bool visible_named(const char *name, enum visible *way)
{
    for (int i = 0; i < VISIBLE_WAYS; i++)
        if (strcmp(name, ways[i]) == 0) {
            *way = (enum visible)i;
            return true;
        }
    return false;
}
