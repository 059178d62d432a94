/* processes.c - runs other programs and locks files. */
#include "rt/platform/processes.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- Running a program --------------------------------------------------- */

/* Executes the program in the child process, which inherits the parent's
 * descriptors. */
static void become_program(const char *folder, char *const words[], int output,
                           int messages)
{
    if (chdir(folder) != 0 || dup2(output, STDOUT_FILENO) < 0
        || dup2(messages, STDERR_FILENO) < 0)
        _exit(PROCESS_CANNOT_RUN);
    execvp(words[0], words);
    _exit(PROCESS_NOT_FOUND);
}

/* Starts the program. Sets *output to a descriptor for reading its output. On failure
 * returns -1 with errno set. */
static pid_t start(const char *folder, char *const words[], FILE *messages, int *output)
{
    int ends[2];
    pid_t process;
    if (pipe(ends) != 0)
        return -1;
    process = fork();
    if (process == 0) {
        close(ends[0]);
        become_program(folder, words, ends[1], fileno(messages));
    }
    close(ends[1]);
    if (process < 0)
        close(ends[0]);
    *output = ends[0];
    return process;
}

/* Copies until the end of the input, and returns the number of bytes. The error
 * indicator of the stream records a write error. */
static size_t copy(int from, FILE *to)
{
    char bytes[4096];
    ssize_t count;
    size_t copied = 0;
    while ((count = read(from, bytes, sizeof bytes)) != 0)
        if (count > 0)
            copied += fwrite(bytes, 1, (size_t)count, to);
        else if (errno != EINTR)
            break;
    close(from);
    return copied;
}

static int wait_for(pid_t process)
{
    int status = 0;
    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR)
            return PROCESS_CANNOT_RUN;
    return WIFEXITED(status) ? WEXITSTATUS(status) : PROCESS_CANNOT_RUN;
}

int process_run(const char *folder, char *const words[], FILE *output, size_t *written,
                FILE **messages)
{
    FILE *file = tmpfile();
    int end, code;
    pid_t process = file ? start(folder, words, file, &end) : -1;
    if (process < 0) {
        code = errno;
        if (file)
            fclose(file);
        errno = code;
        return -1;
    }
    *written = copy(end, output);
    code = wait_for(process);
    rewind(file);
    *messages = file;
    return code;
}

/* ---- Replacing this process ---------------------------------------------- */

/* Returns the command line of this process, as words. */
static char **own_words(char *text, size_t size)
{
    FILE *file = fopen("/proc/self/cmdline", "rb");
    size_t length = file ? fread(text, 1, size - 1, file) : 0, count = 0;
    char **words = calloc(length + 1, sizeof *words);
    if (file)
        fclose(file);
    text[length] = '\0';
    for (size_t at = 0; words && at < length; at += strlen(text + at) + 1)
        words[count++] = text + at;
    return words;
}

void process_become(char *const words[])
{
    enum { MAX = 1024 };
    char text[1 << 17], program[4096];
    char **own = own_words(text, sizeof text), *all[MAX + 1];
    ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    size_t count = 0;
    program[length > 0 ? length : 0] = '\0';
    while (*words)
        all[count++] = *words++;
    all[count++] = program;
    for (size_t i = 0; own && own[i] && own[i + 1] && count < MAX; i++)
        all[count++] = own[i + 1];
    all[count] = NULL;
    free(own);
    execvp(all[0], all);
}

/* ---- Locks of files ------------------------------------------------------ */

bool process_lock(int file, bool alone)
{
    struct flock lock = { .l_type = alone ? F_WRLCK : F_RDLCK, .l_whence = SEEK_SET };
    return fcntl(file, F_SETLK, &lock) == 0;
}

bool process_lock_is_held(void)
{
    return errno == EAGAIN || errno == EACCES;
}
