/* swept.h - a program, or two, run for each of many values of a constant.
 *
 * A program is assembled again for each value and run to its end; all figures of a point are
 * those of the machine's accounts.  Through the points goes a line, and two programs are
 * told apart by where the second begins to be the faster one, or ceases to be.
 */
#ifndef ASM_SWEPT_H
#define ASM_SWEPT_H

#include "asm/assemble.h"
#include "asm/straight_line.h"
#include "base/table.h"
#include "vm/c205.h"

/* ---- Values ---------------------------------------------------------------- */

enum { MAX_SWEPT_POINTS = 1000 };
/* What the 48 bits of an index hold. */
#define SWEPT_LARGEST ((UINT64_C(1) << 47) - 1)

/* From 1 on, from < to.  With a step or a factor there are no values but those; without,
 * all integers in between. */
struct swept_range {
    uint64_t from, to;
    uint64_t step;   /* 0: none */
    uint64_t factor; /* 0: none */
};

/* "8:65535", "8:65535:8", "8:65535:x2".  False: it is none of these. */
bool swept_take_range(const char *text, struct swept_range *range);
/* All of the steps or factors; or so many points at most, both ends among them, each by the
 * same factor above the one before, but for rounding; 0: 8 an octave, but no more than 25.
 * Returns how many; 0: there are more than fit. */
size_t swept_values(const struct swept_range *range, size_t points,
                    uint64_t values[MAX_SWEPT_POINTS]);

/* ---- Runs ------------------------------------------------------------------ */

enum { MAX_SWEPT_DEFINES = 100, SWEPT_HEADING = 64 };
enum { SWEPT_FIRST, SWEPT_SECOND, SWEPT_PROGRAMS };

struct swept_point {
    uint64_t value;
    c205_account runs[SWEPT_PROGRAMS]; /* of all regions together */
};

/* From this value on the second is faster; or, if not, no more. */
struct swept_crossing {
    struct swept_point at;
    bool faster;
};

struct program_sweep {
    /* What is asked for. */
    const char *constant;
    struct swept_range range;
    size_t asked; /* points; 0: as many as usual */
    struct swept_program {
        const char *path, *text;
        size_t length;
    } programs[SWEPT_PROGRAMS];
    size_t program_count;
    const c205_model *model;
    const struct asm_options *options; /* the constant besides; so many defines */
    /* Pages are in memory at the start, or not; neither: as the programs say. */
    bool warm, cold;
    uint64_t clocks_most; /* of a run */
    struct sink report;   /* what the assembler says */
    /* Told now and then that so much of all is done.  False: stop.  NULL: nobody asks. */
    bool (*goes_on)(void *context, size_t done, size_t all);
    void *context;

    bool used[MAX_SWEPT_DEFINES
              + 1]; /* by a program: the constant, the options' names */

    /* How far it is, where each run takes as long as its value is large. */
    size_t done, all;
    size_t searched; /* points between which crossings were looked for */
    bool inside;     /* a search, and there is none up to: */
    uint64_t low;

    /* What was found. */
    char per_element[SWEPT_HEADING]; /* "clk/n" */
    size_t count, point_count;       /* so many of all */
    struct swept_point *points;
    size_t crossing_count;
    struct swept_crossing *crossings; /* rising */
};

/* Begin with what is asked for, the rest zero.  False: the error says which value it was,
 * and why. */
bool swept_run(struct program_sweep *sweep, c205_error *error);
/* The same a point at a time, or a step of the search for a crossing, until *over. */
bool swept_step(struct program_sweep *sweep, bool *over, c205_error *error);
void swept_free(struct program_sweep *sweep);

/* ---- The line -------------------------------------------------------------- */

/* t = startup + value / r, in clocks; the sum of squares of relative errors is least.  For
 * n-half is of short vectors: they would not count beside what a thousandth of a long one
 * is, if errors were taken in clocks.
 *
 *   r-infinity = values a clock, for ever longer vectors
 *   n-half     = startup x r: the value for which half of that rate is reached
 *
 * Source: R. W. Hockney and C. R. Jesshope, Parallel Computers (1981), chapter 1.
 */
struct swept_line {
    struct straight_line clocks; /* startup, 1 / r */
    double flops;                /* more for each value more; 0: none */
    double off; /* where it is farthest off, so much of the clocks there */
    uint64_t off_at;
    bool grows; /* the last point takes more clocks than the first */
    bool good;  /* it grows, and no point is far off */
};
/* A point farther off than this makes it no line. */
#define SWEPT_FAR 0.05

struct swept_line swept_line_of(const struct program_sweep *sweep, int which);
double swept_half_length(const struct swept_line *line);
/* The clocks go with that power of the value, in the last octave. */
double swept_power(const struct program_sweep *sweep, int which);

/* ---- Tables --------------------------------------------------------------- */

/* What the programs are called: "first", "second". */
extern const char *const swept_names[SWEPT_PROGRAMS];

/* NULL: no memory.  They borrow texts of the sweep. */
struct table *swept_points(const struct program_sweep *sweep);
struct table *swept_causes(const struct program_sweep *sweep);
struct table *swept_lines(const struct program_sweep *sweep);
struct table *swept_crossings(const struct program_sweep *sweep);

/* ---- The picture ----------------------------------------------------------- */

enum { SWEPT_TITLE = 160 };
void swept_title(const struct program_sweep *sweep, char title[SWEPT_TITLE]);
void swept_svg(const struct program_sweep *sweep, const char *title,
               const struct sink *sink);

#endif
