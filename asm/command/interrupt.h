/* interrupt.h - Ctrl-C as a question that a command asks now and then. */
#ifndef ASM_INTERRUPT_H
#define ASM_INTERRUPT_H

#include <stdbool.h>

/* From now on Ctrl-C does not end the command. */
void interrupt_catch(void);
/* It was pressed. */
bool interrupt_came(void);

#endif
