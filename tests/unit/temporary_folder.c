/* temporary_folder.c - makes, fills and removes a folder in /tmp. */
#include "temporary_folder.h"

#include "base/file.h"

#include <dirent.h>
#include <unistd.h>

char temporary_folder[64];

int make_folder(STATE)
{
    strcpy(temporary_folder, "/tmp/it's a \"test\" XXXXXX");
    return mkdtemp(temporary_folder) ? 0 : -1;
}

/* Ends the program if files remain, because cmocka counts no failed test for a failed
 * fixture of a group. */
int remove_folder(STATE)
{
    if (rmdir(temporary_folder) == 0)
        return 0;
    print_error("files remain in %s\n", temporary_folder);
    exit(1);
}

const char *in_folder(const char *name)
{
    static char path[512];
    snprintf(path, sizeof path, "%s/%s", temporary_folder, name);
    return path;
}

size_t empty_folder(void)
{
    size_t count = 0;
    DIR *entries = opendir(temporary_folder);
    for (struct dirent *entry; entries && (entry = readdir(entries));)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0)
            count += remove(in_folder(entry->d_name)) == 0;
    closedir(entries);
    return count;
}

void write_file(const char *name, const char *text)
{
    FILE *file = NON_NULL(fopen(in_folder(name), "w"));
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

char *text_of_file(const char *name)
{
    size_t length;
    return NON_NULL(file_read(in_folder(name), FILE_LARGEST, &length, &failure));
}
