/* read_options.h - the arguments of a check. */
#ifndef READ_OPTIONS_H
#define READ_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

/* An option --name VALUE or --name, or an unnamed argument. One pointer is set. */
struct check_option {
    const char *name; /* NULL: an argument that is not an option */
    uint64_t *number; /* receives a non-negative integer */
    const char **text;
    bool *flag;
};

/* Stores the arguments' values. An error prints the usage and exits with 2. */
void read_options(int argc, char **argv, const char *usage,
                  const struct check_option *options, int count);
#define READ_OPTIONS(argc, argv, usage, options) \
    read_options(argc, argv, usage, options, (int)(sizeof options / sizeof *options))

#endif
