/* kanata_log.h - checks that a text is a log in the format Kanata 0004. The check
 * follows the description of the format alone (the Konata repository,
 * docs/kanata-log-format.md).
 *
 * Each line is a command and its words, separated by tabs; C= occurs once, before all
 * other commands. Instructions are numbered from 0 in the order of I. A command may
 * name an instruction only after its I and before its R; each instruction has an R. A
 * stage ends with E, which names it, or with the next S of its lane. Instructions that
 * are not flushed are numbered from 0 as they retire.
 */
#ifndef TESTS_KANATA_LOG_H
#define TESTS_KANATA_LOG_H

#include <stddef.h>

/* Returns the first fault of a log and sets its line, counted from 1. NULL: no
 * fault. */
const char *kanata_fault(const char *text, size_t *line);

#endif
