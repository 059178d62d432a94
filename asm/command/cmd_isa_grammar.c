/* cmd_isa_grammar.c - c205 isa --grammar: prints a TextMate grammar with the names of
 * the instruction table. Editors colour programs by such a grammar.
 */
#include "asm/command/cmd_isa.h"

#include <stdio.h>

#include "asm/object/syntax.h"
#include "base/json.h"

/* Patterns that match where no name continues to the left (BEGINS) or to the right
 * (ENDS). */
#define BEGINS "(?<![\\w$.])"
#define ENDS "(?![\\w$.])"

static const struct {
    const char *name, *match;
} patterns[] = {
    { "comment.line.expectation.c205", "; *(?=expect[-a-z]*:).*$" },
    { "comment.line.c205", ";.*$" },
    { "string.quoted.c205", "\"(?:\\\\.|[^\"\\\\])*\"" },
    { "constant.numeric.word.c205", BEGINS "[Xx]'[0-9A-Fa-f ]*'" },
    { "entity.name.label.c205", BEGINS "[A-Za-z_$][\\w$.]*(?=:)" },
    { "keyword.directive.c205", BEGINS "\\.[A-Za-z]\\w*" },
    { "variable.parameter.macro.c205", "\\\\(?:[A-Za-z_$]\\w*|@|\\(\\))" },
    { "variable.language.register.c205",
      BEGINS "[rh](?:25[0-5]|2[0-4]\\d|1?\\d?\\d)" ENDS },
    { "constant.numeric.c205",
      BEGINS "(?:0[xX][0-9A-Fa-f]+|\\d+(?:\\.\\d*)?(?:[eE][-+]?\\d+)?)" ENDS },
};

static void put_pattern(struct json *json, const char *name, const char *match)
{
    json_object(json, NULL);
    json_text(json, "name", name);
    json_text(json, "match", match);
    json_end(json);
}

/* Writes the pattern for the mnemonics of all vector or all scalar instructions, in
 * upper or lower case. It allows ",H" after an instruction with 32-bit operands. */
static bool put_names(struct json *json, const char *name, bool vector)
{
    struct text_buffer match = { 0 };
    struct sink sink = text_buffer_sink(&match);
    const char *between = "(?i)" BEGINS "(?:";
    for (size_t i = 0; i < c205_insn_count; i++) {
        const c205_insn *insn = &c205_insns[i];
        if (c205_timing_is_vector(insn->timing) == vector) {
            sink_print(&sink, "%s%s%s", between, insn->mnemonic,
                       insn->flags & C205_INSN_HALF ? "(?:" SYNTAX_HALF ")?" : "");
            between = "|";
        }
    }
    sink_put(&sink, ")" ENDS);
    bool good = !match.failed;
    if (good)
        put_pattern(json, name, match.text);
    text_buffer_free(&match);
    return good;
}

int isa_grammar(const char *command)
{
    c205_error error;
    struct json *json = json_open_stream(stdout, NULL, &error);
    if (!json)
        return cmd_failed(command, "%s", error.message);
    json_text(json, "name", "CYBER 205 assembly");
    json_text(json, "scopeName", "source.c205");
    json_array(json, "patterns");
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++)
        put_pattern(json, patterns[i].name, patterns[i].match);
    bool good = put_names(json, "keyword.mnemonic.vector.c205", true)
                && put_names(json, "keyword.mnemonic.scalar.c205", false);
    json_end(json);
    return json_close(json, &error) && good ? CMD_DONE
                                            : cmd_failed(command, "out of memory");
}
