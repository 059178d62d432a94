/* polynomials.c - reads polynomials from a file. */
#include "rt/roots/polynomials.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

#include "base/diagnostic.h"
#include "base/text_file.h"

enum { COEFFICIENTS = 5, COLUMNS = 6 };

static const char *const headings[COLUMNS] = { "c4", "c3", "c2", "c1", "c0", "bound" };

/* The state while a line is read. */
struct polynomial_line {
    const char *file;
    size_t number;
    const char *text, *end, *at;
    struct diagnostics *reports;
};

static bool bad(struct polynomial_line *line, const char *at, const char *message)
{
    const struct position position = {
        .file = line->file,
        .line = line->number,
        .column = (size_t)(at - line->text) + 1,
        .source = line->text,
        .source_length = (size_t)(line->end - line->text),
    };
    diagnostics_add(line->reports, SEVERITY_ERROR, &position, message);
    return false;
}

static bool failed(struct diagnostics *reports, const char *path, const char *message)
{
    const struct position position = { .file = path };
    diagnostics_add(reports, SEVERITY_ERROR, &position, message);
    return false;
}

static void skip_blanks(struct polynomial_line *line)
{
    while (line->at < line->end && (*line->at == ' ' || *line->at == '\t'))
        line->at++;
}

static bool at_comma_or_end(const struct polynomial_line *line)
{
    return line->at == line->end || *line->at == ',';
}

/* Returns true if a number has a digit other than 0 before its exponent. */
static bool has_value(const char *text, const char *end)
{
    bool hexadecimal = memchr(text, 'x', (size_t)(end - text)) != NULL
                       || memchr(text, 'X', (size_t)(end - text)) != NULL;
    const char *digits = hexadecimal ? "123456789abcdefABCDEF" : "123456789";
    const char *exponent = hexadecimal ? "pP" : "eE";
    for (; text < end && !strchr(exponent, *text); text++)
        if (strchr(digits, *text))
            return true;
    return false;
}

static bool take_number(struct polynomial_line *line, c205_word *word)
{
    const char *begin, *end;
    skip_blanks(line);
    begin = line->at;
    if (at_comma_or_end(line))
        return bad(line, begin, "expected a number");
    *word = c205_from_text(begin, &end);
    if (end == begin || end > line->end)
        return bad(line, begin, "expected a number");
    line->at = end;
    skip_blanks(line);
    if (!at_comma_or_end(line))
        return bad(line, line->at, "expected a comma");
    if (*word == C205_INDEFINITE)
        return bad(line, begin,
                   "larger than the machine's numbers, which end at 9.5e8644");
    if (*word == C205_MACHINE_ZERO && has_value(begin, end))
        return bad(line, begin,
                   "smaller than the machine's numbers, which begin at 5.2e-8618");
    return true;
}

static bool take_comma(struct polynomial_line *line)
{
    if (line->at == line->end)
        return bad(line, line->at,
                   "expected a comma: a line has c4,c3,c2,c1,c0 and an optional bound");
    line->at++;
    return true;
}

static bool take_bound(struct polynomial_line *line, c205_word *bound)
{
    *bound = C205_MACHINE_ZERO;
    if (line->at == line->end)
        return true;
    line->at++;
    skip_blanks(line);
    if (line->at == line->end)
        return true;
    if (!take_number(line, bound))
        return false;
    return line->at == line->end || bad(line, line->at, "more than six numbers");
}

static bool take_polynomial(struct polynomial_line *line, struct polynomial *polynomial)
{
    for (int i = 0; i < COEFFICIENTS; i++)
        if ((i > 0 && !take_comma(line)) || !take_number(line, &polynomial->c[i]))
            return false;
    return take_bound(line, &polynomial->bound);
}

/* Returns true if the line contains the names of the columns. */
static bool is_heading(struct polynomial_line line)
{
    for (int i = 0; i < COLUMNS; i++) {
        size_t length = strlen(headings[i]);
        skip_blanks(&line);
        if ((size_t)(line.end - line.at) < length
            || memcmp(line.at, headings[i], length) != 0)
            return false;
        line.at += length;
        skip_blanks(&line);
        if (line.at == line.end)
            return i >= COEFFICIENTS - 1;
        if (*line.at++ != ',')
            return false;
    }
    return false;
}

static bool add_polynomial(struct polynomials *polynomials, size_t line,
                           const struct polynomial *polynomial)
{
    size_t n = polynomials->count;
    return array_add(&polynomials->lines, &n, &line, sizeof line)
           && array_add(&polynomials->items, &polynomials->count, polynomial,
                        sizeof *polynomial);
}

/* Sets `line` to the line that begins at `text`, without its line end. Returns the
 * start of the next line. */
static const char *cut_line(struct polynomial_line *line, const char *text,
                            const char *end)
{
    const char *newline = memchr(text, '\n', (size_t)(end - text));
    line->number++;
    line->text = line->at = text;
    line->end = newline ? newline : end;
    while (line->end > text && strchr(" \t", line->end[-1]))
        line->end--;
    skip_blanks(line);
    return newline ? newline + 1 : end;
}

static bool read_lines(struct polynomials *polynomials, const char *path,
                       const char *text, size_t length, struct diagnostics *reports)
{
    struct polynomial_line line = { .file = path, .reports = reports };
    const char *end = text + length;
    bool first = true;
    while (text < end) {
        struct polynomial polynomial;
        text = cut_line(&line, text, end);
        if (line.at == line.end || *line.at == '#')
            continue;
        if (!(first && is_heading(line)) && take_polynomial(&line, &polynomial)
            && !add_polynomial(polynomials, line.number, &polynomial))
            return failed(reports, path, "out of memory");
        first = false;
    }
    return reports->errors == 0;
}

bool polynomials_read(struct polynomials *polynomials, const char *path,
                      struct diagnostics *reports)
{
    c205_error error;
    size_t length;
    char *text = text_file_read(path, FILE_LARGEST, &length, &error);
    bool good;
    if (!text)
        return failed(reports, path, error.message);
    good = read_lines(polynomials, path, text, length, reports);
    free(text);
    return good;
}

void polynomials_free(struct polynomials *polynomials)
{
    free(polynomials->items);
    free(polynomials->lines);
    memset(polynomials, 0, sizeof *polynomials);
}
