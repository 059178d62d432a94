/* print.h - what a program asks the monitor to print, as text.
 *
 * EXIT R, S, request with
 *
 *   1  R in decimal      2  R as an integer     3  R in hex
 *   4  text: R is a descriptor of length(R) bytes
 *   5  newline           6  vector of numbers R
 *   7  bit vector R
 *
 * S says how numbers look (1, 2, 6): its low 8 bits are digits, the next 8 the width, 16 how many
 * elements of a vector are in a line, 8 the notation: 0 as short as can be, 1 fixed,
 * 2 scientific (c205_to_decimal).  Register 0: plainly.
 */
#ifndef ASM_PRINT_H
#define ASM_PRINT_H

#include "base/sink.h"
#include "vm/c205.h"

struct printer {
    struct sink sink;
};

/* A c205_listener whose context is a struct printer. */
void printer_listen(void *printer, const c205 *machine, const c205_event *event);

#endif
