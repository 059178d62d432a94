/* profile.c - traces a frame in three stages, and compares the costs. */
#include "rt/study/profile.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "vm/error.h"
#include "rt/shapes/shape.h"
#include "rt/platform/thread_pool.h"

const enum trace_mode profile_stages[TRACE_MODES] = { TRACE_SCALAR, TRACE_KERNELS,
                                                      TRACE_VECTOR };
enum { SERIAL }; /* index of the first stage, with which the others are compared */

static const char *const part_names[PROFILE_PARTS] = {
    [PART_GENERATE] = "generate",
    [PART_INTERSECT] = "intersect",
    [PART_VISIBLE] = "visible surface",
    [PART_SHADE] = "shade",
    [PART_SPAWN] = "spawn",
    [PART_REST] = "rest",
};

/* A region that kernels in rt/kernels/ declare with .kernel, and the part of the frame
 * to which it belongs. */
struct profile_region {
    const char *name; /* NULL: the regions of the shapes */
    enum profile_part part;
};
static const struct profile_region regions[] = {
    { "camera", PART_GENERATE },
    { "generate", PART_GENERATE },
    { "bound", PART_INTERSECT },
    { "call", PART_INTERSECT },
    { "transform", PART_INTERSECT },
    { NULL, PART_INTERSECT },
    { "quartic", PART_INTERSECT },
    { "root_solver", PART_INTERSECT },
    { "visible", PART_VISIBLE },
    { "shade", PART_SHADE },
    { "power", PART_SHADE },
    { "shadow", PART_SHADE },
    { "spawn", PART_SPAWN },
    { "resolve", PART_SPAWN },
    { "frame", PART_REST },
    { "average", PART_REST },
    { "", PART_REST },
};
enum {
    REGIONS = sizeof regions / sizeof *regions,
    MAX_REGIONS = REGIONS + PRIMITIVE_KINDS
};

/* Returns true if no earlier shape has the same region. */
static bool is_first_of_region(size_t kind)
{
    for (size_t i = 0; i < kind; i++)
        if (strcmp(shapes[i]->region, shapes[kind]->region) == 0)
            return false;
    return true;
}

static size_t list_regions(struct profile_region list[MAX_REGIONS])
{
    size_t count = 0;
    for (size_t i = 0; i < REGIONS; i++) {
        if (regions[i].name)
            list[count++] = regions[i];
        for (size_t k = 0; !regions[i].name && k < PRIMITIVE_KINDS; k++)
            if (is_first_of_region(k))
                list[count++] = (struct profile_region){ shapes[k]->region,
                                                         regions[i].part };
    }
    return count;
}

const char *profile_part_name(enum profile_part part)
{
    return part_names[part];
}

bool profile_part_of(const char *region, enum profile_part *part)
{
    struct profile_region list[MAX_REGIONS];
    size_t count = list_regions(list);
    for (size_t i = 0; i < count; i++)
        if (strcmp(list[i].name, region) == 0) {
            *part = list[i].part;
            return true;
        }
    return false;
}

/* ---- Sums ---------------------------------------------------------------- */

static uint64_t clocks_of_region(const struct trace *trace, const char *region)
{
    const c205_account *account = accounts_find(trace_accounts(trace), region);
    return account ? accounts_clocks(account) : 0;
}

static uint64_t clocks_of_part(const struct trace *trace, enum profile_part part)
{
    struct profile_region list[MAX_REGIONS];
    size_t count = list_regions(list);
    uint64_t clocks = 0;
    for (size_t i = 0; i < count; i++)
        if (list[i].part == part)
            clocks += clocks_of_region(trace, list[i].name);
    return clocks;
}

static uint64_t clocks_of_frame(const struct trace *trace)
{
    return trace_accounts(trace)->clocks;
}

static double ratio(uint64_t a, uint64_t b)
{
    return b > 0 ? (double)a / (double)b : NAN;
}

/* ---- Clocks by part ------------------------------------------------------ */

static const struct table_column clock_columns[] = {
    { "part", "part", TABLE_TEXT, 0 },
    { "kernel", "kernel", TABLE_TEXT, 0 }, /* empty: the clocks of the whole part */
    { "scalar_clocks", "scalar", TABLE_COUNT, 0 },
    { "scalar_seconds", "s", TABLE_NUMBER, 3 },
    { "scalar_percent", "%", TABLE_NUMBER, 1 },
    { "kernels_clocks", "kernels", TABLE_COUNT, 0 },
    { "kernels_seconds", "s", TABLE_NUMBER, 3 },
    { "kernels_percent", "%", TABLE_NUMBER, 1 },
    { "kernels_speedup", "x", TABLE_NUMBER, 2 },
    { "vector_clocks", "vector", TABLE_COUNT, 0 },
    { "vector_seconds", "s", TABLE_NUMBER, 3 },
    { "vector_percent", "%", TABLE_NUMBER, 1 },
    { "vector_speedup", "x", TABLE_NUMBER, 2 },
};

