/* state.c - saves a machine to a file and restores it. */
#include "asm/view/state.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/atomic_file.h"
#include "vm/error.h"
#include "base/file.h"

static void set_path_error(c205_error *error, const char *action, const char *path,
                           const char *why)
{
    error_set(error, "cannot %s %.100s: %.130s", action, path, why);
}

/* A file of limited size, because file_read reads at most FILE_LARGEST bytes. */
struct state_file {
    FILE *file;
    size_t left;
};

static bool put(void *context, const void *bytes, size_t count)
{
    struct state_file *output = context;
    if (output->left < count)
        return false;
    output->left -= count;
    return fwrite(bytes, 1, count, output->file) == count;
}

bool state_save(const c205 *machine, const char *path, c205_error *error)
{
    c205_error reason = { "" };
    struct atomic_file *whole = atomic_file_open(path, error);
    if (!whole)
        return false;
    struct state_file output = { whole->file, FILE_LARGEST };
    if (c205_save(machine, put, &output, &reason))
        return atomic_file_commit(whole, error);
    if (output.left < sizeof(c205_word))
        error_set(&reason, "the saved machine has more than %d bytes", FILE_LARGEST);
    set_path_error(error, "write", path, reason.message);
    atomic_file_discard(whole);
    return false;
}

c205 *state_load(const char *path, const c205_model *model, c205_error *error)
{
    size_t length;
    c205_error reason = { "" };
    char *bytes = file_read(path, FILE_LARGEST, &length, &reason);
    c205 *machine = bytes ? c205_restore(bytes, length, model, &reason) : NULL;
    if (!machine)
        set_path_error(error, "read", path, reason.message);
    free(bytes);
    return machine;
}
