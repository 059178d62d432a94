/* cmd_isa.c - c205 isa: the instruction table, for the reader. */
#include <stddef.h>
#include <string.h>

#include "asm/cmd.h"

static const struct table_column columns[] = {
    { "mnemonic", "name", TABLE_TEXT, 0 },
    { "code", "code", TABLE_TEXT, 0 },
    { "operands", "operands", TABLE_TEXT, 0 },
    { "format", "format", TABLE_TEXT, 0 },
    { "unit", "unit", TABLE_TEXT, 0 },
    { "timing", "timing", TABLE_TEXT, 0 },
    { "provenance", "source", TABLE_TEXT, 0 },
    { "effect", "effect", TABLE_TEXT, 0 },
};
enum { COLUMNS = sizeof columns / sizeof *columns };

/* What the letters of insn.def mean. */
struct meaning {
    char letter;
    const char *text;
};

static const struct meaning operand_meanings[] = {
    { 'f', "register, read as a number; r0 is machine zero" },
    { 'i', "register, read as bits, an index or an address; r0 is 0" },
    { 'w', "register, written" },
    { 'm', "register, read as bits, then written" },
    { 'v', "vector of numbers in brackets, or a register, broadcast" },
    { 'u', "vector of words in brackets, or a register, broadcast" },
    { 'b', "bit vector, read" },
    { 'd', "vector of words, written" },
    { 'e', "bit vector, written" },
    { 'c', "vector of words, written; the machine sets its length" },
    { 'x', "address of a table; its length is not used" },
    { 'n', "immediate" },
    { 't', "branch target, a label" },
    { 'z', "control vector: ? where it has ones, ?! zeros" },
    { '\0', "" },
};

static const struct meaning provenances[] = {
    { 'P', "read in a primary source" },
    { 'S', "read in a secondary source" },
    { 'D', "derived" },
    { 'R', "reconstructed from recollection" },
    { '\0', "" },
};

static const struct {
    uint8_t flag;
    const char *text;
} flag_notes[] = {
    { C205_INSN_SIGN, "sign control: |A|, |B|, -A, -|A|" },
    { C205_INSN_LINK, "may stand after the link prefix" },
    { C205_INSN_PADZ, "a short source continues with machine zeros" },
    { C205_INSN_PADO, "a short source continues with normalised ones" },
    { C205_INSN_INDEX, "the register after the result gets an index" },
};
enum { FLAG_NOTES = sizeof flag_notes / sizeof *flag_notes };

static const char *meaning_of(const struct meaning *meanings, char letter)
{
    while (meanings->letter && meanings->letter != letter) {
        meanings++;
    }
    return meanings->text;
}

/* "82", or "9D.1" where bits of G belong to the operation. */
static void code_of(const c205_insn *insn, char text[8])
{
    int length = snprintf(text, 8, "%02X", insn->opcode);
    if (insn->subop_mask) {
        snprintf(text + length, 8 - (size_t)length, ".%02X", insn->subop);
    }
}

/* ---- The drawing of a format ------------------------------------------- */

enum { BYTE_BITS = 8, WORD_BYTES = 8 };

static const struct {
    char letter;
    size_t offset;
} byte_fields[] = {
    { 'G', offsetof(c205_fields, g) }, { 'X', offsetof(c205_fields, x) },
    { 'A', offsetof(c205_fields, a) }, { 'Y', offsetof(c205_fields, y) },
    { 'B', offsetof(c205_fields, b) }, { 'Z', offsetof(c205_fields, z) },
    { 'C', offsetof(c205_fields, c) }, { 'R', offsetof(c205_fields, r) },
    { 'S', offsetof(c205_fields, s) }, { 'T', offsetof(c205_fields, t) },
};
enum { BYTE_FIELDS = sizeof byte_fields / sizeof *byte_fields };

/* Put the letter at each byte in which two words differ. */
static void mark(char letter, c205_word one, c205_word other,
                 char drawing[WORD_BYTES])
{
    for (int i = 0; i < WORD_BYTES; i++) {
        unsigned shift = (unsigned)(WORD_BYTES - 1 - i) * BYTE_BITS;
        if ((one ^ other) >> shift & 0xFF) {
            drawing[i] = letter;
        }
    }
}

/* Which field lies in which byte: fill one after another and look where the
 * word changes.  The distance of a relative branch lies over Y and B. */
