#include "base/interrupt.h"

/* WebAssembly's system interface has no signals. */
#ifdef __wasi__

void interrupt_catch(void)
{
}

bool interrupt_came(void)
{
    return false;
}

void interrupt_forget(void)
{
}

#else

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t came;

/* The second time it is as if nobody had asked for the first. */
static void note(int number)
{
    if (came) {
        signal(number, SIG_DFL);
        raise(number);
    }
    came = 1;
}

void interrupt_catch(void)
{
    struct sigaction action = { .sa_handler = note };
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

bool interrupt_came(void)
{
    return came;
}

void interrupt_forget(void)
{
    came = 0;
}

#endif
