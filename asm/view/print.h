/* print.h - executes the print requests of a program to the monitor.
 *
 * The requests are EXIT R, S, request with
 *
 *   1  R in decimal      2  R as an integer     3  R in hex
 *   4  text: R is a descriptor of length(R) bytes
 *   5  newline           6  vector of numbers R
 *   7  bit vector R
 *
 * S determines the layout of numbers (requests 1, 2, 6). Its fields, from the right,
 * are 8 bits for the digits, 8 for the width, 16 for the elements of a vector per line,
 * and 8 for the notation: 0 shortest, 1 fixed, 2 scientific (c205_to_decimal). Register
 * 0 as S selects the default.
 */
#ifndef ASM_PRINT_H
#define ASM_PRINT_H

#include "base/sink.h"
#include "vm/c205.h"

struct printer {
    struct sink sink;
};

/* The listener that serves print requests. Its context is a struct printer. */
void printer_listen(void *printer, const c205 *machine, const c205_event *event);

#endif
