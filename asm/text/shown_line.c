/* shown_line.c - finds the line at which an instruction of a macro is shown. */
#include "asm/text/shown_line.h"

#include <stdio.h>
#include <string.h>

#include "base/text_file.h"
#include "vm/text.h"

/* ---- Operations and formulas ---------------------------------------------- */

static bool is_library(const char *file)
{
    return text_find(library_texts, file);
}

/* Returns the macro whose expansion contains the current line, or NULL. */
static const struct macro *current_macro(const struct expander *expander)
{
    for (unsigned i = expander->depth; i-- > 0;) {
        const struct expansion *frame = &expander->frames[i];
        if (frame->kind != FRAME_REPEAT)
            return frame->kind == FRAME_MACRO ? frame->body : NULL;
    }
    return NULL;
}

static bool ends_with(const char *text, const char *ending)
{
    size_t length = strlen(text), most = strlen(ending);
    return length >= most && strcmp(text + length - most, ending) == 0;
}

/* Returns true if a macro is an operation in this form. line is the line of its
 * definition; within is the macro whose expansion contains the definition, or NULL. */
static bool has_form(const struct line *line, const struct macro *within,
                     enum asm_form form)
{
    char ending[40], definer[40];
    snprintf(ending, sizeof ending, "_%s.s", asm_form_name(form));
    snprintf(definer, sizeof definer, "%s_form", asm_form_name(form));
    return ends_with(line->file, ending)
           || (within && within->is_library && strcmp(within->name, definer) == 0);
}

void shown_line_define(const struct expander *expander, const struct line *line,
                       struct macro *macro)
{
    const struct macro *within = current_macro(expander);
    macro->file = line->file;
    macro->is_library = is_library(line->file);
    macro->form = has_form(line, within, ASM_SCALAR_FORM)   ? ASM_SCALAR_FORM
                  : has_form(line, within, ASM_VECTOR_FORM) ? ASM_VECTOR_FORM
                                                            : ASM_NO_FORM;
}

/* Adds the form of an operation to the macro calls around its call, so that those
 * macros count as formulas. Ends at another operation, and at a macro of another file
 * than the formula. */
void shown_line_call(const struct expander *expander)
{
    unsigned i = expander->depth - 1;
    enum asm_form form = expander->frames[i].body->form;
    const char *file = NULL;
    expander->frames[i].call->forms = form;
    while (form && i-- > 0 && expander->frames[i].kind != FRAME_FILE) {
        struct call *call = expander->frames[i].call;
        const struct macro *macro = call->macro;
        if (!macro)
            continue;
        if (macro->form || (file && strcmp(macro->file, file) != 0))
            break;
        call->forms |= form;
        if (!macro->is_library)
            file = macro->file;
    }
}

/* ---- Lines ------------------------------------------------------------------ */

/* Returns the innermost macro call that produced a line, or NULL. */
static const struct call *macro_call(const struct line *line)
{
    const struct call *call = line->call;
    while (call && !call->macro)
        call = call->line->call;
    return call;
}

static bool is_formula(const struct call *call)
{
    return call->forms && !call->macro->form && !call->macro->is_library;
}

const struct line *outermost_line(const struct line *line)
{
    const struct call *call;
    while ((call = macro_call(line)) != NULL)
        line = call->line;
    return line;
}

const struct line *reported_line(const struct line *line)
{
    const struct call *call;
    while (is_library(line->file) && (call = macro_call(line)) != NULL)
        line = call->line;
    return line;
}

const struct line *shown_line(const struct line *line)
{
    const struct line *outermost = outermost_line(line);
    const struct call *call;
    while ((call = macro_call(line)) != NULL && !is_formula(call)
           && strcmp(line->file, outermost->file) != 0)
        line = call->line;
    return line;
}

enum asm_form form_of_line(const struct line *line)
{
    const struct line *shown = shown_line(line);
    const struct call *call = macro_call(line);
    for (; line != shown && !call->forms; call = macro_call(line))
        line = call->line;
    if (!call || (line == shown && !is_formula(call))
        || call->forms == (ASM_SCALAR_FORM | ASM_VECTOR_FORM))
        return ASM_NO_FORM;
    return (enum asm_form)call->forms;
}
