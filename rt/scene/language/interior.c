/* interior.c - parses interior { ... }. */
#include "rt/scene/language/scene_statement.h"

static const struct keyword words[] = {
    { "ior", item_above_0, 0 },
    { "caustics dispersion dispersion_samples fade_color fade_colour fade_distance "
      "fade_power media",
      item_left_out, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "a keyword of interior", .tables = { words } };

bool interior_read(struct reader *reader, double *ior)
{
    return block_read_from(reader, &grammar, VALUE_INTERIOR, ior, sizeof *ior);
}
