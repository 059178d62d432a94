/* arguments.c - parses and checks the arguments that several commands of rt205
 * share. */
#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/plural.h"
#include "rt/command/session.h"
#include "rt/picture/picture.h"

/* Reads a number, which consists only of digits. Returns the text after it, or NULL. */
static const char *read_digits(const char *text, size_t *number)
{
    char *end;
    *number = strtoul(text, &end, 10);
    return isdigit((unsigned char)*text) ? end : NULL;
}

/* ---- Shares -------------------------------------------------------------- */

bool cmd_is_part(const char *text, struct job_set *job_set)
{
    errno = 0;
    text = read_digits(text, &job_set->part);
    if (!text || *text != '/')
        return false;
    text = read_digits(text + 1, &job_set->parts);
    return text && !*text && errno == 0 && job_set->part > 0
           && job_set->part <= job_set->parts;
}

bool cmd_take_part(char *text, void *job_set)
{
    return cmd_is_part(text, job_set);
}

int cmd_print_share(const char *command, const struct job_set *job_set, size_t units)
{
    if (job_set->file)
        cmd_print_line(stderr, "%s: part %zu of %zu is done: %s has %zu of %zu unit%s",
                       command, job_set->part, job_set->parts, job_set->paths[0],
                       checkpoint_count(job_set->file), units, plural(units));
    return CMD_DONE;
}

/* ---- Pictures and pixels ------------------------------------------------- */

int cmd_check_picture(const struct trace_arguments *shared)
{
    c205_error why;
    if (!shared->output || picture_check_path(shared->output, &why))
        return CMD_DONE;
    return picture_is_named(shared->output)
               ? cmd_failed(shared->command, "%s", why.message)
               : cmd_usage(shared->command, "%s", why.message);
}

bool cmd_take_pixel(char *text, void *value)
{
    struct pixel_arguments *pixel = value;
    const char *end = read_digits(text, &pixel->x);
    if (!end || *end != ',')
        return false;
    end = read_digits(end + 1, &pixel->y);
    pixel->given = true;
    return end && *end == '\0';
}

int cmd_check_pixel(const struct trace_arguments *shared,
                    const struct pixel_arguments *pixel)
{
    const struct trace_options *trace = &shared->trace;
    if (!pixel->given || (pixel->x < trace->width && pixel->y < trace->height))
        return CMD_DONE;
    return cmd_usage(shared->command,
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
