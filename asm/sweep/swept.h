/* swept.h - runs one or two programs for many values of a constant.
 *
 * A program is assembled for each value and run to its end. All figures of a point come
 * from the accounts of the machine. A line is fitted to the points of each program. A
 * sweep of two programs also finds the values at which the faster program changes.
 */
#ifndef ASM_SWEPT_H
#define ASM_SWEPT_H

#include "asm/measure/straight_line.h"
#include "asm/text/assemble.h"
#include "base/table.h"
#include "vm/c205.h"

/* ---- Values ---------------------------------------------------------------- */

enum { MAX_SWEPT_POINTS = 1000 };
/* The largest integer in the low 48 bits of a word. */
#define SWEPT_LARGEST ((UINT64_C(1) << 47) - 1)

/* A range of values, 1 <= from < to. It contains all integers unless it has a step or a
 * factor. */
struct swept_range {
    uint64_t from, to;
    uint64_t step;   /* 0: none */
    uint64_t factor; /* 0: none */
};

/* Parses a range such as "8:65535", "8:65535:8" or "8:65535:x2". Returns false for any
 * other text. */
bool swept_take_range(const char *text, struct swept_range *range);
/* Computes the values of a range. A range with a step or factor has all of its values.
 * Another range has at most `points` values, including both ends, in a constant ratio
 * except for rounding. If points is 0, there are 8 values per octave, but at most 25.
 * Returns the number of values, or 0 if it would exceed MAX_SWEPT_POINTS. */
size_t swept_values(const struct swept_range *range, size_t points,
                    uint64_t values[MAX_SWEPT_POINTS]);

/* ---- Runs ------------------------------------------------------------------ */

enum { MAX_SWEPT_DEFINES = 100, SWEPT_HEADING = 64 };
enum { SWEPT_FIRST, SWEPT_SECOND, SWEPT_PROGRAMS };

struct swept_point {
    uint64_t value;
    c205_account runs[SWEPT_PROGRAMS]; /* sum over all regions */
};

/* A value of the constant at which the other program becomes the faster one. `faster`
 * is true if it is the second program. */
struct swept_crossing {
    struct swept_point at;
    bool faster;
};

struct program_sweep {
    /* The input, set by the caller. */
    const char *constant;
    struct swept_range range;
    size_t asked; /* requested number of points; 0: the default */
    struct swept_program {
        const char *path, *text;
        size_t length;
    } programs[SWEPT_PROGRAMS];
    size_t program_count;
    const c205_model *model;
    const struct asm_options *options; /* the constant of the sweep is added to its
                                          constants, at most MAX_SWEPT_DEFINES */
    /* warm: all pages are in memory at the start. cold: no page is. If both are false,
     * the program determines it. */
    bool warm, cold;
    uint64_t clocks_most; /* limit of a run in clocks */
    struct sink report;   /* receives the messages of the assembler */
    /* Called regularly with the part of the work that is done. false stops the sweep.
     * NULL: never stop. */
    bool (*goes_on)(void *context, size_t done, size_t all);
    void *context;

    bool used[MAX_SWEPT_DEFINES + 1]; /* whether a program uses the constant and the
                                         names of options */

    /* Progress. The time of a run is assumed to be proportional to its value. */
    size_t done, all;
    size_t searched; /* points that were searched for crossings */
    bool inside;     /* a crossing is being bisected; its lower end is low */
    uint64_t low;

    /* The results. */
    char per_element[SWEPT_HEADING]; /* a heading such as "clk/n" */
    size_t count, point_count;       /* points done, all points */
    struct swept_point *points;
    size_t crossing_count;
    struct swept_crossing *crossings; /* in ascending order */
};

/* Runs a sweep. The input must be set, and all other members must be zeroed. On
 * failure, the error names the value and the reason. */
bool swept_run(struct program_sweep *sweep, c205_error *error);
/* Runs one point, or one step of the search for a crossing. Sets *over after the
 * last. */
bool swept_step(struct program_sweep *sweep, bool *over, c205_error *error);
void swept_free(struct program_sweep *sweep);

/* ---- The line -------------------------------------------------------------- */

/* A line t = startup + value / r, in clocks, with the smallest sum of squared relative
 * errors. Absolute errors would be unsuitable, because n-half depends on short vectors:
 * an error of 0.1 % for a long vector exceeds all clocks of a short vector.
 *
 *   r-infinity = values per clock for long vectors
 *   n-half     = startup x r, the value with half of this rate
 *
 * Source: R. W. Hockney and C. R. Jesshope, Parallel Computers (1981), chapter 1.
 */
struct swept_line {
    struct straight_line clocks; /* startup and 1 / r */
    double flops;                /* flops per value; 0: none */
    double off; /* largest relative deviation of the line from a point */
    uint64_t off_at;
    bool grows; /* the last point takes more clocks than the first point */
    bool good;  /* grows, and no point deviates by more than SWEPT_FAR */
};
/* A line is not reported if a point deviates from it by more than this fraction of its
 * clocks. */
#define SWEPT_FAR 0.05

struct swept_line swept_line_of(const struct program_sweep *sweep, int which);
double swept_half_length(const struct swept_line *line);
/* Returns the exponent k for which the clocks grow approximately as value^k over the
 * last octave of the points. */
double swept_power(const struct program_sweep *sweep, int which);

/* ---- Tables --------------------------------------------------------------- */

/* The names of the programs in tables, "first" and "second". */
extern const char *const swept_names[SWEPT_PROGRAMS];

/* These functions return a table, or NULL if memory is exhausted. The table refers to
 * texts of the sweep. */
struct table *swept_points(const struct program_sweep *sweep);
/* Returns the column that has the clocks of a program. */
size_t swept_clocks_column(int which);
struct table *swept_causes(const struct program_sweep *sweep);
struct table *swept_lines(const struct program_sweep *sweep);
struct table *swept_crossings(const struct program_sweep *sweep);

/* ---- The picture ----------------------------------------------------------- */

enum { SWEPT_TITLE = 160 };
void swept_title(const struct program_sweep *sweep, char title[SWEPT_TITLE]);
/* Draws the points, the fitted lines, their half lengths, and as many crossings as have
 * room. Returns false if memory is exhausted. */
bool swept_svg(const struct program_sweep *sweep, const char *title,
               const struct sink *sink, c205_error *error);

#endif
