/* many_scenes.c - see many_scenes.h. */
#include "tests/oracle/many_scenes.h"

#include "rt/scene/language/scene_read.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void give_up(const char *message)
{
    fprintf(stderr, "scenes by chance: %s\n", message);
    exit(2);
}

c205_model *usual_model(void)
{
    c205_error error;
    c205_model *model = c205_model_find("cyber205-2pipe", &error);
    if (!model)
        give_up(error.message);
    return model;
}

struct scene *scene_of(const char *text)
{
    const struct scene_options options = { .strict = false };
    struct diagnostics reports = { 0 };
    struct scene *scene = scene_read_text("scene", text, &options, &reports);
    if (!scene) {
        fputs(text, stderr);
        diagnostics_print(&reports, stderr);
        give_up("this is no scene");
    }
    diagnostics_free(&reports);
    return scene;
}

void keep_scene(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    if (file) {
        fputs(text, file);
        fclose(file);
    }
}

void show_failure(const char *kind, size_t number, const char *how, const char *reason,
                  const char *text)
{
    char path[40];
    snprintf(path, sizeof path, "%s_%zu.pov", kind, number);
    printf("FAIL %s%s: %s\n%s", path, how, reason, text);
    fflush(stdout);
    keep_scene(path, text);
}

int check_many_ahead(int count, char **words, bool (*check)(size_t number, bool first),
                     void (*begin)(size_t number), size_t ahead)
{
    bool first = count > 1 && strcmp(words[count - 1], "--first") == 0;
    count -= first;
    size_t scenes = count > 1 ? strtoul(words[1], NULL, 10) : 300;
    size_t of = count > 3 ? strtoul(words[2], NULL, 10) : 1;
    size_t share = count > 3 ? strtoul(words[3], NULL, 10) : 0;
    size_t passed = 0, failed = 0, next = share;
    if (of == 0) {
        fprintf(stderr, "usage: %s [SCENES [OF SHARE]] [--first]\n", words[0]);
        return 2;
    }
    for (size_t i = share; i < scenes && !(first && failed); i += of) {
        for (; begin && next < scenes && next <= i + ahead * of; next += of)
            begin(next);
        check(i, first) ? passed++ : failed++;
    }
    printf("%zu passed, %zu failed\n", passed, failed);
    return failed > 0;
}

int check_many(int count, char **words, bool (*check)(size_t number, bool first))
{
    return check_many_ahead(count, words, check, NULL, 0);
}

int check_many_on(c205_model **model, int count, char **words,
                  bool (*check)(size_t number, bool first))
{
    *model = usual_model();
    int code = check_many(count, words, check);
    c205_model_free(*model);
    return code;
}
