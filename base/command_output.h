/* command_output.h - the destinations of the results of a command.
 *
 * A command outputs each result once, as a table or a line of text. It goes to stdout
 * in the format that the user chose, and also to a JSON file if the user requested it.
 * The formats are text, CSV (in which other lines begin with "# "), Markdown, and JSON.
 * Results go to stderr if the command writes another file to stdout ("-").
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
#include "vm/error.h"

enum output_format {
    OUTPUT_TEXT = TABLE_PLAIN,
    OUTPUT_CSV = TABLE_CSV,
    OUTPUT_MARKDOWN = TABLE_MARKDOWN,
    OUTPUT_JSON
};

struct command_output {
    enum output_format format;
    const char *path; /* path of the JSON file, or NULL */
    bool provenance;  /* print the full provenance of models */

    const char *command; /* for error messages */
    FILE *file;          /* destination of printed results; NULL: none */
    struct json *json;   /* the JSON document; NULL: none */
};

/* The values of the option --format, and the output options of a command. member is the
 * struct command_output in its arguments. */
command_choice output_format_choice;
/* clang-format off */
#define OUTPUT_OPTIONS(arguments, member) \
    { .name = "format", .value = "FORMAT", .kind = COMMAND_CHOICE, \
      .offset = offsetof(arguments, member.format), \
      .choice = output_format_choice, \
      .help = "format of the results on stdout" }, \
    { .name = "json", .value = "FILE", .kind = COMMAND_OUTPUT, \
      .offset = offsetof(arguments, member.path), \
      .help = "also write the results to a file; with -: print only JSON" }
/* The option --provenance, for commands that print results of a machine model. */
#define OUTPUT_OPTION_PROVENANCE(arguments, member) \
    { .name = "provenance", .kind = COMMAND_FLAG, \
      .offset = offsetof(arguments, member.provenance), \
      .help = "print the sources and known errors of the model" }
/* clang-format on */

/* Opens the output. The format and the path must be set, and all other members zero.
 * output is another file that the command writes, or NULL. Returns false after an error
 * message. */
bool output_open(struct command_output *results, const char *command,
                 const char *output);
/* Commits the JSON file if code is CMD_DONE, and discards it otherwise. Returns the
 * code, or CMD_FAILED after an error message if the JSON cannot be written. */
int output_close(struct command_output *results, int code);

/* Returns the format in which tables are printed, by the option --format. */
enum table_format output_table_format(const struct command_output *results);
/* Prints lines, each with its newline. They have at most 1023 characters in total. */
void output_printf(const struct command_output *results, const char *format, ...)
    PRINTF_FORMAT(2, 3);
/* Prints a blank line in text format. Other formats have headings instead. */
void output_gap(const struct command_output *results);
/* Prints the model of the results: one line, or its full provenance with the option
 * --provenance. JSON always has the full provenance (provenance_json). */
void output_model(const struct command_output *results, const c205_model *model);
/* Prints a table and adds it to the JSON under its key. All formats except text print
 * the heading. Returns false if the host is out of memory, or if the table is NULL or
 * incomplete for lack of memory. */
bool output_table(const struct command_output *results, const struct table *table,
                  const char *key, const char *heading);
/* Like output_table, but frees the table, and prints the heading in text format, too.
 * The heading has no colon. */
bool output_part(const struct command_output *results, struct table *table,
                 const char *key, const char *heading);
/* Like output_table, but frees the table, and returns CMD_DONE, or CMD_FAILED after an
 * error message if the host is out of memory. */
int output_show(const struct command_output *results, struct table *table,
                const char *key, const char *heading);

#endif
