/* cmd_shared.c - the functions that several commands of rt205 share. */
#include "rt/command/rt205_command.h"

#include "base/interrupt.h"
#include "base/named_model.h"
#include "rt/picture/picture.h"
#include "rt/platform/processors.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>

/* If only the picture is missing, the other results are kept. */
static int work_and_close(const struct rt205_arguments *arguments,
                          struct command_output *results, cmd_work *work)
{
    int code = work(arguments, results);
    int kept = output_close(results, code == CMD_UNDRAWN ? CMD_DONE : code);

    return code == CMD_UNDRAWN ? CMD_FAILED : kept;
}

static int open_and_work(struct rt205_arguments *arguments, cmd_work *work)
{
    struct command_output results = arguments->results;

    if (c205_model_is_projection(arguments->trace.model))
        return cmd_failed(arguments->command,
                          "%s is a projection and cannot run programs",
                          c205_model_name(arguments->trace.model));
    if (!output_open(&results, arguments->command, arguments->output))
        return CMD_FAILED;
    cmd_watch(arguments);
    return work_and_close(arguments, &results, work);
}

int cmd_with_machine(struct rt205_arguments *arguments, cmd_work *work)
{
    const struct trace_options *trace = &arguments->trace;
    c205_model *model;
    int code;

    if (trace->height > 0 && trace->width > MAX_TRACE_PIXELS / trace->height)
        return cmd_usage(arguments->command, "at most %zu pixels are allowed",
                         MAX_TRACE_PIXELS);
    if (trace->threshold > 0 && trace->samples < 2)
        return cmd_usage(arguments->command,
                         "--threshold requires --samples 2 or more");
    model = model_open(arguments->command, arguments->model);
    if (!model)
        return CMD_FAILED;
    arguments->trace.model = model;
    arguments->trace.jobs = jobs_wanted(arguments->trace.jobs, MAX_TRACE_JOBS);
    code = open_and_work(arguments, work);
    c205_model_free(model);
    return code;
}

static bool go_on(void *context)
{
    (void)context;
    return !interrupt_pending();
}

/* Reports a scene without objects, since a picture of the background is hardly
 * intended. Returns false if that is an error. */
static bool check_objects(const struct rt205_arguments *arguments,
                          const struct scene *scene)
{
    if (scene->primitive_count > 0)
        return true;
    cmd_print_line(stderr,
                   "%s: %s: the scene has no objects: every pixel is "
                   "background",
                   arguments->scene, arguments->strict ? "error" : "warning");
    return !arguments->strict;
}

struct scene *cmd_read_scene(const struct rt205_arguments *arguments)
{
    struct scene_options options = {
        .width = (int)arguments->trace.width,
        .height = (int)arguments->trace.height,
        .strict = arguments->strict,
        .search = arguments->search.items,
        .go_on = go_on,
        .read_raster = picture_read_raster,
    };
    struct diagnostics reports = { 0 };
    struct scene *scene = scene_read(arguments->scene, &options, &reports);

    diagnostics_print(&reports, stderr);
    diagnostics_free(&reports);
    if (scene && !check_objects(arguments, scene)) {
        scene_free(scene);
        return NULL;
    }
    return scene;
}

int cmd_with_scene(const struct rt205_arguments *arguments,
                   const struct command_output *results, cmd_scene_function *function)
{
    struct scene *scene = cmd_read_scene(arguments);
    c205_error error = { "" };
    bool good;

    if (!scene)
        return CMD_FAILED;
    good = function(arguments, scene, results, &error);
    scene_free(scene);
    return good ? CMD_DONE : cmd_failed(arguments->command, "%s", error.message);
}

int cmd_check_picture(const struct rt205_arguments *arguments)
{
    struct picture_error why;

    if (!arguments->output || picture_check_path(arguments->output, &why))
        return CMD_DONE;
    return picture_is_named(arguments->output)
               ? cmd_failed(arguments->command, "%s", why.message)
               : cmd_usage(arguments->command, "%s", why.message);
}

bool cmd_take_pixel(char *text, void *pixel)
{
    struct cmd_pixel *taken = pixel;
    char *end;

    if (!isdigit((unsigned char)*text))
        return false;
    taken->x = strtoul(text, &end, 10);
    if (*end != ',' || !isdigit((unsigned char)end[1]))
        return false;
    taken->y = strtoul(end + 1, &end, 10);
    taken->given = true;
    return *end == '\0';
}

int cmd_check_pixel(const struct rt205_arguments *arguments)
{
    const struct cmd_pixel *pixel = &arguments->pixel;
    const struct trace_options *trace = &arguments->trace;

    if (!pixel->given || (pixel->x < trace->width && pixel->y < trace->height))
        return CMD_DONE;
    return cmd_usage(arguments->command,
                     "pixel %zu,%zu is outside of the frame of %zu x %zu pixels",
                     pixel->x, pixel->y, trace->width, trace->height);
}

/* ---- Names of the choices of options ------------------------------------- */

const char *cmd_mode_choice(size_t number)
{
    return number < TRACE_MODES ? trace_mode_name((enum trace_mode)number) : NULL;
}

const char *cmd_form_choice(size_t number)
{
    return number < TRACE_FORMS ? cmd_mode_choice(number) : NULL;
}

const char *cmd_visible_choice(size_t number)
{
    return number < CSG_METHODS ? visible_name((enum visible)number) : NULL;
}

const char *cmd_order_choice(size_t number)
{
    return number < ORDERS ? order_name((enum trace_order)number) : NULL;
}
