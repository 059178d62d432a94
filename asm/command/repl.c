/* repl.c - executes the lines of a terminal, a pipe or scripts in a debugger. */
#include "asm/command/repl.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "asm/command/line_editor.h"
#include "base/interrupt.h"

struct repl {
    const struct repl_setup *setup;
    struct debugger *debugger;
    bool quit, terminal, interrupted;
};

/* An interruption by Ctrl-C applies to one movement, so it is
 * cleared after each line. */
static void note_interrupt(struct repl *dialogue)
{
    dialogue->interrupted |= interrupt_pending();
    interrupt_clear();
}

/* Executes all lines of a file. Lines that are not typed on a terminal are printed
 * after a prompt. Returns the reason of a read error, or NULL. */
static const char *obey_all(struct repl *dialogue, FILE *file)
{
    const char *prompt = dialogue->setup->prompt;
    struct typed_lines lines = typed_lines_of(file, dialogue->setup->verb);
    const char *line, *fault;
    interrupt_catch_lines(lines.terminal);
    while (!dialogue->quit && !interrupt_ends()
           && (line = typed_lines_next(&lines, prompt)) != NULL) {
        if (!lines.terminal) {
            cmd_print_line(stdout, "%s%s", prompt, line);
        }
        note_interrupt(dialogue);
        dialogue->quit = !debugger_obey(dialogue->debugger, line);
        note_interrupt(dialogue);
    }
    dialogue->terminal |= lines.terminal;
    if (lines.terminal && !dialogue->quit) {
        putchar('\n');
    }
    fault = lines.stream.fault;
    typed_lines_free(&lines);
    return fault;
}

static const char *obey_script(struct repl *dialogue, const char *path)
{
    FILE *file = strcmp(path, "-") == 0 ? stdin : fopen(path, "r");
    const char *fault = file ? obey_all(dialogue, file) : strerror(errno);
    if (file && file != stdin) {
        fclose(file);
    }
    return fault;
}

static bool is_good(const struct repl *dialogue)
{
    return dialogue->terminal
           || (!dialogue->interrupted && debugger_faults(dialogue->debugger) == 0);
}

int repl_hold(const struct repl_setup *setup, struct debugger *debugger)
{
    const struct command_texts *scripts = setup->scripts;
    struct repl dialogue = { .setup = setup, .debugger = debugger };
    const char *fault = NULL, *unread = "stdin";
    interrupt_catch();
    debugger_greet(debugger);
    if (scripts->count == 0) {
        fault = obey_all(&dialogue, stdin);
    }
    for (size_t i = 0; i < scripts->count && !dialogue.quit && !fault; i++) {
        unread = scripts->items[i];
        fault = obey_script(&dialogue, unread);
    }
    if (interrupt_ends()) {
        return cmd_failed(setup->command, "interrupted");
    }
    if (fault) {
        return cmd_failed(setup->command, "%s cannot be read: %s", unread, fault);
    }
    return is_good(&dialogue) ? CMD_DONE : CMD_FAILED;
}

bool repl_interrupted(void *asked)
{
    (void)asked;
    return interrupt_pending();
}
