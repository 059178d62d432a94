/* region.c - maps instructions to the regions of the accounts. */
#include "vm/machine.h"
#include "vm/error.h"
#include "vm/serializer.h"

#include <stdlib.h>
#include <string.h>

static const char no_memory[] = "out of memory for the regions of a program";

static int by_address(const void *left, const void *right)
{
    const struct region_range *a = left, *b = right;
    return (a->begin > b->begin) - (a->begin < b->begin);
}

uint32_t machine_region(const struct c205 *machine, uint64_t pc)
{
    size_t low = 0, high = machine->range_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        const struct region_range *range = &machine->ranges[middle];
        if (pc >= range->begin && pc < range->end)
            return range->region;
        if (pc < range->begin)
            high = middle;
        else
            low = middle + 1;
    }
    return 0;
}

/* Returns the index of the account with a name. Adds an account if the name is new. */
static uint32_t account_of(const char **names, size_t *count, const char *name)
{
    size_t i = 0;
    while (i < *count && strcmp(names[i], name) != 0)
        i++;
    if (i == *count)
        names[(*count)++] = name;
    return (uint32_t)i;
}

static bool check_ranges(const struct region_range *ranges, size_t count,
                         const char *const *names, c205_error *error)
{
    for (size_t i = 0; i < count; i++) {
        const char *wrong = NULL;
        if (ranges[i].begin > ranges[i].end)
            wrong = "ends before it begins";
        else if (i > 0 && ranges[i - 1].end > ranges[i].begin)
            wrong = "overlaps another";
        if (!wrong)
            continue;
        return error_set(error, "the region %.100s %s, at %llX",
                         names[ranges[i].region], wrong,
                         (unsigned long long)ranges[i].begin);
    }
    return true;
}

static bool set_ranges(struct c205 *machine, const c205_program *program,
                       struct region_range *ranges, const char **names,
                       c205_error *error)
{
    size_t name_count = 1;
    names[0] = "";
    for (size_t i = 0; i < program->region_count; i++) {
        const c205_region *region = &program->regions[i];
        ranges[i].begin = region->begin;
        ranges[i].end = region->end;
        ranges[i].region = account_of(names, &name_count, region->name);
    }
    qsort(ranges, program->region_count, sizeof *ranges, by_address);
    return check_ranges(ranges, program->region_count, (const char *const *)names,
                        error)
           && clock_set_regions(machine->clock, (const char *const *)names, name_count,
                                error);
}

bool machine_set_regions(struct c205 *machine, const c205_program *program,
                         c205_error *error)
{
    size_t count = program->region_count;
    struct region_range *ranges = malloc((count + 1) * sizeof *ranges);
    const char **names = malloc((count + 1) * sizeof *names);
    bool done = ranges && names && set_ranges(machine, program, ranges, names, error);
    if (!ranges || !names)
        error_set(error, "%s", no_memory);
    free(names);
    if (!done) {
        free(ranges);
        return false;
    }
    free(machine->ranges);
    machine->ranges = ranges;
    machine->range_count = count;
    return true;
}

/* ---- Serialization ------------------------------------------------------ */

static const char wrong_regions[] = "the regions of the saved machine are invalid";

/* Serializes the names of the accounts. Each region has an account, and the first
 * account is for all other code. */
static void walk_names(struct c205 *machine, const char **names, size_t count,
                       struct serializer *serializer)
{
    for (size_t i = 0; i < count; i++) {
        if (!serializer_is_read(serializer))
            names[i] = clock_account(machine->clock, i)->name;
        serializer_text(serializer, &names[i]);
    }
    serializer_require(serializer, count > 0 && names[0][0] == '\0', wrong_regions);
    if (serializer_is_read(serializer) && !serializer->failed
        && !clock_set_regions(machine->clock, names, count, serializer->error))
        serializer->failed = true;
}

static void walk_accounts(struct c205 *machine, struct serializer *serializer)
{
    size_t count = clock_account_count(machine->clock);
    serializer_count(serializer, &count);
    const char **names = malloc((count + 1) * sizeof *names);
    if (names)
        walk_names(machine, names, count, serializer);
    else
        serializer_refuse(serializer, no_memory);
    free(names);
}

static void walk_range(struct region_range *range, size_t regions,
                       struct serializer *serializer)
{
    size_t region = range->region;
    serializer_word(serializer, &range->begin);
    serializer_word(serializer, &range->end);
    serializer_size(serializer, &region, regions - 1);
    range->region = (uint32_t)region;
    serializer_require(serializer, range->begin <= range->end, wrong_regions);
}

static void walk_ranges(struct region_range *ranges, size_t count, size_t regions,
                        struct serializer *serializer)
{
    for (size_t i = 0; i < count; i++) {
        walk_range(&ranges[i], regions, serializer);
        serializer_require(serializer, i == 0 || ranges[i - 1].end <= ranges[i].begin,
                           wrong_regions);
    }
}

void machine_walk_regions(struct c205 *machine, struct serializer *serializer)
{
    size_t count = machine->range_count;
    walk_accounts(machine, serializer);
    serializer_count(serializer, &count);
    if (serializer_is_read(serializer)) {
        machine->ranges = calloc(count + 1, sizeof *machine->ranges);
        machine->range_count = machine->ranges ? count : 0;
        serializer_require(serializer, machine->ranges, no_memory);
    }
    walk_ranges(machine->ranges, machine->range_count,
                clock_account_count(machine->clock), serializer);
}
