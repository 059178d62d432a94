/* command_output.h - where the results of a command go.
 *
 * A command tells each result once, as a table or a line of text.  It goes to
 * stdout in the format that the user chose, and to a JSON file as well if
 * there is to be one: as text; tables as CSV, other lines behind "# "; tables
 * as Markdown; or nothing but the JSON document.  Where stdout is taken by a
 * file that the command writes ("-"), the rest goes to stderr.
 *
 *   struct command_output results = arguments->results;
 *   if (output_open(&results, "c205 model", NULL)) {
 *       output_printf(&results, "%zu models\n", count);
 *       code = output_table(&results, table, "models", NULL) ? ...
 *       code = output_close(&results, code);
 *   }
 */
#ifndef BASE_COMMAND_OUTPUT_H
#define BASE_COMMAND_OUTPUT_H

#include "base/command.h"
#include "base/json.h"
#include "base/table.h"

enum output_format {
    OUTPUT_TEXT = TABLE_PLAIN,
    OUTPUT_CSV = TABLE_CSV,
    OUTPUT_MARKDOWN = TABLE_MARKDOWN,
    OUTPUT_JSON
};

struct command_output {
    enum output_format format;
    const char *path; /* of the JSON file, or NULL */
    bool provenance;  /* of models, the whole of it is printed */

    const char *command; /* for complaints */
    FILE *file;          /* what is printed; NULL: nothing, but .. */
    struct json *json;   /* .. this; NULL: nobody wants it */
};

/* The options of a command whose arguments hold results there. */
command_choice output_format_choice;
/* clang-format off */
#define OUTPUT_OPTIONS(arguments, member) \
    { .name = "format", .value = "FORMAT", .kind = COMMAND_CHOICE, \
      .offset = offsetof(arguments, member.format), \
      .choice = output_format_choice, \
      .help = "how results are written on stdout" }, \
    { .name = "json", .value = "FILE", .kind = COMMAND_OUTPUT, \
      .offset = offsetof(arguments, member.path), \
      .help = "write the results to a file as well; on stdout: alone" }
/* .. of one that prints figures of a model. */
#define OUTPUT_OPTION_PROVENANCE(arguments, member) \
    { .name = "provenance", .kind = COMMAND_FLAG, \
      .offset = offsetof(arguments, member.provenance), \
      .help = "how far the figures can be trusted, and why" }
/* clang-format on */

/* The format and the path are set, the rest is zero.  The output is another
 * file that the command writes, or NULL.  False after telling why it cannot
 * be. */
bool output_open(struct command_output *results, const char *command,
                 const char *output);
/* Keeps the JSON if code is CMD_DONE, drops it otherwise.  The code, or
 * CMD_FAILED after telling why it cannot be kept. */
int output_close(struct command_output *results, int code);

/* The format of what is printed. */
enum table_format output_table_format(const struct command_output *results);
/* Lines of at most 1023 characters together, each with its end. */
void output_printf(const struct command_output *results, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;
/* A blank line of text: to tables of other formats, a heading belongs. */
void output_gap(const struct command_output *results);
/* Of which model the figures are, printed: a line; or with the option
 * provenance all of how far they can be trusted.  (JSON has that in any case:
 * provenance_json.) */
void output_model(const struct command_output *results, const c205_model *model);
/* Print a table, and add it to the JSON under its key; the heading stands
 * above it where it is not text.  False: memory ran out, now or while it was
 * filled; the table may be NULL then. */
bool output_table(const struct command_output *results, const struct table *table,
                  const char *key, const char *heading);
/* The same with the heading in text, too: "Heading" without a colon. */
bool output_part(const struct command_output *results, const struct table *table,
                 const char *key, const char *heading);
/* The same with a table that nobody needs after that: it is freed.  CMD_DONE, or
 * CMD_FAILED after telling that memory ran out. */
int output_show(const struct command_output *results, struct table *table,
                const char *key, const char *heading);

#endif
