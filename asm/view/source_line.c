/* source_line.c - prints the source line of an instruction. */
#include "asm/view/source_line.h"

#include <string.h>

void source_line_place(const struct asm_place *place, const struct sink *sink)
{
    const char *slash = strrchr(place->file, '/');
    sink_print(sink, "%s:%zu", slash ? slash + 1 : place->file, place->number);
}

static void put_source(const struct asm_place *place, enum asm_form form,
                       const struct sink *sink)
{
    source_line_place(place, sink);
    sink_print(sink, form ? " (%s): %s" : "%s: %s", asm_form_name(form),
               place->source + strspn(place->source, " \t\r\v\f"));
}

void source_line_innermost(const struct asm_line *line, const struct sink *sink)
{
    const struct asm_place place = { line->file, line->number, line->source, false };
    put_source(&place, ASM_NO_FORM, sink);
}

/* If an instruction is shown at its own line, the source is printed with the arguments
 * of the macro. */
void source_line_shown(const struct asm_line *line, const struct sink *sink)
{
    struct asm_place place = line->shown;
    if (asm_place_is(&place, line->file, line->number))
        place.source = line->source;
    put_source(&place, line->form, sink);
}