static void add_clocks(struct table *table, const struct profile *profile,
                       const char *part, const char *kernel,
                       const uint64_t clocks[TRACE_MODES])
{
    table_text(table, part);
    table_text(table, kernel);
    for (int i = 0; i < TRACE_MODES; i++) {
        table_count(table, clocks[i]);
        table_number(table, accounts_seconds(trace_accounts(profile->traces[i])->model,
                                             clocks[i]));
        table_number(table,
                     100 * ratio(clocks[i], clocks_of_frame(profile->traces[i])));
        if (i != SERIAL)
            table_number(table, ratio(clocks[SERIAL], clocks[i]));
    }
}

static void add_region(struct table *table, const struct profile *profile,
                       const char *region)
{
    uint64_t clocks[TRACE_MODES], sum = 0;
    for (int i = 0; i < TRACE_MODES; i++)
        sum += clocks[i] = clocks_of_region(profile->traces[i], region);
    if (sum > 0)
        add_clocks(table, profile, part_names[PART_INTERSECT], region, clocks);
}

static void add_part(struct table *table, const struct profile *profile,
                     enum profile_part part)
{
    struct profile_region list[MAX_REGIONS];
    size_t count = list_regions(list);
    uint64_t clocks[TRACE_MODES];
    for (int i = 0; i < TRACE_MODES; i++)
        clocks[i] = clocks_of_part(profile->traces[i], part);
    add_clocks(table, profile, part_names[part], "", clocks);
    for (size_t i = 0; part == PART_INTERSECT && i < count; i++)
        if (list[i].part == part)
            add_region(table, profile, list[i].name);
}

static void fill_clocks(struct table *table, const struct profile *profile)
{
    uint64_t clocks[TRACE_MODES];
    for (int part = 0; part < PROFILE_PARTS; part++)
        add_part(table, profile, (enum profile_part)part);
    for (int i = 0; i < TRACE_MODES; i++)
        clocks[i] = clocks_of_frame(profile->traces[i]);
    add_clocks(table, profile, "the frame", "", clocks);
}

/* ---- The parts in three groups -------------------------------------------- */

static const struct table_column group_columns[] = {
    { "part", "part", TABLE_TEXT, 0 },
    { "scalar", "scalar", TABLE_NUMBER, 2 },
    { "scalar_percent", "%", TABLE_NUMBER, 1 },
    { "kernels", "kernels", TABLE_NUMBER, 2 },
    { "kernels_percent", "%", TABLE_NUMBER, 1 },
    { "kernels_speedup", "x", TABLE_NUMBER, 2 },
    { "vector", "vector", TABLE_NUMBER, 2 },
    { "vector_percent", "%", TABLE_NUMBER, 1 },
    { "vector_speedup", "x", TABLE_NUMBER, 2 },
};

/* Groups of related parts. The part that intersects primitives is listed by kernel. */
enum { GROUPS = 3 };
static const struct {
    const char *name;
    size_t count;
    enum profile_part parts[PROFILE_PARTS];
} groups[GROUPS] = {
    { "rays", 3, { PART_GENERATE, PART_SPAWN, PART_REST } },
    { "intersections", 1, { PART_INTERSECT } },
    { "surfaces", 2, { PART_VISIBLE, PART_SHADE } },
};

static void add_millions(struct table *table, const struct profile *profile,
                         const char *indent, const char *name,
                         const uint64_t clocks[TRACE_MODES])
{
    char text[64];
    snprintf(text, sizeof text, "%s%s", indent, name);
    table_text(table, text);
    for (int i = 0; i < TRACE_MODES; i++) {
        table_number(table, (double)clocks[i] / 1e6);
        table_number(table,
                     100 * ratio(clocks[i], clocks_of_frame(profile->traces[i])));
        if (i != SERIAL)
            table_number(table, ratio(clocks[SERIAL], clocks[i]));
    }
}

/* Sums the clocks of a region in each stage. If region is NULL, sums the clocks of the
 * part. Returns false if all sums are 0. */
static bool find_clocks(const struct profile *profile, enum profile_part part,
                        const char *region, uint64_t clocks[TRACE_MODES])
{
    uint64_t sum = 0;
    for (int i = 0; i < TRACE_MODES; i++)
        sum += clocks[i] = region ? clocks_of_region(profile->traces[i], region)
                                  : clocks_of_part(profile->traces[i], part);
    return sum > 0;
}

