/* cmd_isa.c - c205 isa: prints the instruction table,
 * instructions and the reference. */
#include <ctype.h>
#include <string.h>

#include "asm/command/cmd_isa.h"
#include "asm/object/syntax.h"
#include "base/word_wrap.h"

struct isa_arguments {
    struct shared_arguments shared;
    struct command_texts names; /* instructions to print; none: all */
    const char *search;         /* only rows that contain this text; NULL: all rows */
    bool only_names, markdown, grammar, card;
};

/* The columns of the instruction table in text format. */
static const struct table_column brief[] = {
    { "mnemonic", "name", TABLE_TEXT, 0 },
    { "code", "code", TABLE_TEXT, 0 },
    { "half", ",H", TABLE_TEXT, 0 },
    { "operands", "operands", TABLE_TEXT, 0 },
    { "provenance", "source", TABLE_TEXT, 0 },
    { "effect", "effect", TABLE_TEXT, 0 },
};

static const struct table_column columns[] = {
    { "mnemonic", "name", TABLE_TEXT, 0 }, { "code", "code", TABLE_TEXT, 0 },
    { "half", ",H", TABLE_TEXT, 0 },       { "operands", "operands", TABLE_TEXT, 0 },
    { "format", "format", TABLE_TEXT, 0 }, { "unit", "unit", TABLE_TEXT, 0 },
    { "timing", "timing", TABLE_TEXT, 0 }, { "provenance", "source", TABLE_TEXT, 0 },
    { "effect", "effect", TABLE_TEXT, 0 },
};

/* ---- One instruction ---------------------------------------------------- */

/* The column of the text after the name of a rule. */
enum { TEXT_BEGINS = 14 };

static void describe_operands(const c205_insn *insn)
{
    struct isa_operand operand = { 0 };
    const char *letter = NULL;
    while (isa_next_operand(insn, &letter, &operand)) {
        printf("  %-11s %-3.*s ", letter == insn->operands ? "operands" : "",
               operand.length, operand.written);
        word_wrap_print(operand.meaning ? operand.meaning : "", TEXT_BEGINS + 4,
                        stdout);
    }
}

static void describe_rules(const c205_insn *insn)
{
    struct isa_rules rules;
    isa_list_rules(insn, &rules);
    for (size_t i = 0; i < rules.count; i++) {
        if (rules.rule[i].text) {
            printf("  %-11s ", rules.rule[i].name);
            word_wrap_print(rules.rule[i].text, TEXT_BEGINS, stdout);
        }
    }
}

static void describe_example(const c205_insn *insn)
{
    const char *const *line = isa_example(insn);
    puts("  example");
    for (; line && *line; line++)
        printf("    %s", *line);
}

static void describe(const c205_insn *insn)
{
    const char *syntax = c205_format_syntax(insn->format);
    const char *timing = c205_timing_name(insn->timing);
    bool vector = c205_timing_is_vector(insn->timing);
    char code[ISA_CODE], drawing[ISA_DRAWING];
    isa_code(insn, code);
    isa_drawing(insn, drawing);
    printf("%s   ", insn->mnemonic);
    word_wrap_print(insn->effect, strlen(insn->mnemonic) + 3, stdout);
    printf("  written     %s%s%s%s\n", insn->mnemonic,
           insn->flags & C205_INSN_HALF ? "[" SYNTAX_HALF "]" : "", *syntax ? " " : "",
           syntax);
    printf("  code        %s\n", code);
    printf("  word        %s\n", drawing);
    describe_operands(insn);
    describe_rules(insn);
    printf("  unit        %s\n", c205_unit_name(insn->unit));
    printf("  timing      %s.%s%s%s%s\n", vector ? "startup" : "latency", timing,
           vector ? ", stream." : "", vector ? timing : "",
           insn->flags & C205_INSN_HALF
               ? "; with ,H by vector.half_rate where pipes share it"
               : "");
    printf("  provenance  %c, %s\n", insn->provenance,
           isa_provenance(insn->provenance));
    describe_example(insn);
    putchar('\n');
}

static void add_row(struct table *table, const c205_insn *insn, bool is_brief)
{
    char code[ISA_CODE], provenance[2] = { insn->provenance, '\0' };
    isa_code(insn, code);
    table_text(table, insn->mnemonic);
    table_text(table, code);
    table_text(table, insn->flags & C205_INSN_HALF ? "H" : "");
    table_text(table, c205_format_syntax(insn->format));
    if (!is_brief) {
        table_text(table, c205_format_name(insn->format));
        table_text(table, c205_unit_name(insn->unit));
        table_text(table, c205_timing_name(insn->timing));
    }
    table_text(table, provenance);
    table_text(table, insn->effect);
}

/* Finds an instruction by name, with or without the qualifier ",H" if it has one. */
static const c205_insn *row_named(const char *name)
{
    size_t length = strcspn(name, ",");
    const c205_insn *insn = c205_insn_named(name, length);
    const char *qualifier = name + length;
    bool half = !strcmp(qualifier, ",H") || !strcmp(qualifier, ",h");
    if (!*qualifier || (insn && half && insn->flags & C205_INSN_HALF))
        return insn;
    return NULL;
}

/* Returns true if a text contains a part, in upper or lower case. */
static bool has_part(const char *text, const char *part)
{
    for (; *text; text++) {
        size_t i = 0;
        while (part[i]
               && tolower((unsigned char)text[i]) == tolower((unsigned char)part[i]))
            i++;
        if (!part[i])
            return true;
    }
    return false;
}

