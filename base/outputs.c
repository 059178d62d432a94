/* outputs.c - identifies output files by device and inode. */
#include "base/outputs.h"

#include <stdlib.h>

#include "base/array.h"

struct output {
    dev_t device;
    ino_t inode;
    bool is_input;
};

static struct {
    struct output *items;
    size_t count;
} outputs;

/* Finds a regular file. Devices and pipes are never found, because they have no content
 * to lose. */
static struct output *find_output(const struct stat *status)
{
    for (size_t i = 0; S_ISREG(status->st_mode) && i < outputs.count; i++)
        if (outputs.items[i].device == status->st_dev
            && outputs.items[i].inode == status->st_ino)
            return &outputs.items[i];
    return NULL;
}

static struct output *find_path(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 ? find_output(&status) : NULL;
}

bool outputs_has(const char *path)
{
    return find_path(path) != NULL;
}

bool outputs_add(const char *path)
{
    struct stat status;
    if (stat(path, &status) != 0)
        return true;
    struct output output = { status.st_dev, status.st_ino, false };
    return array_add(&outputs.items, &outputs.count, &output, sizeof output);
}

bool outputs_refuse(const struct stat *input)
{
    struct output *output = find_output(input);
    if (output)
        output->is_input = true;
    return output != NULL;
}

bool outputs_refused(const char *path)
{
    const struct output *output = find_path(path);
    return output && output->is_input;
}

void outputs_clear(void)
{
    free(outputs.items);
    outputs.items = NULL;
    outputs.count = 0;
}