static void add_members(struct table *table, const struct profile *profile,
                        enum profile_part part)
{
    struct profile_region list[MAX_REGIONS];
    uint64_t clocks[TRACE_MODES];
    size_t count;
    if (part != PART_INTERSECT) {
        if (find_clocks(profile, part, NULL, clocks))
            add_millions(table, profile, "  ", part_names[part], clocks);
        return;
    }
    count = list_regions(list);
    for (size_t i = 0; i < count; i++)
        if (list[i].part == part && find_clocks(profile, part, list[i].name, clocks))
            add_millions(table, profile, "  ", list[i].name, clocks);
}

static void add_group(struct table *table, const struct profile *profile, size_t group)
{
    uint64_t clocks[TRACE_MODES], sum[TRACE_MODES] = { 0 };
    for (size_t k = 0; k < groups[group].count; k++) {
        find_clocks(profile, groups[group].parts[k], NULL, clocks);
        for (int i = 0; i < TRACE_MODES; i++)
            sum[i] += clocks[i];
    }
    add_millions(table, profile, "", groups[group].name, sum);
    for (size_t k = 0; k < groups[group].count; k++)
        add_members(table, profile, groups[group].parts[k]);
}

static void fill_groups(struct table *table, const struct profile *profile)
{
    uint64_t clocks[TRACE_MODES];
    for (size_t group = 0; group < GROUPS; group++)
        add_group(table, profile, group);
    for (int i = 0; i < TRACE_MODES; i++)
        clocks[i] = clocks_of_frame(profile->traces[i]);
    add_millions(table, profile, "", "the frame", clocks);
}

/* ---- Amdahl's law -------------------------------------------------------- */

static const struct table_column speedup_columns[] = {
    { "stage", "stage", TABLE_TEXT, 0 },
    { "vectorised", "vectorised", TABLE_TEXT, 0 },
    { "share_percent", "% of scalar", TABLE_NUMBER, 1 },
    { "part_speedup", "their speedup", TABLE_NUMBER, 2 },
    { "amdahl", "Amdahl: frame", TABLE_NUMBER, 2 },
    { "limit", "limit", TABLE_NUMBER, 2 },
    { "measured", "measured", TABLE_NUMBER, 2 },
};

/* For each stage after the scalar one: the parts that it computes in vector form, in
 * order of importance. */
static const struct {
    int stage;
    size_t count;
    enum profile_part parts[PROFILE_PARTS];
} vectorised[] = {
    { 1, 2, { PART_INTERSECT, PART_REST } },
    { 2,
      PROFILE_PARTS,
      { PART_INTERSECT, PART_VISIBLE, PART_SHADE, PART_SPAWN, PART_GENERATE,
        PART_REST } },
};
enum { VECTORISED = sizeof vectorised / sizeof *vectorised };

/* Adds a row for each part, in order. The prediction assumes that the parts up to this
 * part take the time of the stage, and that the others take the time of the scalar
 * form. The limit assumes that the parts up to this part take no time. The row of the
 * last part also has the measured speedup. */
static void add_amdahl(struct table *table, const struct profile *profile, size_t row)
{
    int stage = vectorised[row].stage;
    uint64_t frame = clocks_of_frame(profile->traces[SERIAL]);
    uint64_t serial = 0, now = 0;
    for (size_t i = 0; i < vectorised[row].count; i++) {
        enum profile_part part = vectorised[row].parts[i];
        bool last = i + 1 == vectorised[row].count;
        char what[64];
        snprintf(what, sizeof what, "%s%s", i > 0 ? "+ " : "", part_names[part]);
        serial += clocks_of_part(profile->traces[SERIAL], part);
        now += clocks_of_part(profile->traces[stage], part);
        table_text(table, trace_mode_name(profile_stages[stage]));
        table_text(table, what);
        table_number(table, 100 * ratio(serial, frame));
        table_number(table, ratio(serial, now));
        table_number(table, ratio(frame, frame - serial + now));
        table_number(table, ratio(frame, frame - serial));
        table_number(table, last ? ratio(frame, clocks_of_frame(profile->traces[stage]))
                                 : NAN);
    }
}

static void fill_speedup(struct table *table, const struct profile *profile)
{
    for (size_t row = 0; row < VECTORISED; row++)
        add_amdahl(table, profile, row);
}

/* ---- Vectors and rays ---------------------------------------------------- */

static const struct table_column vector_columns[] = {
    { "stage", "stage", TABLE_TEXT, 0 },
    { "instructions", "vector instructions", TABLE_COUNT, 0 },
    { "elements", "elements", TABLE_COUNT, 0 },
    { "length", "mean length", TABLE_NUMBER, 1 },
    { "controlled", "under control", TABLE_COUNT, 0 },
    { "density_percent", "% let through", TABLE_NUMBER, 1 },
};

static void fill_vectors(struct table *table, const struct profile *profile)
{
    for (int i = 0; i < TRACE_MODES; i++) {
        const struct vector_use *use = &profile->vectors[i];
        table_text(table, trace_mode_name(profile_stages[i]));
        table_count(table, use->instructions);
        table_count(table, use->elements);
        table_number(table, ratio(use->elements, use->instructions));
        table_count(table, use->controlled);
        table_number(table, 100 * ratio(use->wanted, use->controlled));
    }
}

