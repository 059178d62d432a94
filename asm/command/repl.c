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

/* Clears an interruption after each line, because Ctrl-C applies to one execution
 * command. */
static void note_interrupt(struct repl *repl)
{
    repl->interrupted |= interrupt_pending();
    interrupt_clear();
}

/* Executes all lines of a file. Lines that do not come from a terminal are printed
 * after a prompt. Returns the reason of a read error, or NULL. */
static const char *obey_all(struct repl *repl, FILE *file)
{
    const char *prompt = repl->setup->prompt;
    struct typed_lines lines = typed_lines_of(file, repl->setup->verb);
    const char *line, *fault;
    interrupt_catch_lines(lines.terminal);
    while (!repl->quit && !interrupt_ends()
           && (line = typed_lines_next(&lines, prompt)) != NULL) {
        if (!lines.terminal)
            cmd_print_line(stdout, "%s%s", prompt, line);
        note_interrupt(repl);
        repl->quit = !debugger_obey(repl->debugger, line);
        note_interrupt(repl);
    }
    repl->terminal |= lines.terminal;
    if (lines.terminal && !repl->quit)
        putchar('\n');
    fault = lines.stream.fault;
    typed_lines_free(&lines);
    return fault;
}

static const char *obey_script(struct repl *repl, const char *path)
{
    FILE *file = strcmp(path, "-") == 0 ? stdin : fopen(path, "r");
    const char *fault = file ? obey_all(repl, file) : strerror(errno);
    if (file && file != stdin)
        fclose(file);
    return fault;
}

static bool is_good(const struct repl *repl)
{
    return repl->terminal
           || (!repl->interrupted && debugger_faults(repl->debugger) == 0);
}

static int run_lines(const struct repl_setup *setup, struct debugger *debugger)
{
    const struct command_texts *scripts = setup->scripts;
    struct repl repl = { .setup = setup, .debugger = debugger };
    const char *fault = NULL, *unread = "stdin";
    interrupt_catch();
    debugger_greet(debugger);
    if (scripts->count == 0)
        fault = obey_all(&repl, stdin);
    for (size_t i = 0; i < scripts->count && !repl.quit && !fault; i++) {
        unread = scripts->items[i];
        fault = obey_script(&repl, unread);
    }
    if (interrupt_ends())
        return cmd_failed(setup->command, "interrupted");
    if (fault)
        return cmd_failed(setup->command, "cannot read %s: %s", unread, fault);
    return is_good(&repl) ? CMD_DONE : CMD_FAILED;
}

int repl_run(const struct repl_setup *setup, const struct debugger_setup *of_debugger)
{
    c205_error error;
    struct debugger *debugger = debugger_new(of_debugger, &error);
    if (!debugger)
        return cmd_failed(setup->command, "%s", error.message);
    int code = run_lines(setup, debugger);
    debugger_free(debugger);
    return code;
}

bool repl_interrupted(void *asked)
{
    (void)asked;
    return interrupt_pending();
}
