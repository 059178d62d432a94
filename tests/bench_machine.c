/* bench_machine.c - the speed of the emulation: programs on the machine, compared with
 * the same loops in plain doubles, and with the clock of the real machine.
 *
 *     bench_machine [TRIALS]
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/table.h"
#include "tests/timed_program.h"

enum { LENGTH = 2000, DOUBLE_REPEATS = 20000 };

/* A program that executes an instruction on two vectors 1.0, 1.001, .. and stores the
 * result. */
#define VECTOR_PROGRAM(instruction) \
    "        .include \"core.s\"\n" \
    "        .equ    n, 2000\n" \
    "        .data\n" \
    "a:      .space  n\n" \
    "b:      .space  n\n" \
    "c:      .space  n\n" \
    "        .code\n" \
    "        descriptor r10, a, n\n" \
    "        descriptor r11, b, n\n" \
    "        descriptor r12, c, n\n" \
    "        load_constant r13, 1.0\n" \
    "        load_constant r14, 0.001\n" \
    "        INTVLV  r13, r14, [r10]\n" \
    "        INTVLV  r13, r14, [r11]\n" \
    "        ES      r15, 20000\n" \
    "        EX      r16, again\n" \
    "again:  " instruction " [r10], [r11], [r12]\n" \
    "        DBNZ    r15, [r16]\n" \
    "        EXIT\n"

/* A loop with a call, as a compiler writes it: the nearer root of each quadratic of a
 * list, with arguments and results in memory. */
static const char scalar_program[] =
    "        .include \"core.s\"\n"
    "        .regs   r10, args, roots, i, n, one, link, to, turns\n"
    "        .regs   r20, a, b, c, d, s, bb, ac, two, four, none\n"
    "        .data\n"
    "list:   .word   1.0, -3.0, 2.0, 2.0, 1.0, 5.0, 1.0, -8.0, 4.0\n"
    "result: .space  3\n"
    "        .code\n"
    "        EX      roots, result\n"
    "        ES      one, 1\n"
    "        ES      n, 3\n"
    "        load_constant two, 2.0\n"
    "        load_constant four, 4.0\n"
    "        EX      turns, 300000\n"
    "outer:  EX      args, list\n"
    "        ES      i, 0\n"
    "inner:  EX      to, solve\n"
    "        BSAVE   link, [to]\n"
    "        STO     [roots, i], s\n"
    "        IX      args, 192\n"
    "        IBXLT   i, one, n, inner, i\n"
    "        EX      to, outer\n"
    "        DBNZ    turns, [to]\n"
    "        EXIT\n"
    "solve:  LOD     [args], a\n"
    "        LOD     [args, one], b\n"
    "        ES      s, 2\n"
    "        LOD     [args, s], c\n"
    "        MPYS    b, b, bb\n"
    "        MPYS    a, c, ac\n"
    "        MPYS    four, ac, ac\n"
    "        SUBN    bb, ac, d\n"
    "        RTOR    none, s\n"
    "        CFPLT   d, r0, away\n"
    "        SQRT    d, s\n"
    "        ADDN    b, s, s\n"
    "        MPYS    two, a, a\n"
    "        SUBN    r0, s, s\n"
    "        DIVS    s, a, s\n"
    "away:   BIM     0, link\n";

/* ---- Loops over doubles of the host ---------------------------------- */

static double x[LENGTH], y[LENGTH], z[LENGTH];
static volatile double sink; /* keeps the compiler from removing the loops */
static int trials = 5;

static void add_doubles(void)
{
    for (int i = 0; i < LENGTH; i++)
        z[i] = x[i] + y[i];
}

static void multiply_doubles(void)
{
    for (int i = 0; i < LENGTH; i++)
        z[i] = x[i] * y[i];
}

typedef void loop(void);

/* Returns seconds per element. The compiler cannot merge iterations (volatile). */
static double time_doubles(loop *run)
{
    loop *volatile turn = run;
    double best = HUGE_VAL;
    for (int trial = 0; trial < trials; trial++) {
        double start = processor_seconds();
        for (int i = 0; i < DOUBLE_REPEATS; i++) {
            turn();
            sink = z[i % LENGTH];
        }
        best = fmin(best, processor_seconds() - start);
    }
    return best / DOUBLE_REPEATS / LENGTH;
}

/* ---- The machine ------------------------------------------------------ */

static const struct bench {
    const char *name;
    const char *program;
    loop *doubles; /* NULL: the instructions are counted */
} benches[] = {
    { "add, 64 bits, n = 2,000", VECTOR_PROGRAM("ADDNV"), add_doubles },
    { "multiply, 64 bits, n = 2,000", VECTOR_PROGRAM("MPYSV"), multiply_doubles },
    { "scalar, a loop with a call", scalar_program, NULL },
};

static const struct table_column columns[] = {
    { "program", "program", TABLE_TEXT, 0 },
    { "ns_per_element", "ns/element", TABLE_NUMBER, 3 },
    { "ns_per_double", "ns/double", TABLE_NUMBER, 3 },
    { "millions_of_instructions", "M instr/s", TABLE_NUMBER, 1 },
    { "millions_of_clocks", "M clk/s", TABLE_NUMBER, 1 },
    { "times_the_machine", "x 50 MHz", TABLE_NUMBER, 1 },
};

static void add_row(struct table *table, const struct bench *bench, const c205 *machine,
                    double seconds)
{
    const c205_account *account = c205_account_at(machine, 0);
    double period = c205_model_lookup(c205_machine_model(machine), "clock.period")
                        ->value;
    double rate = (double)c205_clock(machine) / seconds;
    bool vector = bench->doubles != NULL;
    table_text(table, bench->name);
    table_number(table, vector ? seconds / (double)account->elements * 1e9 : NAN);
    table_number(table, vector ? time_doubles(bench->doubles) * 1e9 : NAN);
    table_number(table, vector ? NAN : (double)account->instructions / seconds / 1e6);
    table_number(table, rate / 1e6);
    table_number(table, rate * period / 1e9);
}

int main(int count, char **words)
{
    trials = count > 1 ? atoi(words[1]) : trials;
    c205_error error;
    SCOPED(c205_model) *model = c205_model_find("cyber205-2pipe", &error);
    SCOPED(c205) *machine = model ? c205_new(model, &error) : NULL;
    SCOPED(table) *table = table_new(columns, sizeof columns / sizeof *columns);
    if (!machine || !table)
        stop_bench(machine ? "out of memory" : error.message);
    for (int i = 0; i < LENGTH; i++)
        x[i] = y[i] = 1.0 + 0.001 * i;
    for (size_t i = 0; i < sizeof benches / sizeof *benches; i++) {
        SCOPED(object) *object = program_to_time(benches[i].program);
        add_row(table, &benches[i], machine,
                time_program(machine, &object->program, trials));
    }
    table_print(table, stdout);
    return 0;
}
