/* about.c - the request `about`, which lists models, instructions, directives and
 * lessons.
 */
#include "asm/object/syntax.h"
#include "web/engine/engine_internal.h"

static bool put_models(struct json *reply, c205_error *error)
{
    json_array(reply, "models");
    for (const char *const *name = c205_model_names(); *name; name++) {
        c205_model *model = c205_model_find(*name, error);
        if (!model)
            return false;
        if (!c205_model_is_projection(model)) {
            json_object(reply, NULL);
            json_text(reply, "name", *name);
            json_text(reply, "title", c205_model_title(model));
            json_end(reply);
        }
        c205_model_free(model);
    }
    json_end(reply);
    return true;
}

/* Writes the operands of an instruction, without the mnemonic. */
static void put_operands(const c205_insn *insn, bool half, const char *key,
                         struct json *reply)
{
    struct text_line text = { .length = 0 };
    struct sink sink = text_line_sink(&text);
    const char *behind = text.text;
    syntax_write(insn, half, &sink);
    while (*behind && *behind != ' ')
        behind++;
    json_text(reply, key, *behind ? behind + 1 : "");
}

static void put_insn(const c205_insn *insn, struct json *reply)
{
    char source[2] = { insn->provenance, '\0' };
    json_object(reply, NULL);
    json_text(reply, "mnemonic", insn->mnemonic);
    put_operands(insn, false, "operands", reply);
    if (insn->flags & C205_INSN_HALF)
        put_operands(insn, true, "half_operands", reply);
    json_text(reply, "effect", insn->effect);
    json_text(reply, "unit", c205_unit_name(insn->unit));
    json_bool(reply, "vector", c205_timing_is_vector(insn->timing));
    json_text(reply, "source", source);
    json_end(reply);
}

bool answer_about(struct engine *engine, const struct json_value *request,
                  struct json *reply, c205_error *error)
{
    (void)engine;
    (void)request;
    json_text(reply, "version", C205_VERSION);
    json_text(reply, "model", C205_DEFAULT_MODEL);
    if (!put_models(reply, error))
        return false;
    json_array(reply, "instructions");
    for (size_t i = 0; i < c205_insn_count; i++)
        put_insn(&c205_insns[i], reply);
    json_end(reply);
    json_array(reply, "directives");
    for (size_t i = 0; asm_directive(i); i++)
        json_text(reply, NULL, asm_directive(i));
    json_end(reply);
    return put_lessons(reply, error);
}
