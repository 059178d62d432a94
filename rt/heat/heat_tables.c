/* heat_tables.c - converts the areas, factors and flows of a heat computation to
 * tables. */
#include "rt/heat/heat_tables.h"

#include <math.h>

static const struct table_column area_columns[] = {
    { "surface", "surface", TABLE_TEXT, 0 }, { "kind", "kind", TABLE_TEXT, 0 },
    { "line", "line", TABLE_COUNT, 0 },      { "area", "area", TABLE_NUMBER, 6 },
    { "area_error", "+-", TABLE_NUMBER, 6 }, { "points", "points", TABLE_COUNT, 0 },
    { "rays", "rays", TABLE_COUNT, 0 },
};
static const struct table_column factor_columns[] = {
    { "from", "from", TABLE_TEXT, 0 },
    { "to", "to", TABLE_TEXT, 0 },
    { "factor", "factor", TABLE_NUMBER, 6 },
    { "factor_error", "+-", TABLE_NUMBER, 6 },
    { "rays", "rays", TABLE_COUNT, 0 },
    { "back", "A F - A' F', sigmas", TABLE_NUMBER, 2 },
};
static const struct table_column smoothed_columns[] = {
    { "from", "from", TABLE_TEXT, 0 },
    { "to", "to", TABLE_TEXT, 0 },
    { "factor", "factor", TABLE_NUMBER, 6 },
    { "factor_error", "+-", TABLE_NUMBER, 6 },
    { "smoothed", "smoothed", TABLE_NUMBER, 6 },
    { "moved", "moved, sigmas", TABLE_NUMBER, 2 },
};
static const struct table_column flow_columns[] = {
    { "surface", "surface", TABLE_TEXT, 0 },
    { "emissivity", "emissivity", TABLE_NUMBER, 3 },
    { "temperature", "K", TABLE_NUMBER, 1 },
    { "radiosity", "J, W/m^2", TABLE_NUMBER, 3 },
    { "irradiation", "H, W/m^2", TABLE_NUMBER, 3 },
    { "flow", "loses, W", TABLE_NUMBER, 3 },
};

static bool is_invisible(const struct surface *surface)
{
    return surface->tried > 0 && surface->sent == 0;
}

size_t heat_invisible(const struct heat *heat)
{
    size_t count = 0;
    for (size_t i = 0; i < heat->surfaces.count; i++)
        count += is_invisible(&heat->surfaces.list[i]);
    return count;
}

/* Returns the number of decimals of an area in the unit of the scene file. The
 * precision in the unit of the scene is always the same. */
static int decimals_of(const struct heat *heat, const struct table_column *column)
{
    return column->decimals - (int)(2 * heat->scene->unit_log * log10(2));
}

struct table *heat_table_of_areas(const struct heat *heat, bool all)
{
    struct table *table = table_new(TABLE_COLUMNS(area_columns));
    int decimals = decimals_of(heat, &area_columns[3]);
    for (size_t i = 0; table && i < heat->surfaces.count; i++) {
        const struct surface *surface = &heat->surfaces.list[i];
        if (surface->tried == 0 || (!all && is_invisible(surface)))
            continue;
        table_text(table, surface->name);
        table_text(table, primitive_kind_name(surface->first->kind));
        table_count(table, surface->first->line);
        table_rounded(table, surface->area.value, decimals);
        table_rounded(table, surface->area.error, decimals);
        table_count(table, surface->tried);
        table_count(table, surface->sent);
    }
    return table;
}

struct table *heat_table_of_factors(const struct heat *heat)
{
    const struct surfaces *surfaces = &heat->surfaces;
    struct table *table = table_new(TABLE_COLUMNS(factor_columns));
    for (size_t i = 0; table && i < surfaces->count; i++)
        for (size_t j = 0; j <= surfaces->count; j++) {
            const struct surface *surface = &surfaces->list[i];
            if (surface->count[j] == 0)
                continue;
            table_text(table, surface->name);
            table_text(table, heat_receiver(heat, j));
            table_number(table, surface->factor[j].value);
            table_number(table, surface->factor[j].error);
            table_count(table, surface->count[j]);
            table_number(table, surfaces_reciprocity(surfaces, i, j));
        }
    return table;
}

struct table *heat_table_of_smoothed(const struct heat *heat)
{
    const struct surfaces *surfaces = &heat->surfaces;
    struct table *table = table_new(TABLE_COLUMNS(smoothed_columns));
    for (size_t i = 0; table && i < surfaces->count; i++)
        for (size_t j = 0; j <= surfaces->count; j++) {
            const struct surface *surface = &surfaces->list[i];
            struct estimate factor = surface->factor[j];
            double smooth = surface_factor(surface, j);
            if (surface->count[j] == 0 && smooth == 0)
                continue;
            table_text(table, surface->name);
            table_text(table, heat_receiver(heat, j));
            table_number(table, factor.value);
            table_number(table, factor.error);
            table_number(table, smooth);
            table_number(table, factor.error > 1e-9
                                    ? (smooth - factor.value) / factor.error
                                    : NAN);
        }
    return table;
}

static void add_flow(struct table *table, const char *name, double emissivity,
                     double temperature, double flow, int decimals)
{
    table_text(table, name);
    table_number(table, emissivity);
    table_number(table, temperature);
    table_number(table, NAN);
    table_number(table, NAN);
    table_rounded(table, flow, decimals);
}

struct table *heat_table_of_flows(const struct heat *heat)
{
    const struct thermal *thermal = &heat->thermal;
    const struct exchange *exchange = &thermal->exchange;
    struct table *table = table_new(TABLE_COLUMNS(flow_columns));
    int decimals = decimals_of(heat, &flow_columns[5]);
    for (size_t i = 0; table && i < thermal->count; i++) {
        table_text(table, heat->surfaces.list[thermal->surface[i]].name);
        table_number(table, thermal->emissivity[i]);
        table_number(table, thermal->temperature[i]);
        table_number(table, exchange->radiosity[i]);
        table_number(table, exchange->irradiation[i]);
        table_rounded(table, exchange->flow[i], decimals);
    }
    if (table) {
        add_flow(table, thermal_environment, 1, thermal->outside, exchange->outside,
                 decimals);
        add_flow(table, "all", NAN, NAN, exchange->sum, decimals);
    }
    return table;
}
