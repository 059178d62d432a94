/* frames.c - describes the current location as stack frames, and the source files of
 * the program. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/dap/dap_internal.h"
#include "base/file.h"
#include "base/text_file.h"
#include "vm/text.h"

/* ---- Files --------------------------------------------------------------- */

size_t file_index(const struct dap *dap, const char *file)
{
    size_t i = 0;
    while (i < dap->file_count && (!file || strcmp(dap->files[i], file) != 0))
        i++;
    return i;
}

static bool add_file(struct dap *dap, const char *file, size_t *capacity)
{
    return file_index(dap, file) < dap->file_count
           || arena_add(&dap->launched, &dap->files, &dap->file_count, capacity, &file,
                        sizeof file);
}

bool sources_find(struct dap *dap)
{
    size_t capacity = 0;
    dap->file_count = 0;
    for (size_t i = 0; i < dap->object->line_count; i++)
        if (!add_file(dap, dap->object->lines[i].file, &capacity)
            || !add_file(dap, dap->object->lines[i].shown.file, &capacity)
            || !add_file(dap, dap->object->lines[i].call.file, &capacity))
            return false;
    return true;
}

/* Returns the text of a library file that is compiled into c205, or NULL. Such a file
 * has no path. */
static const struct text *carried(const char *file)
{
    return text_find(library_texts, file);
}

static bool has_folder(const struct dap *dap, const char *file)
{
    return *file != '/' && *dap->setup.folder;
}

/* Returns the absolute path of a source file, or NULL if memory is exhausted. */
static char *path_of(const struct dap *dap, const char *file)
{
    struct text_buffer path = { 0 };
    struct sink sink = text_buffer_sink(&path);
    if (has_folder(dap, file)) {
        sink_put(&sink, dap->setup.folder);
        sink_put(&sink, "/");
    }
    sink_put(&sink, file);
    return path.text;
}

static bool is_path(const struct dap *dap, const char *file, const char *path)
{
    char *whole = carried(file) ? NULL : path_of(dap, file);
    bool same = whole && (strcmp(whole, path) == 0 || file_is_one(whole, path));
    free(whole);
    return same;
}

const char *source_file(const struct dap *dap, const struct json_value *source)
{
    const char *path = json_member_text(source, "path");
    const char *name = json_member_text(source, "name");
    int64_t number = 0;
    json_member_whole(source, "sourceReference", &number);
    if (number > 0)
        return (uint64_t)number <= dap->file_count ? dap->files[number - 1] : NULL;
    for (size_t i = 0; i < dap->file_count; i++)
        if (path ? is_path(dap, dap->files[i], path)
                 : name && strcmp(dap->files[i], name) == 0)
            return dap->files[i];
    return NULL;
}

void put_source_members(struct dap *dap, struct json *json, const char *file)
{
    const char *slash = strrchr(file, '/');
    char *path = carried(file) ? NULL : path_of(dap, file);
    json_text(json, "name", slash ? slash + 1 : file);
    if (path) {
        json_text(json, "path", path);
    } else {
        json_count(json, "sourceReference", file_index(dap, file) + 1);
        json_text(json, "origin", "the library of c205");
    }
    free(path);
}

void put_source(struct dap *dap, struct json *json, const char *file)
{
    json_object(json, "source");
    put_source_members(dap, json, file);
    json_end(json);
}

bool request_loaded_sources(struct dap *dap)
{
    json_array(dap->body, "sources");
    for (size_t i = 0; i < dap->file_count; i++) {
        json_object(dap->body, NULL);
        put_source_members(dap, dap->body, dap->files[i]);
        json_end(dap->body);
    }
    json_end(dap->body);
    return true;
}

/* ---- Texts of the files -------------------------------------------------- */

static char *text_of(struct dap *dap, const char *file)
{
    const struct text *text = carried(file);
    struct text_buffer whole = { 0 };
    struct sink sink = text_buffer_sink(&whole);
    c205_error error;
    size_t length;
    if (!text) {
        char *path = path_of(dap, file);
        char *read = path ? text_file_read(path, FILE_LARGEST, &length, &error) : NULL;
        if (!read)
            dap_fault(dap, "%s: %s", file, path ? error.message : "out of memory");
        free(path);
        return read;
    }
    text_put(text, &sink);
    return whole.text;
}

bool request_source(struct dap *dap)
{
    const struct json_value *source = json_member(dap->arguments, "source");
    const char *file = source_file(dap, source ? source : dap->arguments);
    char *text;
    if (!file)
        return dap_fault(dap, "expected the path of a source file in 'source'");
    text = text_of(dap, file);
    if (!text)
        return false;
    json_text(dap->body, "content", text);
    json_text(dap->body, "mimeType", "text/x-c205");
    free(text);
    return true;
}

/* ---- Lines --------------------------------------------------------------- */

size_t line_of(const struct dap *dap, int64_t line)
{
    line += 1 - dap->first_line;
    return line > 0 ? (size_t)line : 0;
}

void put_line(const struct dap *dap, struct json *json, const char *key, size_t line)
{
    json_number(json, key, (double)line - 1 + (double)dap->first_line);
}

/* ---- Frames -------------------------------------------------------------- */

