/* kanata_log.h - checks that a text is a log in the format Kanata 0004. The only source
 * of the check is the description of the format (docs/kanata-log-format.md in the
 * Konata repository).
 *
 * Each line is a command and its words, separated by tabs. C= occurs once, before all
 * other commands. Instructions are numbered from 0 in the order of I. A command may
 * name an instruction only after its I and before its R. Each instruction has an R. A
 * stage ends with an E that names it, or with the next S of its lane. Instructions that
 * are not flushed are numbered from 0 in the order in which they retire.
 */
#ifndef TESTS_KANATA_LOG_H
#define TESTS_KANATA_LOG_H

#include <stddef.h>

/* Returns the first error of a log and sets *line from 1, or returns NULL. */
const char *kanata_fault(const char *text, size_t *line);

#endif
