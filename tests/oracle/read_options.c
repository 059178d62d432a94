/* read_options.c - reads the arguments of a check (read_options.h). */
#include "tests/oracle/read_options.h"

#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>

enum { MAX_OPTIONS = 8 };

/* Returns false if the text is not a non-negative integer, or is too large. */
static bool set(const struct check_option *option, const char *text)
{
    char *end = "";
    errno = 0;
    if (option->flag)
        *option->flag = true;
    else if (option->text)
        *option->text = text;
    else
        *option->number = strtoull(text, &end, 0);
    return errno == 0 && end != text && *end == '\0'
           && (!option->number || *text != '-');
}

void read_options(int argc, char **argv, const char *usage,
                  const struct check_option *options, int count)
{
    struct option known[MAX_OPTIONS + 1] = { { NULL, 0, NULL, 0 } };
    bool good = true;
    int named = 0;
    for (; named < count && options[named].name; named++)
        known[named] = (struct option){ options[named].name,
                                        options[named].flag ? no_argument
                                                            : required_argument,
                                        NULL, named };
    for (int i; good && (i = getopt_long(argc, argv, "", known, NULL)) != -1;)
        good = i < count && set(&options[i], optarg);
    for (int i = named; good && i < count && optind < argc; i++)
        good = set(&options[i], argv[optind++]);
    if (good && optind == argc)
        return;
    fprintf(stderr, "usage: %s\n", usage);
    exit(2);
}
