/* bumps.c - decides whether bumps change any normal. */
#include "rt/scene/scene.h"

bool bumps_show(const struct bumps *bumps)
{
    const struct bump_list *list = bumps->list;

    return list && (list->bump.pattern.kind != PIGMENT_COLOR || list->average);
}
