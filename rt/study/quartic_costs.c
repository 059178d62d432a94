/* quartic_costs.c - reports the costs of finding roots. */
#include "rt/study/quartic_costs.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/accounts.h"
#include "base/plural.h"
#include "base/provenance.h"
#include "rt/study/iterations_table.h"

static const struct table_column steps[] = { ITERATIONS_COLUMNS };
static const struct table_column passes[] = { ITERATIONS_PASS_COLUMNS };

static struct table *step_table(const struct iterations *iterations)
{
    struct table *table = table_new(TABLE_COLUMNS(steps));
    for (int i = 0; table && i < STAGES; i++)
        iterations_add(table, iterations, (enum stage)i);
    return table;
}

static struct table *pass_table(const struct iterations *iterations)
{
    struct table *table = table_new(TABLE_COLUMNS(passes));
    for (int i = 0; table && i < STAGES; i++) {
        size_t count = iterations_passes(iterations, (enum stage)i);
        for (size_t pass = 0; pass < count; pass++)
            iterations_add_pass(table, iterations, (enum stage)i, pass);
    }
    return table;
}

static bool print_remarks(const struct table *table, const char *heading, FILE *file)
{
    char *text = NULL;
    size_t length = 0;
    FILE *stream = open_memstream(&text, &length);
    bool good = stream && table_print(table, stream);
    bool begins = true;
    good = stream && fclose(stream) == 0 && good;
    fprintf(file, "#\n# %s:\n#\n", heading);
    for (size_t i = 0; good && i < length; i++) {
        if (begins)
            fputs(text[i] == '\n' ? "#" : "# ", file);
        putc(text[i], file);
        begins = text[i] == '\n';
    }
    free(text);
    return good;
}

bool quartic_costs_part(const struct command_output *results, const struct table *table,
                        const char *key, const char *heading)
{
    struct command_output rest = *results;
    if (results->format == OUTPUT_TEXT) {
        if (!table || !print_remarks(table, heading, results->file))
            return false;
        rest.file = NULL;
    }
    return output_table(&rest, table, key, heading);
}

void quartic_costs_model(const struct command_output *results, const c205_model *model)
{
    if (results->format == OUTPUT_TEXT)
        provenance_print(model, results->provenance, "# ", results->file);
    else
        output_model(results, model);
}

/* ---- All tables --------------------------------------------------------- */

enum { REGIONS, CAUSES, STEPS, PASSES, TABLES };

static const struct {
    const char *key, *heading;
} names[TABLES] = {
    [REGIONS] = { "regions", "Clocks by region" },
    [CAUSES] = { "causes", "By cause" },
    [STEPS] = { "steps", "Falsi, to roots of the derivative (slope: knots) "
                         "and of the polynomial (value)" },
    [PASSES] = { "passes", "Brackets still active, by pass" },
};

static void print_head(const struct quartic_costs *costs,
                       const struct command_output *results)
{
    const struct roots_options *options = costs->options;
    const char *mark = results->format == OUTPUT_TEXT ? "# " : "";
    uint64_t clocks = c205_clock(roots_machine(costs->search));
    char queue[48] = "";
    if (options->mode == TRACE_VECTOR)
        snprintf(queue, sizeof queue, ", a queue of %zu", options->queue);
    output_printf(results,
                  "%s%zu polynomial%s, %zu root%s; %s%s, %s, falsi %s\n"
                  "%s%llu clock%s, %.8f s on the machine\n",
                  mark, costs->polynomials, plural(costs->polynomials), costs->roots,
                  plural(costs->roots), trace_mode_name(options->mode), queue,
                  options->first ? "first roots" : "all roots",
                  falsi_name(roots_falsi(costs->search)), mark,
                  (unsigned long long)clocks, plural(clocks),
                  accounts_seconds(options->model, clocks));
    quartic_costs_model(results, options->model);
}

static void write_costs_head(const struct quartic_costs *costs, struct json *json)
{
    const struct roots_options *options = costs->options;
    uint64_t clocks = c205_clock(roots_machine(costs->search));
    json_text(json, "file", costs->file);
    json_text(json, "mode", trace_mode_name(options->mode));
    json_count(json, "queue", options->queue);
    json_bool(json, "first", options->first);
    json_text(json, "falsi", falsi_name(roots_falsi(costs->search)));
    json_count(json, "clocks", clocks);
    json_number(json, "seconds", accounts_seconds(options->model, clocks));
    provenance_json(options->model, json);
}

static bool print_tables(struct table *const tables[TABLES],
                         const struct command_output *results)
{
    for (int i = 0; i < TABLES; i++)
        if (!quartic_costs_part(results, tables[i], names[i].key, names[i].heading))
            return false;
    return true;
}

bool quartic_costs_print(const struct quartic_costs *costs,
                         const struct command_output *results)
{
    struct accounts accounts = { .model = costs->options->model };
    bool good = accounts_add(&accounts, roots_machine(costs->search));
    struct table *tables[TABLES] = {
        [REGIONS] = accounts_by_region(&accounts),
        [CAUSES] = accounts_by_cause(&accounts),
        [STEPS] = step_table(costs->iterations),
        [PASSES] = pass_table(costs->iterations),
    };
    print_head(costs, results);
    if (results->json)
        write_costs_head(costs, results->json);
    good = good && print_tables(tables, results);
    accounts_free(&accounts);
    for (int i = 0; i < TABLES; i++)
        table_free(tables[i]);
    return good;
}
