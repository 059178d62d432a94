/* cmd_render_debug.c - rt205 render --debug: debugs the program of a frame, in the
 * band that contains a pixel. */
#include "asm/command/repl.h"
#include "rt/command/rt205_command.h"
#include "rt/trace/form.h"
#include "rt/view/pixel_verbs.h"

static int debug(const struct rt205_arguments *arguments, struct frame_pixel *pixel)
{
    const struct debugger_setup setup = { .object = trace_program(pixel->trace),
                                          .name = form_program(arguments->trace.mode),
                                          .model = arguments->trace.model,
                                          .out = visible_stream(stdout),
                                          .printed = stream_sink(stdout),
                                          .clocks_most = C205_NO_LIMIT,
                                          .interrupted = repl_interrupted,
                                          .machine = pixel_machine,
                                          .verbs = pixel_verbs,
                                          .context = pixel };
    const struct repl_setup repl = { .command = arguments->command,
                                     .prompt = "(rt205) ",
                                     .verb = pixel_verb,
                                     .scripts = &arguments->scripts };
    c205_error error;
    struct debugger *debugger = debugger_new(&setup, &error);
    int code;

    if (!debugger)
        return cmd_failed(arguments->command, "%s", error.message);
    code = repl_hold(&repl, debugger);
    debugger_free(debugger);
    return code;
}

int cmd_debug_pixel(const struct rt205_arguments *arguments,
                    const struct command_output *results)
{
    struct scene *scene = cmd_read_scene(arguments);
    c205_error error = { "out of memory" };
    struct trace *trace;
    struct frame_pixel pixel;
    int code;

    (void)results;
    if (!scene)
        return CMD_FAILED;
    trace = trace_new(scene, &arguments->trace, &error);
    code = trace
                   && frame_pixel_find(&pixel, trace, arguments->pixel.x,
                                       arguments->pixel.y, &error)
               ? debug(arguments, &pixel)
               : cmd_failed(arguments->command, "%s", error.message);
    trace_free(trace);
    scene_free(scene);
    return code;
}
