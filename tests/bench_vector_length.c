/* bench_vector_length.c - host nanoseconds per vector instruction by the length of its
 * vectors: the cost of starting one, and the cost of each element.
 *
 *     bench_vector_length [TRIALS [TEXT]]
 *
 * With TEXT, only the instructions that contain it are measured.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/table.h"
#include "tests/timed_program.h"

enum { UNROLLED = 10, ELEMENTS = 500000, FEWEST_TURNS = 500 };

/* An instruction, repeated in each iteration, on vectors of n elements. Two of three
 * bits are ones, and the list of indices contains every element. */
static const char program_text[] =
    "        .include \"core.s\"\n"
    "        .equ    n, %zu\n"
    "        .data\n"
    "a:      .space  n\n"
    "b:      .space  n\n"
    "c:      .space  n\n"
    "list:   .space  n\n"
    "ones_a: .space  (n + 63) / 64\n"
    "ones_b: .space  (n + 63) / 64\n"
    "bits:   .space  (n + 63) / 64\n"
    "kept:   .space  24\n"
    "        .regs   r10, va, vb, vc, vlist, va1, vb1, vbits, vkept, table\n"
    "        .regs   r20, one, step, i0, i1, i2, i3, count, turns, again\n"
    "        .code\n"
    "        descriptor va, a, n\n"
    "        descriptor vb, b, n\n"
    "        descriptor vc, c, n\n"
    "        descriptor vlist, list, n\n"
    "        descriptor va1, ones_a, n\n"
    "        descriptor vb1, ones_b, n\n"
    "        descriptor vbits, bits, n\n"
    "        descriptor vkept, kept, 24\n"
    "        EX      table, a\n"
    "        load_constant one, 1.0\n"
    "        load_constant step, 0.001\n"
    "        ES      i0, 0\n"
    "        ES      i1, 1\n"
    "        ES      i2, 2\n"
    "        ES      i3, 3\n"
    "        INTVLV  one, step, [va]\n"
    "        INTVLV  one, step, [vb]\n"
    "        INTVLV  i0, i1, [vlist]\n"
    "        MRKO    i2, i3, [va1]\n"
    "        MRKO    i2, i3, [vb1]\n"
    "        EX      turns, %zu\n"
    "        EX      again, loop\n"
    "loop:   .rept   10\n"
    "        %s\n"
    "        .endr\n"
    "        DBNZ    turns, [again]\n"
    "        EXIT\n";

static const char *const instructions[] = {
    "ADDNV   [va], [vb], [vc]",
    "ADDNV   [va], [vb], [vc] ? [va1]",
    "MPYSV   [va], one, [vc]",
    "MPYSV   [vc], one, [vc]",
    "SUBNV   [va], [vb], [va]",
    "SQRTV   [va], [vc] ? [va1]",
    "ABSV    [va], [vc]",
    "VTOV    [va], [vc]",
    "VTOV    one, [vc]",
    "CMPGEV  [va], one, [vbits]",
    "CMPLTV  [va], [vb], [vbits] ? [va1]",
    "LINKV\n        MPYSV [va], one, [vc]\n        ADDNV [vc], [vb], [vc]",
    "ORV     [va], [vb], [vc]",
    "ADDXV   [va], one, [vc]",
    "VXTOV   [vlist], [table], [vc]",
    "VTOVX   [vlist], [vc], [table]",
    "VTOVX   [vlist], [vc], [table] ? [va1]",
    "CPSV    [va], [vc] ? [va1]",
    "MASKV   [va], [vb], [vc] ? [va1]",
    "MRGV    [va], [vb], [vc] ? [va1]",
    "ANDB    [va1], [vb1], [vbits]",
    "CNTOB   [va1], count",
    "MAXV    [va], count, step",
    "SUMV    [va], r40",
    "SWAP    [vkept], r40, [vkept]",
};
enum { INSTRUCTIONS = sizeof instructions / sizeof *instructions };

static const size_t lengths[] = { 8, 13, 60, 300, 2000 };
enum { LENGTHS = sizeof lengths / sizeof *lengths };

static const struct table_column columns[] = {
    { "instruction", "ns/instruction", TABLE_TEXT, 0 },
    { "n_8", "n = 8", TABLE_NUMBER, 1 },
    { "n_13", "13", TABLE_NUMBER, 1 },
    { "n_60", "60", TABLE_NUMBER, 1 },
    { "n_300", "300", TABLE_NUMBER, 1 },
    { "n_2000", "2000", TABLE_NUMBER, 1 },
};

static struct object *assemble(const char *instruction, size_t n, size_t turns)
{
    char text[2 * sizeof program_text];
    snprintf(text, sizeof text, program_text, n, turns, instruction);
    return program_to_time(text);
}

static int trials = 5;

static double nanoseconds(c205 *machine, const char *instruction, size_t n)
{
    size_t turns = FEWEST_TURNS + ELEMENTS / UNROLLED / (n + 100);
    SCOPED(object) *object = assemble(instruction, n, turns);
    double seconds = time_program(machine, &object->program, trials);
    return seconds / (double)(turns * UNROLLED) * 1e9;
}

/* The name is the instruction's first line, with single spaces. */
static void name_row(struct table *table, const char *instruction)
{
    char name[100];
    size_t length = 0;
    for (const char *c = instruction; *c; c++)
        if ((*c != ' ' && *c != '\n') || (length && name[length - 1] != ' '))
            name[length++] = *c == '\n' ? ' ' : *c;
    name[length] = '\0';
    table_text(table, name);
}

int main(int count, char **words)
{
    trials = count > 1 ? atoi(words[1]) : trials;
    const char *wanted = count > 2 ? words[2] : "";
    c205_error error;
    SCOPED(c205_model) *model = c205_model_find("cyber205-2pipe", &error);
    SCOPED(c205) *machine = model ? c205_new(model, &error) : NULL;
    SCOPED(table) *table = table_new(columns, sizeof columns / sizeof *columns);

    if (!machine || !table)
        stop_bench(machine ? "out of memory" : error.message);
    for (size_t i = 0; i < INSTRUCTIONS; i++) {
        if (!strstr(instructions[i], wanted))
            continue;
        name_row(table, instructions[i]);
        for (size_t k = 0; k < LENGTHS; k++)
            table_number(table, nanoseconds(machine, instructions[i], lengths[k]));
    }
    table_print(table, stdout);
    return 0;
}
