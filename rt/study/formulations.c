/* formulations.c - compares formulations of the cylinder kernel in a table. */
#include "rt/study/formulations.h"

#include <string.h>

#include "rt/study/speedup_report.h"

/* The numbers of decimals are as in the paper. Each time is followed by its error. */
static const struct table_column columns[] = {
    { "formulation", "formulation", TABLE_TEXT, 0 },
    { "scalar", "205 scalar, s", TABLE_NUMBER, 3 },
    { "scalar_error", "error %", TABLE_NUMBER, 1 },
    { "vector", "205 vector, s", TABLE_NUMBER, 4 },
    { "vector_error", "error %", TABLE_NUMBER, 1 },
    { "cyber720", "720, s", TABLE_NUMBER, 2 },
    { "cyber720_error", "error %", TABLE_NUMBER, 1 },
};

/* Returns the row of the cylinder in the paper's Table 1. */
static const struct speedup_paper *printed(void)
{
    size_t i = 0;
    while (strcmp(speedup_subjects[i].name, "cylinder") != 0)
        i++;
    return &speedup_subjects[i].paper;
}

static void add_times(struct table *table, const char *name,
                      const double figures[SPEEDUP_FIGURES],
                      const double paper[SPEEDUP_FIGURES])
{
    table_text(table, name);
    for (int i = 0; i <= SPEEDUP_720_SECONDS; i++) {
        table_number(table, figures[i]);
        if (figures == paper)
            table_gap(table);
        else
            table_signed(table, speedup_error(figures[i], paper[i]), 1);
    }
}

struct table *formulations_table(const c205_model *model,
                                 const struct speedup_measure (*measures)[TRACE_FORMS])
{
    struct table *table = table_new(TABLE_COLUMNS(columns));
    double paper[SPEEDUP_FIGURES];
    if (!table)
        return NULL;
    speedup_paper_figures(printed(), paper);
    add_times(table, "the paper", paper, paper);
    for (size_t i = 0; i < speedup_formulation_count; i++) {
        double figures[SPEEDUP_FIGURES];
        speedup_figures(model, measures[i], figures);
        add_times(table, speedup_formulations[i].name, figures, paper);
    }
    return table;
}
