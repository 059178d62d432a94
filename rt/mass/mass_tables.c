/* mass_tables.c - converts the mass properties of a scene to tables. */
#include "rt/mass/mass_tables.h"

#include <math.h>

static const struct table_column figure_columns[] = {
    { "part", "part", TABLE_TEXT, 0 },     { "figure", "figure", TABLE_TEXT, 0 },
    { "value", "value", TABLE_NUMBER, 0 }, { "error", "+-", TABLE_NUMBER, 0 },
    { "unit", "unit", TABLE_TEXT, 0 },
};
static const struct table_column overlap_columns[] = {
    { "part", "part", TABLE_TEXT, 0 },       { "other", "other", TABLE_TEXT, 0 },
    { "volume", "volume", TABLE_NUMBER, 0 }, { "error", "+-", TABLE_NUMBER, 0 },
    { "unit", "unit", TABLE_TEXT, 0 },
};
static const struct table_column axis_columns[] = {
    { "part", "part", TABLE_TEXT, 0 }, { "moment", "moment", TABLE_TEXT, 0 },
    { "x", "x", TABLE_NUMBER, 6 },     { "y", "y", TABLE_NUMBER, 6 },
    { "z", "z", TABLE_NUMBER, 6 },
};
static const struct table_column clock_columns[] = {
    { "stage", "stage", TABLE_TEXT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "clocks_per_ray", "clocks/ray", TABLE_NUMBER, 1 },
};

/* Returns the number of decimals that shows two digits of the error. A value without
 * error gets nine digits. */
static int decimals_of(double value, double error)
{
    double digits = error > 0    ? 1 - floor(log10(error))
                    : value != 0 ? 8 - floor(log10(fabs(value)))
                                 : 0;
    return digits > -300 && digits < 300 ? (int)digits : 0;
}

static int error_decimals(double error)
{
    return error > 0 ? decimals_of(0, error) : 0;
}

static void unit_of(const struct mass_units *units, size_t figure, char text[MASS_UNIT])
{
    if (figure == FIGURE_AREA)
        mass_units_text(units, 0, 2, text);
    else if (figure == FIGURE_MASS)
        mass_units_text(units, 1, 0, text);
    else if (figure == FIGURE_VOLUME || figure >= FIGURE_VIEWS)
        mass_units_text(units, 0, 3, text);
    else if (figure < FIGURE_INERTIA)
        mass_units_text(units, 0, 1, text);
    else
        mass_units_text(units, 1, 2, text);
}

static void add_figure(struct table *table, const struct mass_units *units,
                       const char *part, const char *figure, double value, double error,
                       size_t unit)
{
    char text[MASS_UNIT];
    unit_of(units, unit, text);
    table_text(table, part);
    table_text(table, figure);
    table_rounded(table, value, decimals_of(value, error));
    table_rounded(table, error, error_decimals(error));
    table_text(table, text);
}

/* Returns the volume of one cubic scene unit in cubic units of the scene file. */
static double cube_of(const struct mass *mass)
{
    return ldexp(1, 3 * mass->scene->unit_log);
}

struct table *mass_table_of_figures(const struct mass *mass)
{
    const struct mass_units *units = &mass->request->units;
    struct table *table = table_new(TABLE_COLUMNS(figure_columns));
    double volume, error;
    if (!table)
        return NULL;
    for (size_t i = 0; i < mass->row_count; i++)
        for (size_t k = 0; k < FIGURES; k++)
            add_figure(table, units, mass->rows[i].name, figure_name(k),
                       mass->rows[i].figures.value[k], mass->rows[i].figures.error[k],
                       k);
    if (mass->request->overlaps) {
        mass_overlap(&mass->sums, &volume, &error);
        volume *= cube_of(mass);
        error *= cube_of(mass);
        add_figure(table, units, "overlaps", figure_name(FIGURE_VOLUME), volume, error,
                   FIGURE_VOLUME);
    }
    return table;
}

struct table *mass_table_of_overlaps(const struct mass *mass)
{
    struct table *table = table_new(TABLE_COLUMNS(overlap_columns));
    char unit[MASS_UNIT];
    unit_of(&mass->request->units, FIGURE_VOLUME, unit);
    for (size_t i = 0; table && i < mass->overlaps.count; i++) {
        double volume, error;
        if (!mass_overlap_of(&mass->sums, i, &volume, &error))
            continue;
        volume *= cube_of(mass);
        error *= cube_of(mass);
        for (size_t k = 0; k < 2; k++)
            table_text(table, mass->parts.list[mass->overlaps.pairs[i].parts[k]].name);
        table_rounded(table, volume, decimals_of(volume, error));
        table_rounded(table, error, error_decimals(error));
        table_text(table, unit);
    }
    return table;
}

struct table *mass_table_of_axes(const struct mass *mass)
{
    struct table *table = table_new(TABLE_COLUMNS(axis_columns));
    for (size_t i = 0; table && i < mass->row_count; i++)
        for (size_t k = 0; k < 3; k++) {
            table_text(table, mass->rows[i].name);
            table_text(table, figure_name(FIGURE_PRINCIPAL + k));
            for (size_t axis = 0; axis < 3; axis++)
                table_number(table, mass->rows[i].figures.axes[k][axis]);
        }
    return table;
}

struct table *mass_table_of_clocks(const struct mass *mass)
{
    struct table *table = table_new(TABLE_COLUMNS(clock_columns));
    for (int i = 0; table && i < COLUMNS_STAGES; i++) {
        if (i == STAGE_OVERLAPS && mass->overlaps.count == 0)
            continue;
        table_text(table, columns_stage_name((enum columns_stage)i));
        table_count(table, mass->sums.clocks[i]);
        table_number(table, (double)mass->sums.clocks[i] / (double)mass_rays(mass));
    }
    return table;
}