static const struct table_column ray_columns[] = {
    { "kind", "rays", TABLE_TEXT, 0 },
    { "count", "count", TABLE_COUNT, 0 },
    { "per_pixel", "a pixel", TABLE_NUMBER, 3 },
};

static void fill_rays(struct table *table, const struct profile *profile)
{
    for (int kind = 0; kind < RAY_KINDS; kind++) {
        uint64_t count = trace_rays(profile->traces[SERIAL], (enum ray_kind)kind);
        table_text(table, ray_kind_name((enum ray_kind)kind));
        table_count(table, count);
        table_number(table,
                     ratio(count, trace_rays(profile->traces[SERIAL], RAY_PRIMARY)));
    }
}

/* ---- All tables ---------------------------------------------------------- */

static const struct {
    const char *key, *heading;
    const struct table_column *columns;
    size_t count;
    void (*fill)(struct table *, const struct profile *);
} tables[PROFILE_TABLES] = {
    [PROFILE_GROUPS] = { "groups",
                         "Millions of clocks; x: how many times as fast as "
                         "scalar",
                         TABLE_COLUMNS(group_columns), fill_groups },
    [PROFILE_CLOCKS] = { "clocks",
                         "Clocks part by part; x: how many times "
                         "as fast as scalar",
                         TABLE_COLUMNS(clock_columns), fill_clocks },
    [PROFILE_SPEEDUP] = { "speedup",
                          "The frame and the prediction of Amdahl's law, vectorised "
                          "part by part",
                          TABLE_COLUMNS(speedup_columns), fill_speedup },
    [PROFILE_VECTORS] = { "vectors", "Vectors", TABLE_COLUMNS(vector_columns),
                          fill_vectors },
    [PROFILE_RAYS] = { "rays", "Rays by kind", TABLE_COLUMNS(ray_columns), fill_rays },
};

const char *profile_table_key(enum profile_table kind)
{
    return tables[kind].key;
}

const char *profile_table_heading(enum profile_table kind)
{
    return tables[kind].heading;
}

/* ---- A frame in all stages ----------------------------------------------- */

struct profiling {
    struct profile *profile;
    const struct scene *scene;
    const struct trace_options *options;
};

static bool run_stage(void *context, const struct task *task, c205_error *error)
{
    const struct profiling *profiling = context;
    struct profile *profile = profiling->profile;
    size_t stage = task->number;
    struct observer vectors = vector_use_observer(&profile->vectors[stage]);
    const struct observer *const observers[] = { &vectors, NULL };
    struct trace_options how = *profiling->options;
    struct trace *trace;
    how.mode = profile_stages[stage];
    how.observers = observers;
    how.progress = task->progress;
    how.context = task->context;
    trace = profile->traces[stage] = trace_new(profiling->scene, &how, error);
    return trace && trace_run(trace, error);
}

/* Returns the measured relative cost of a stage on the host. The vector stage is the
 * cheapest, because the host emulates a whole vector instruction at once. */
static double stage_weight(const void *context, size_t stage)
{
    static const double weights[TRACE_MODES] = {
        [TRACE_SCALAR] = 10, [TRACE_KERNELS] = 4, [TRACE_VECTOR] = 1
    };
    (void)context;
    return weights[profile_stages[stage]];
}

static bool agree(const struct profile *profile, int stage, c205_error *error)
{
    if (trace_checksum(profile->traces[stage]) == trace_checksum(profile->traces[0]))
        return true;
    return error_set(error, "the frames of the stages %s and %s do not agree",
                     trace_mode_name(profile_stages[0]),
                     trace_mode_name(profile_stages[stage]));
}

bool profile_run(struct profile *profile, const struct scene *scene,
                 const struct trace_options *options, c205_error *error)
{
    struct profiling profiling = { profile, scene, options };
    const struct thread_pool pool = { .count = TRACE_MODES,
                                      .run = run_stage,
                                      .weight = stage_weight,
                                      .context = &profiling,
                                      .progress = options->progress,
                                      .progress_context = options->context };
    if (!thread_pool_run(&pool, error))
        return false;
    for (int i = 0; i < TRACE_MODES; i++)
        if (!agree(profile, i, error))
            return false;
    return true;
}

void profile_free(struct profile *profile)
{
    for (int i = 0; i < TRACE_MODES; i++)
        trace_free(profile->traces[i]);
}

struct table *profile_table(enum profile_table kind, const struct profile *profile)
{
    struct table *table = table_new(tables[kind].columns, tables[kind].count);
    if (table)
        tables[kind].fill(table, profile);
    return table;
}
