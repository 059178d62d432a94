/* operands.c - shows the operands of the next instruction as variables. */
#include <inttypes.h>
#include <stdio.h>

#include "asm/dap/variables.h"
#include "asm/view/operand_view.h"

static void put_operand(struct dap *dap, struct json *json,
                        const struct instruction_view *view,
                        const struct operand_view *operand, size_t number)
{
    struct vector_view vector = vector_of_operand(view, operand);
    struct text_line text = { .length = 0 }, name = { .length = 0 };
    struct sink sink = text_line_sink(&text), naming = text_line_sink(&name);
    bool listed = vector_has_elements(operand);
    char register_name[REGISTER_NAME];
    if (operand->is_half)
        snprintf(register_name, sizeof register_name, "h%u", operand->number);
    sink_print(&naming, operand->is_vector ? "%s [%s]" : "%s %s", view->insn->mnemonic,
               operand->is_half ? register_name
                                : name_of(dap, operand->number, register_name));
    if (listed)
        vector_extent(&vector, &sink);
    else if (operand->is_vector)
        sink_print(&sink, "%s from %" PRIX64 " on", vector_elements(operand->width),
                   operand->address);
    else
        put_bits(operand->word, operand->is_half ? 32 : 64, &sink);
    put_variable(json, name.text, text.text,
                 listed ? reference_of(OF_OPERAND, number) : 0);
    if (listed)
        json_count(json, "indexedVariables", vector.length);
    json_end(json);
}

void put_operands(struct dap *dap, struct json *json)
{
    struct instruction_view views[VIEW_LINKED];
    size_t count;
    count = view_at(views, machine_of(dap->debugger),
                    c205_pc(machine_of(dap->debugger)));
    for (size_t i = 0; i < count; i++) {
        const struct instruction_view *view = &views[i];
        for (size_t k = 0; view->insn && k < view->count; k++)
            if (view_is_read(&view->operands[k]))
                put_operand(dap, json, view, &view->operands[k], i * VIEW_OPERANDS + k);
    }
}

bool operand_vector(const struct dap *dap, size_t number, struct vector_view *vector)
{
    struct instruction_view views[VIEW_LINKED];
    size_t count;
    const struct instruction_view *view;
    const struct operand_view *operand;
    count = view_at(views, machine_of(dap->debugger),
                    c205_pc(machine_of(dap->debugger)));
    if (number >= count * VIEW_OPERANDS)
        return false;
    view = &views[number / VIEW_OPERANDS];
    operand = &view->operands[number % VIEW_OPERANDS];
    if (!vector_has_elements(operand))
        return false;
    *vector = vector_of_operand(view, operand);
    return true;
}
