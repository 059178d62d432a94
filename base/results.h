/* results.h - where the results of a command go.
 *
 * A command tells each result once, as a table or a line of text.  It goes to
 * stdout in the format that the user chose, and to a JSON file as well if
 * there is to be one: as text; tables as CSV, other lines behind "# "; tables
 * as Markdown; or nothing but the JSON document.  Where stdout is taken by a
 * file that the command writes ("-"), the rest goes to stderr.
 *
 *   struct results results = arguments->results;
 *   if (results_open(&results, "c205 model", NULL)) {
 *       results_say(&results, "%zu models\n", count);
 *       code = results_table(&results, table, "models", NULL) ? ...
 *       code = results_close(&results, code);
 *   }
 */
#ifndef BASE_RESULTS_H
#define BASE_RESULTS_H

#include "base/command.h"
#include "base/json.h"
#include "base/table.h"

enum results_format {
    RESULTS_TEXT = TABLE_PLAIN,
    RESULTS_CSV = TABLE_CSV,
    RESULTS_MARKDOWN = TABLE_MARKDOWN,
    RESULTS_JSON
};

struct results {
    enum results_format format;
    const char *path; /* of the JSON file, or NULL */
    bool provenance;  /* of models, the whole of it is printed */

    const char *command; /* for complaints */
    FILE *file;          /* what is printed; NULL: nothing, but .. */
    struct json *json;   /* .. this; NULL: nobody wants it */
};

/* The options of a command whose arguments hold results there. */
command_choice results_format_choice;
/* clang-format off */
#define RESULTS_OPTIONS(arguments, member) \
    { .name = "format", .value = "FORMAT", .kind = COMMAND_CHOICE, \
      .offset = offsetof(arguments, member.format), \
      .choice = results_format_choice, \
      .help = "how results are written on stdout" }, \
    { .name = "json", .value = "FILE", .kind = COMMAND_OUTPUT, \
      .offset = offsetof(arguments, member.path), \
      .help = "write the results to a file as well; on stdout: alone" }
/* .. of one that prints figures of a model. */
#define RESULTS_OPTION_PROVENANCE(arguments, member) \
    { .name = "provenance", .kind = COMMAND_FLAG, \
      .offset = offsetof(arguments, member.provenance), \
      .help = "how far the figures can be trusted, and why" }
/* clang-format on */

/* The format and the path are set, the rest is zero.  The output is another
 * file that the command writes, or NULL.  False after telling why it cannot
 * be. */
bool results_open(struct results *results, const char *command, const char *output);
/* Keeps the JSON if code is CMD_DONE, drops it otherwise.  The code, or
 * CMD_FAILED after telling why it cannot be kept. */
int results_close(struct results *results, int code);

/* The format of what is printed. */
enum table_format results_table_format(const struct results *results);
/* Lines of at most 1023 characters together, each with its end. */
void results_say(const struct results *results, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;
/* A blank line of text: to tables of other formats, a heading belongs. */
void results_gap(const struct results *results);
/* Of which model the figures are, printed: a line; or with the option
 * provenance all of how far they can be trusted.  (JSON has that in any case:
 * provenance_json.) */
void results_model(const struct results *results, const c205_model *model);
/* Print a table, and add it to the JSON under its key; the heading stands
 * above it where it is not text.  False: memory ran out, now or while it was
 * filled; the table may be NULL then. */
bool results_table(const struct results *results, const struct table *table,
                   const char *key, const char *heading);
/* The same with the heading in text, too: "Heading" without a colon. */
bool results_part(const struct results *results, const struct table *table,
                  const char *key, const char *heading);
/* The same with a table that nobody needs after that: it is freed.  CMD_DONE, or
 * CMD_FAILED after telling that memory ran out. */
int results_show(const struct results *results, struct table *table, const char *key,
                 const char *heading);

#endif