bool request_threads(struct dap *dap)
{
    (void)dap;
    json_array(dap->body, "threads");
    json_object(dap->body, NULL);
    json_number(dap->body, "id", 1);
    json_text(dap->body, "name", "the machine");
    json_end(dap->body);
    json_end(dap->body);
    return true;
}

/* The frames, innermost first: the instruction, the line at which it is shown, the
 * outermost macro call that contains it, and the region. */
enum frame_of { FRAME_PLACE, FRAME_SHOWN, FRAME_CALL, FRAME_REGION, FRAMES };

struct frames {
    uint64_t pc;
    const struct asm_line *line; /* NULL: unknown */
    const char *region;
    size_t count;
    enum frame_of kinds[FRAMES];
};

static struct frames find_frames(const struct dap *dap)
{
    uint64_t pc = c205_pc(machine_of(dap->debugger));
    struct frames frames = { .pc = pc,
                             .line = object_line(dap->object, pc),
                             .region = object_region(dap->object, pc) };
    frames.kinds[frames.count++] = FRAME_PLACE;
    if (frames.line
        && !asm_place_is(&frames.line->shown, frames.line->file, frames.line->number))
        frames.kinds[frames.count++] = FRAME_SHOWN;
    if (frames.line
        && !asm_place_is(&frames.line->call, frames.line->shown.file,
                         frames.line->shown.number))
        frames.kinds[frames.count++] = FRAME_CALL;
    if (*frames.region)
        frames.kinds[frames.count++] = FRAME_REGION;
    return frames;
}

/* Returns the last label at or before an address, or NULL if there is none. */
static const struct asm_symbol *label_before(const struct dap *dap, uint64_t address)
{
    const struct asm_symbol *found = NULL;
    for (size_t i = 0; i < dap->object->symbol_count; i++) {
        const struct asm_symbol *symbol = &dap->object->symbols[i];
        if (symbol->is_label && (uint64_t)symbol->value <= address
            && (!found || symbol->value > found->value))
            found = symbol;
    }
    return found;
}

/* Writes the name of a frame: its address relative to the label before it, as in "again
 * + 64", or the address alone. */
static void put_name(const struct dap *dap, struct json *body, uint64_t address)
{
    const struct asm_symbol *label = label_before(dap, address);
    struct text_line text = { .length = 0 };
    struct sink sink = text_line_sink(&text);
    if (!label)
        sink_print(&sink, "%llX", (unsigned long long)address);
    else if ((uint64_t)label->value == address)
        sink_print(&sink, "%s", label->name);
    else
        sink_print(&sink, "%s + %llu", label->name,
                   (unsigned long long)(address - (uint64_t)label->value));
    json_text(body, "name", text.text);
}

static void put_frame_place(struct dap *dap, struct json *body, const char *file,
                            size_t line)
{
    put_source(dap, body, file);
    put_line(dap, body, "line", line);
    json_number(body, "column", (double)dap->first_column);
}

/* Writes line 0 for a frame without a source line. */
static void put_no_place(struct json *body)
{
    json_number(body, "line", 0);
    json_number(body, "column", 0);
}

static void put_macro_call(struct dap *dap, struct json *body,
                           const struct asm_place *place, enum asm_form form)
{
    const char *from = place->source;
    struct text_line text = { .length = 0 };
    struct sink sink = text_line_sink(&text);
    while (isspace((unsigned char)*from))
        from++;
    sink_print(&sink, form ? "%.*s (%s)" : "%.*s", (int)strcspn(from, "\n;"), from,
               asm_form_name(form));
    json_text(body, "name", text.text);
    put_frame_place(dap, body, place->file, place->number);
}

static void put_frame(struct dap *dap, struct json *body, const struct frames *frames,
                      size_t i)
{
    json_object(body, NULL);
    json_count(body, "id", i + 1);
    switch (frames->kinds[i]) {
    case FRAME_PLACE:
        put_name(dap, body, frames->pc);
        dap_put_address(body, "instructionPointerReference", frames->pc);
        if (frames->line)
            put_frame_place(dap, body, frames->line->file, frames->line->number);
        else
            put_no_place(body);
        break;
    case FRAME_SHOWN:
        put_macro_call(dap, body, &frames->line->shown, frames->line->form);
        break;
    case FRAME_CALL: put_macro_call(dap, body, &frames->line->call, ASM_NO_FORM); break;
    default:
        json_text(body, "name", frames->region);
        json_text(body, "presentationHint", "label");
        put_no_place(body);
    }
    json_end(body);
}

bool request_stack_trace(struct dap *dap)
{
    struct frames frames = find_frames(dap);
    int64_t from = 0, levels = 0;
    if (!dap_whole(dap, dap->arguments, "startFrame", &from)
        || !dap_whole(dap, dap->arguments, "levels", &levels))
        return false;
    if (from < 0 || levels < 0)
        return dap_fault(dap, "frame numbers must not be negative");
    json_array(dap->body, "stackFrames");
    for (size_t i = 0; i < frames.count; i++)
        if (i >= (size_t)from && (levels == 0 || i - (size_t)from < (size_t)levels))
            put_frame(dap, dap->body, &frames, i);
    json_end(dap->body);
    json_count(dap->body, "totalFrames", frames.count);
    return true;
}
