/* run_povray.c - runs POV-Ray as a child and reads its picture (run_povray.h). */
#include "tests/oracle/run_povray.h"

#include "tests/oracle/many_scenes.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

enum { LONGEST_PATH = 4096 };

/* The temporary files of POV-Ray. */
struct workplace {
    char folder[64], picture[96], log[96];
};

static bool open_workplace(struct workplace *place)
{
    snprintf(place->folder, sizeof place->folder, "/tmp/run_povray.XXXXXX");
    if (!mkdtemp(place->folder))
        return false;
    snprintf(place->picture, sizeof place->picture, "%s/picture.png", place->folder);
    snprintf(place->log, sizeof place->log, "%s/log", place->folder);
    return true;
}

static void close_workplace(const struct workplace *place)
{
    remove(place->picture);
    remove(place->log);
    rmdir(place->folder);
}

/* Writes the options for antialiasing without jitter, or for no antialiasing. */
static void put_method(const struct antialiasing *how, char words[2][32])
{
    if (!how) {
        strcpy(words[0], "-A");
        strcpy(words[1], "+R1");
        return;
    }
    snprintf(words[0], sizeof words[0], "+A%.9g", how->threshold);
    snprintf(words[1], sizeof words[1], "+R%zu", how->samples);
}

/* Runs POV-Ray in the child process. All of its output goes to the log. */
static void become_povray(const char *scene, size_t width, size_t height,
                          const struct antialiasing *how, const struct workplace *place)
{
    char input[LONGEST_PATH], library[LONGEST_PATH];
    char output[128], wide[32], high[32], method[2][32];
    const char *slash = strrchr(scene, '/');
    int folder = slash ? (int)(slash - scene) : 1;
    int log = open(place->log, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    snprintf(input, sizeof input, "+I%s", scene);
    /* POV-Ray searches for images in the folder of the scene. */
    snprintf(library, sizeof library, "+L%.*s", folder, slash ? scene : ".");
    snprintf(output, sizeof output, "+O%s", place->picture);
    snprintf(wide, sizeof wide, "+W%zu", width);
    snprintf(high, sizeof high, "+H%zu", height);
    put_method(how, method);
    /* The output is a 16-bit PNG with linear samples. There is no display. */
    execlp("povray", "povray", input, library, output, wide, high, "+FN16",
           "File_Gamma=1.0", "-D", "-J", method[0], method[1], "+WT1", (char *)NULL);
    perror("povray");
    _exit(127);
}

static bool succeeded(pid_t child)
{
    int status = -1;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/* Sets the error message to the end of the log. */
static bool fail_with_log(const struct workplace *place, c205_error *error)
{
    FILE *log = fopen(place->log, "r");
    size_t length = 0;
    if (log && fseek(log, -(long)sizeof error->message + 1, SEEK_END) != 0)
        rewind(log);
    if (log)
        length = fread(error->message, 1, sizeof error->message - 1, log);
    error->message[length] = '\0';
    if (log)
        fclose(log);
    return false;
}

struct povray {
    struct workplace place;
    pid_t child;
    char text[96]; /* the file that contains the text, or empty */
};

static struct povray *begin(const char *scene, size_t width, size_t height,
                            const struct antialiasing *how, c205_error *error)
{
    struct povray *run = calloc(1, sizeof *run);
    if (!run || !open_workplace(&run->place)) {
        snprintf(error->message, sizeof error->message, "%s: %s",
                 run ? run->place.folder : "POV-Ray", strerror(errno));
        free(run);
        return NULL;
    }
    run->child = fork();
    if (run->child == 0)
        become_povray(scene, width, height, how, &run->place);
    return run;
}

struct povray *povray_begin(const char *path, const char *text, size_t width,
                            size_t height)
{
    c205_error error;
    keep_scene(path, text);
    struct povray *run = begin(path, width, height, NULL, &error);
    if (!run)
        give_up(error.message);
    snprintf(run->text, sizeof run->text, "%s", path);
    return run;
}

bool povray_end(struct povray *run, struct frame *frame, c205_error *error)
{
    bool good = run->child > 0 && succeeded(run->child)
                    ? picture_read(run->place.picture, frame, error)
                    : fail_with_log(&run->place, error);
    close_workplace(&run->place);
    if (run->text[0])
        remove(run->text);
    free(run);
    return good;
}

bool run_povray(const char *scene, size_t width, size_t height,
                const struct antialiasing *how, struct frame *frame, c205_error *error)
{
    struct povray *run = begin(scene, width, height, how, error);
    return run && povray_end(run, frame, error);
}
