/* give_up.h - ends a test program after an error other than a failed test. */
#ifndef GIVE_UP_H
#define GIVE_UP_H

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/scoped.h"
#include "vm/c205.h"

/* The error of the last failed call. */
static c205_error last_error __attribute__((unused)) = { "out of memory" };

/* Prints the message and ends the program with status 2. */
static inline __attribute__((noreturn)) void give_up(const char *message)
{
    fprintf(stderr, "the test cannot continue: %s\n", message);
    exit(2);
}

/* Ends the program unless the value is true. */
static inline void need(bool value)
{
    if (!value)
        give_up(last_error.message);
}

/* Returns the pointer. Ends the program if it is NULL. */
#define NEEDED(pointer) ((__typeof__(pointer))needed(pointer))

static inline void *needed(void *pointer)
{
    need(pointer);
    return pointer;
}

#endif