static bool chosen(const struct isa_arguments *args, const c205_insn *insn)
{
    if (args->search && !has_part(insn->mnemonic, args->search)
        && !has_part(insn->effect, args->search))
        return false;
    for (size_t i = 0; i < args->names.count; i++)
        if (row_named(args->names.items[i]) == insn)
            return true;
    return args->names.count == 0;
}

static struct table *chosen_rows(const struct isa_arguments *args, bool is_brief)
{
    struct table *table = is_brief ? table_new(TABLE_COLUMNS(brief))
                                   : table_new(TABLE_COLUMNS(columns));
    for (size_t i = 0; table && i < c205_insn_count; i++)
        if (chosen(args, &c205_insns[i]))
            add_row(table, &c205_insns[i], is_brief);
    return table;
}

/* Prints the names alone, the named instructions in detail, or a line for each
 * instruction. */
static bool print_text(const struct isa_arguments *args)
{
    if (args->names.count == 0 && !args->only_names) {
        struct table *table = chosen_rows(args, true);
        bool good = table && table_print(table, stdout);
        table_free(table);
        return good;
    }
    for (size_t i = 0; i < c205_insn_count; i++) {
        const c205_insn *insn = &c205_insns[i];
        if (!chosen(args, insn))
            continue;
        if (args->only_names)
            puts(insn->mnemonic);
        else
            describe(insn);
    }
    return true;
}

/* Prints the result. Formats other than text always have the complete rows. */
static int show(const struct isa_arguments *args, const struct command_output *results)
{
    struct command_output rest = *results;
    if (results->format == OUTPUT_TEXT) {
        rest.file = NULL;
        if (!print_text(args))
            return cmd_failed(args->shared.command, "out of memory");
    }
    return output_show(&rest, chosen_rows(args, false), "instructions", NULL);
}

/* Prints the card or the reference page. Both contain clocks of the model. */
static int with_model(const struct isa_arguments *args)
{
    int code = CMD_DONE;
    c205_model *model = model_open(args->shared.command, args->shared.model);
    if (!model)
        return CMD_FAILED;
    if (args->card && c205_model_is_projection(model)) {
        code = cmd_failed(args->shared.command,
                          "%s has no clocks of single instructions",
                          c205_model_name(model));
    } else if (args->card) {
        isa_card(model);
    } else {
        code = isa_page(args->shared.command, model);
    }
    c205_model_free(model);
    return code;
}

/* Returns the option that selects an output other than a table, or NULL. */
static const char *other_form(const struct isa_arguments *args)
{
    return args->markdown  ? "markdown"
           : args->grammar ? "grammar"
           : args->card    ? "card"
                           : NULL;
}

static bool stands_alone(const struct isa_arguments *args)
{
    return args->names.count == 0 && !args->search && !args->only_names
           && !args->shared.results.path && !args->shared.results.format
           && args->markdown + args->grammar + args->card == 1;
}

/* Returns true if a row is chosen. */
static bool any_chosen(const struct isa_arguments *args)
{
    for (size_t i = 0; i < c205_insn_count; i++)
        if (chosen(args, &c205_insns[i]))
            return true;
    return false;
}

static int cmd_isa(void *given)
{
    const struct isa_arguments *args = given;
    struct session session = { .command = args->shared.command };
    const char *form = other_form(args);
    if (form) {
        return !stands_alone(args)
                   ? cmd_usage(args->shared.command,
                               "--%s can be combined only with --model", form)
               : args->grammar ? isa_grammar(args->shared.command)
                               : with_model(args);
    }
    for (size_t i = 0; i < args->names.count; i++) {
        const char *name = args->names.items[i];
        if (!row_named(name))
            return cmd_usage(args->shared.command, "unknown instruction '%s'", name);
    }
    if (!any_chosen(args))
        return cmd_failed(args->shared.command,
                          "no instruction has '%s' in its name or effect",
                          args->search);
    bool good = session_output(&session, &args->shared.results, NULL);
    return session_close(&session, good ? show(args, &session.results) : CMD_FAILED);
}

static const char *mnemonic_choice(size_t number)
{
    return number < c205_insn_count ? c205_insns[number].mnemonic : NULL;
}

#define PLACE(member) offsetof(struct isa_arguments, member)

static const struct command_option options[] = {
    { OPTION_ROW("search", "WORD", COMMAND_TEXT, PLACE(search),
                 "only instructions with this text in the name or the effect") },
    OPTION_FLAG("names", PLACE(only_names), "print only the mnemonics"),
    OPTION_FLAG("markdown", PLACE(markdown), "print the whole reference, docs/isa.md"),
    OPTION_FLAG("grammar", PLACE(grammar), "print a TextMate grammar, for editors"),
    OPTION_FLAG("card", PLACE(card), "print a card of two pages, for groff -Tpdf"),
    CMD_MODEL,
    CMD_RESULTS,
    COMMAND_END
};
static const struct command_option operands[] = {
    { OPERAND_ROW("MNEMONIC", COMMAND_TEXT, PLACE(names), "describe this instruction"),
      .many = true, .optional = true, .choice = mnemonic_choice },
    COMMAND_END
};

const struct command isa_command = {
    COMMAND_ROW("isa", cmd_isa, struct isa_arguments,
                "list or describe the instructions"),
    .details = "Without a MNEMONIC: all instructions, one line each.",
};
