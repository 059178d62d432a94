/* text_shrink.c - removes lines and blocks from a failing text (solid_text.h). */

#include "tests/oracle/solid_text.h"

#include <stdlib.h>
#include <string.h>

static size_t count_lines(const char *text)
{
    size_t count = 0;
    for (; *text; text++)
        count += *text == '\n';
    return count;
}

static const char *next_line(const char *line)
{
    const char *end = strchr(line, '\n');
    return end ? end + 1 : line + strlen(line);
}

/* Returns the change of the nesting depth in a directive. */
static int opened_by(const char *word)
{
    static const char *const openers[] = { "#if",  "#ifdef",  "#ifndef", "#while",
                                           "#for", "#switch", "#macro" };
    size_t length = 1 + strspn(word + 1, "abcdefghijklmnopqrstuvwxyz");
    if (length == 4 && strncmp(word, "#end", 4) == 0)
        return -1;
    for (size_t i = 0; i < sizeof openers / sizeof *openers; i++)
        if (strlen(openers[i]) == length && strncmp(word, openers[i], length) == 0)
            return 1;
    return 0;
}

/* Returns the change of the nesting depth in a line. */
static int opened(const char *line)
{
    int open = 0;
    for (; *line && *line != '\n'; line++)
        if (*line == '#')
            open += opened_by(line);
        else
            open += (*line == '{') - (*line == '}');
    return open;
}

/* Returns the line that closes the block of this line, or the line itself. */
static const char *last_line(const char *line)
{
    int open = opened(line);
    while (open > 0 && *next_line(line)) {
        line = next_line(line);
        open += opened(line);
    }
    return line;
}

/* Returns the text without line `number`, counted from 0. If this line opens a block,
 * the whole block is removed or, if `kept` is true, only its first and last line.
 * Returns NULL if there is no such line, or if `kept` is true and it opens no block. */
static char *text_without(const char *text, size_t number, bool kept)
{
    const char *first = text;
    for (; number > 0 && *first; number--)
        first = next_line(first);
    if (!*first || opened(first) < 0 || (kept && opened(first) == 0))
        return NULL;
    const char *last = last_line(first);
    char *less = test_room(strlen(text) + 1);
    strncat(less, text, (size_t)(first - text));
    if (kept)
        strncat(less, next_line(first), (size_t)(last - next_line(first)));
    strcat(less, next_line(last));
    return less;
}

char *text_shrunk(char *text, size_t most,
                  bool (*fails)(const char *text, void *context), void *context)
{
    size_t trials = 0;
    for (bool smaller = true; smaller && trials < most;) {
        smaller = false;
        for (size_t i = 1; i < count_lines(text) && trials < most; trials++) {
            bool less = false;
            for (int kept = 0; kept < 2 && !less; kept++) {
                char *part = text_without(text, i, kept);
                less = part && fails(part, context);
                free(less ? text : part);
                text = less ? part : text;
            }
            smaller |= less;
            i += !less;
        }
    }
    return text;
}

char *text_indented(char *text)
{
    char *words;
    FILE *indented = test_text(&words);
    int depth = 0;
    for (const char *line = text; *line; line = next_line(line)) {
        int change = opened(line);
        fprintf(indented, "%*s%.*s", 4 * (change < 0 ? depth + change : depth), "",
                (int)(next_line(line) - line), line);
        depth += change;
    }
    fclose(indented);
    free(text);
    return words;
}
