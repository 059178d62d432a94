/* draw_scenes.c - writes random scene texts to files.
 *
 *     draw_scenes FOLDER FIRST COUNT
 *
 * Writes language_N.pov (language_scene.h) for COUNT seeds N from FIRST on. Also writes
 * the image that the scenes show.
 */
#include "tests/oracle/language_scene.h"

#include <stdio.h>
#include <stdlib.h>

static void write_text(const char *folder, const char *name, const char *text)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    if (!file || fputs(text, file) < 0 || fclose(file) != 0) {
        perror(path);
        exit(1);
    }
}

int main(int argc, char **argv)
{
    unsigned long long first = argc == 4 ? strtoull(argv[2], NULL, 10) : 0;
    unsigned long long count = argc == 4 ? strtoull(argv[3], NULL, 10) : 0;
    if (count == 0) {
        fprintf(stderr, "usage: draw_scenes FOLDER FIRST COUNT\n");
        return 2;
    }
    write_text(argv[1], LANGUAGE_IMAGE, language_image);
    for (unsigned long long seed = first; seed < first + count; seed++) {
        char *text = language_scene_text(seed);
        char name[64];
        snprintf(name, sizeof name, "language_%llu.pov", seed);
        write_text(argv[1], name, text);
        free(text);
    }
    return 0;
}
