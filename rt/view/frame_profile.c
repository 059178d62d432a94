/* frame_profile.c - profiles the clocks of a frame by lines of its kernels. */
#include "rt/view/frame_profile.h"

#include "vm/error.h"

static void *begin_band(void *context, const struct object *program, c205_error *error)
{
    struct line_profile **sum = context, *band;
    if (!*sum)
        *sum = line_profile_new(program);
    band = *sum ? line_profile_new(program) : NULL;
    if (!band)
        error_set(error, "out of memory");
    return band;
}

static void merge(void *context, const void *band)
{
    struct line_profile **sum = context;
    line_profile_add(*sum, band);
}

static void end_band(void *band)
{
    line_profile_free(band);
}

struct observer frame_profile_observer(struct line_profile **sum)
{
    return (struct observer){ begin_band, line_profile_listen, merge, end_band, sum };
}