static void probe_format(const c205_insn *insn, char drawing[WORD_BYTES])
{
    c205_fields fields = { 0 };
    c205_word empty = c205_encode(insn, &fields);
    memset(drawing, '-', WORD_BYTES);
    drawing[0] = 'F';
    for (size_t i = 0; i < BYTE_FIELDS; i++) {
        unsigned char *byte =
            (unsigned char *)&fields + byte_fields[i].offset;
        *byte = 0xFF & ~insn->subop_mask;
        mark(byte_fields[i].letter, c205_encode(insn, &fields), empty,
             drawing);
        *byte = 0;
    }
    fields.g = C205_G_RELATIVE;
    empty = c205_encode(insn, &fields);
    fields.immediate = -1;
    mark('I', c205_encode(insn, &fields), empty, drawing);
}

static void draw_format(const c205_insn *insn)
{
    char drawing[WORD_BYTES];
    int bytes = (int)c205_format_halves(insn->format) * WORD_BYTES / 2;
    probe_format(insn, drawing);
    for (int i = 0; i < bytes;) {
        int run = 1;
        while (i + run < bytes && drawing[i] == drawing[i + run]) {
            run++;
        }
        printf("| %c %d ", drawing[i], run * BYTE_BITS);
        i += run;
    }
    puts("|");
}

/* ---- One instruction ---------------------------------------------------- */

/* One line for each operand, in the order of the syntax. */
static void describe_operands(const c205_insn *insn)
{
    const char *at = c205_format_syntax(insn->format);
    for (const char *letter = insn->operands; *letter; letter++) {
        at += strspn(at, "[], ?!");
        int length = (int)strcspn(at, "[], ?!");
        printf("  %-11s %-3.*s %s\n", letter == insn->operands ?
               "operands" : "", length, at,
               meaning_of(operand_meanings, *letter));
        at += length;
    }
}

static void describe(const c205_insn *insn)
{
    char code[8];
    code_of(insn, code);
    printf("%s   %s\n", insn->mnemonic, insn->effect);
    printf("  written     %s %s\n", insn->mnemonic,
           c205_format_syntax(insn->format));
    printf("  code        %s\n", code);
    printf("  word        ");
    draw_format(insn);
    describe_operands(insn);
    for (size_t i = 0; i < FLAG_NOTES; i++) {
        if (insn->flags & flag_notes[i].flag) {
            printf("  note        %s\n", flag_notes[i].text);
        }
    }
    const char *timing = c205_timing_name(insn->timing);
    bool vector = c205_timing_is_vector(insn->timing);
    printf("  unit        %s\n", c205_unit_name(insn->unit));
    printf("  timing      %s.%s%s%s\n", vector ? "startup" : "latency",
           timing, vector ? ", stream." : "", vector ? timing : "");
    printf("  provenance  %c, %s\n\n", insn->provenance,
           meaning_of(provenances, insn->provenance));
}

static void add_row(struct table *table, const c205_insn *insn)
{
    char code[8], provenance[2] = { insn->provenance, '\0' };
    code_of(insn, code);
    table_text(table, insn->mnemonic);
    table_text(table, code);
    table_text(table, c205_format_syntax(insn->format));
    table_text(table, c205_format_name(insn->format));
    table_text(table, c205_unit_name(insn->unit));
    table_text(table, c205_timing_name(insn->timing));
    table_text(table, provenance);
    table_text(table, insn->effect);
}

static bool chosen(const struct cmd_arguments *arguments,
                   const c205_insn *insn)
{
    for (size_t i = 0; i < arguments->file_count; i++) {
        const char *name = arguments->files[i];
        if (c205_insn_named(name, strlen(name)) == insn) {
            return true;
        }
    }
    return arguments->file_count == 0;
}

/* A table of all; of those that were named, all that is known; or the names
 * alone.  The JSON file has the rows of the table in each case. */
static int show(const struct cmd_arguments *arguments, struct json *json)
{
    struct table *table = table_new(columns, COLUMNS);
    bool tabular = arguments->file_count == 0 && !arguments->names;
    for (size_t i = 0; table && i < c205_insn_count; i++) {
        const c205_insn *insn = &c205_insns[i];
        if (!chosen(arguments, insn)) {
            continue;
        }
        add_row(table, insn);
        if (arguments->names) {
            puts(insn->mnemonic);
        } else if (!tabular) {
            describe(insn);
        }
    }
    if (tabular || !table) {
        return cmd_show(arguments->command, table, json, "instructions");
    }
    if (json) {
        table_json(table, json, "instructions");
    }
    table_free(table);
    return CMD_DONE;
}

int cmd_isa(const struct cmd_arguments *arguments)
{
    struct json *json;
    for (size_t i = 0; i < arguments->file_count; i++) {
        const char *name = arguments->files[i];
        if (!c205_insn_named(name, strlen(name))) {
            return cmd_usage(arguments->command, "no such instruction: %s",
                             name);
        }
    }
    if (!cmd_open_json(arguments, &json)) {
        return CMD_FAILED;
    }
    int code = show(arguments, json);
    return cmd_end_json(arguments, json, code);
}
