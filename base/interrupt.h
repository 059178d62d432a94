/* interrupt.h - Ctrl-C as a question that a command asks now and then. */
#ifndef BASE_INTERRUPT_H
#define BASE_INTERRUPT_H

#include <stdbool.h>

/* From now on Ctrl-C (or SIGTERM) does not end the program, but the second one
 * does. */
void interrupt_catch(void);
/* It was pressed. */
bool interrupt_came(void);
/* It counts as not pressed yet. */
void interrupt_forget(void);

#endif
