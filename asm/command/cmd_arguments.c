/* cmd_arguments.c - the options of all commands.
 *
 * An option means the same wherever it is allowed, so there is one list of
 * them; the command table says which letters a command takes.
 */
#include <errno.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "asm/command/cmd.h"

static const struct option options[] = {
    { "model", required_argument, NULL, 'm' },
    { "json", required_argument, NULL, 'j' },
    { "output", required_argument, NULL, 'o' },
    { "define", required_argument, NULL, 'd' },
    { "include", required_argument, NULL, 'I' },
    { "limit", required_argument, NULL, 'l' },
    { "check", no_argument, NULL, 'c' },
    { "trace", no_argument, NULL, 't' },
    { "listing", no_argument, NULL, 'L' },
    { "names", no_argument, NULL, 'n' },
    { "points", no_argument, NULL, 'p' },
    { "markdown", no_argument, NULL, 'M' },
    { "save", required_argument, NULL, 's' },
    { "restore", required_argument, NULL, 'r' },
    { NULL, 0, NULL, 0 },
};

static bool parse_limit(const char *text, uint64_t *limit)
{
    char *end;
    errno = 0;
    *limit = strtoull(text, &end, 10);
    return errno == 0 && end != text && *end == '\0' && text[0] != '-';
}

/* NAME=VALUE; the name is cut off in place. */
static bool parse_define(char *text, struct cmd_arguments *arguments)
{
    struct asm_define *define = &arguments->defines[arguments->define_count];
    char *equals = strchr(text, '='), *end;
    if (!equals || equals == text || arguments->define_count == CMD_DEFINES) {
        return false;
    }
    errno = 0;
    define->value = strtoll(equals + 1, &end, 0);
    if (errno != 0 || end == equals + 1 || *end != '\0') {
        return false;
    }
    *equals = '\0';
    define->name = text;
    arguments->define_count++;
    return true;
}

static bool add_folder(const char *folder, struct cmd_arguments *arguments)
{
    if (arguments->folder_count == CMD_FOLDERS) {
        return false;
    }
    arguments->folders[arguments->folder_count++] = folder;
    return true;
}

static bool take(int letter, struct cmd_arguments *arguments)
{
    switch (letter) {
    case 'm': arguments->model = optarg; return true;
    case 'j': arguments->json = optarg; return true;
    case 'o': arguments->output = optarg; return true;
    case 's': arguments->save = optarg; return true;
    case 'r': arguments->restore = optarg; return true;
    case 'c': arguments->check = true; return true;
    case 't': arguments->trace = true; return true;
    case 'L': arguments->listing = true; return true;
    case 'n': arguments->names = true; return true;
    case 'p': arguments->points = true; return true;
    case 'M': arguments->markdown = true; return true;
    case 'd': return parse_define(optarg, arguments);
    case 'I': return add_folder(optarg, arguments);
    default: return parse_limit(optarg, &arguments->limit);
    }
}

static const char *name_of(int letter)
{
    const struct option *option = options;
    while (option->val != letter) {
        option++;
    }
    return option->name;
}

static bool parse_options(int argc, char **argv, const char *allowed,
                          struct cmd_arguments *arguments)
{
    int letter;
    opterr = 0;
    while ((letter = getopt_long(argc, argv, ":o:I:", options, NULL)) != -1) {
        if (letter == ':') {
            cmd_usage(argv[0], "%s needs an argument", argv[optind - 1]);
            return false;
        }
        if (letter == '?') {
            cmd_usage(argv[0], "no such option: %s", argv[optind - 1]);
            return false;
        }
        if (!strchr(allowed, letter)) {
            cmd_usage(argv[0], "--%s is for other commands", name_of(letter));
            return false;
        }
        if (!take(letter, arguments)) {
            cmd_usage(argv[0], "--%s: wrong argument: %s", name_of(letter),
                      optarg);
            return false;
        }
    }
    return true;
}

bool cmd_parse(int argc, char **argv, const char *allowed,
               struct cmd_arguments *arguments)
{
    memset(arguments, 0, sizeof *arguments);
    arguments->command = argv[0];
    arguments->model = CMD_DEFAULT_MODEL;
    arguments->limit = C205_NO_LIMIT;
    if (!parse_options(argc, argv, allowed, arguments)) {
        return false;
    }
    arguments->files = argv + optind;
    arguments->file_count = (size_t)(argc - optind);
    return true;
}
