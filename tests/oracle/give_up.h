/* give_up.h - ends a test program after an error that is no result of the test. */
#ifndef GIVE_UP_H
#define GIVE_UP_H

#include <stdio.h>
#include <stdlib.h>

/* Prints the message and ends the program with status 2. */
static inline __attribute__((noreturn)) void give_up(const char *message)
{
    fprintf(stderr, "the test cannot continue: %s\n", message);
    exit(2);
}

#endif
