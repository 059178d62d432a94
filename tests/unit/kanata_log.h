/* kanata_log.h - whether a text is a log of the format Kanata 0004, as its description says
 * (the Konata repository, docs/kanata-log-format.md), and nothing else is known of it.
 *
 * Each line is a command and its words, apart by tabs; C= stands once, before all others.
 * Instructions are numbered from 0 as they appear, and named only after I and before R, which
 * each has in the end.  A stage is left by E, which names it, or by the next S of its lane.
 * Those that are not flushed are numbered from 0 as they retire.
 */
#ifndef TESTS_KANATA_LOG_H
#define TESTS_KANATA_LOG_H

#include <stddef.h>

/* What is wrong, and in which line, from 1; NULL: nothing. */
const char *kanata_fault(const char *text, size_t *line);

#endif
