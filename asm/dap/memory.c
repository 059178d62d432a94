/* memory.c - responds with memory, as bytes in base64 or as instructions.
 *
 * An address is an address of the machine, in bits. Offsets and counts are bytes, as
 * the protocol requires. Byte 0 of a word is the leftmost byte.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/dap/dap_internal.h"
#include "asm/object/disassemble.h"
#include "asm/view/word_text.h"

/* ---- Base64 -------------------------------------------------------------- */

static const char digits[] =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/* Writes bytes in base64: three bytes as four digits. "=" replaces the digits of absent
 * bytes. */
static void put_base64(const struct sink *sink, const unsigned char *bytes,
                       size_t count)
{
    for (size_t i = 0; i < count; i += 3) {
        unsigned long three = (unsigned long)bytes[i] << 16;
        char text[5];
        if (i + 1 < count)
            three |= (unsigned long)bytes[i + 1] << 8;
        if (i + 2 < count)
            three |= bytes[i + 2];
        for (unsigned k = 0; k < 4; k++)
            text[k] = i + k > count ? '=' : digits[three >> (18 - 6 * k) & 63];
        text[4] = '\0';
        sink_put(sink, text);
    }
}

/* Decodes base64. bytes and text may have the same address. Returns false if the text
 * is not base64. */
static bool read_base64(const char *text, unsigned char *bytes, size_t *count)
{
    unsigned long bits = 0;
    size_t length = strlen(text), n = 0;
    *count = 0;
    while (length > 0 && text[length - 1] == '=' && n < 2) {
        length--;
        n++;
    }
    if ((length + n) % 4 != 0 || length % 4 == 1)
        return false;
    for (size_t i = 0; i < length; i++) {
        const char *digit = strchr(digits, text[i]);
        if (!digit)
            return false;
        bits = (bits << 6 | (unsigned long)(digit - digits)) & 0xFFFFFF;
        if (i % 4 > 0)
            bytes[(*count)++] = (unsigned char)(bits >> (6 - 2 * (i % 4)));
    }
    return true;
}

/* ---- Bytes --------------------------------------------------------------- */

enum { MAX_BYTES = 1 << 20 };

static bool read_place(struct dap *dap, uint64_t *address)
{
    return dap_address(dap, dap->arguments, "memoryReference", address)
           && (*address % 8 == 0 || dap_fault(dap, "no byte begins at this address"));
}

/* Reads a byte. Returns false if the memory is not mapped. */
static bool read_byte(const struct dap *dap, uint64_t address, unsigned char *byte)
{
    c205_word word;
    if (address >> 48
        || !c205_read(machine_of(dap->debugger), address - address % 64, &word, 1))
        return false;
    *byte = (unsigned char)(word >> (56 - address % 64));
    return true;
}

/* Reads the bytes from an address up to the first unmapped byte, at most `count`.
 * Returns their number. If bytes is NULL, they are only counted. */
static size_t read_bytes(const struct dap *dap, uint64_t address, unsigned char *bytes,
                         size_t count)
{
    unsigned char byte;
    size_t there = 0;
    while (
        there < count
        && read_byte(dap, address + 8 * (uint64_t)there, bytes ? &bytes[there] : &byte))
        there++;
    return there;
}

bool request_read_memory(struct dap *dap)
{
    struct text_buffer text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    unsigned char *bytes;
    uint64_t address;
    int64_t count = -1;
    size_t there;
    if (!read_place(dap, &address) || !dap_whole(dap, dap->arguments, "count", &count))
        return false;
    if (count < 0 || count > MAX_BYTES)
        return dap_fault(dap, "'count' must be between 0 and %d bytes", MAX_BYTES);
    bytes = malloc((size_t)count + 1);
    if (!bytes)
        return dap_fault(dap, "out of memory");
    there = read_bytes(dap, address, bytes, (size_t)count);
    dap_put_address(dap->body, "address", address);
    if (there < (size_t)count)
        json_count(dap->body, "unreadableBytes", (size_t)count - there);
    put_base64(&sink, bytes, there);
    json_text(dap->body, "data", text.text ? text.text : "");
    text_buffer_free(&text);
    free(bytes);
    return true;
}

/* Writes all bytes. If allowPartial is set, it may write only the bytes before the
 * first unmapped byte. */
static bool write_bytes(struct dap *dap, const unsigned char *bytes, size_t count)
{
    uint64_t address;
    size_t there;
    if (!read_place(dap, &address))
        return false;
    there = read_bytes(dap, address, NULL, count);
    if (there < count && !json_member_truth(dap->arguments, "allowPartial", false))
        return dap_fault(dap, "of %zu bytes only %zu are in memory", count, there);
    if (!debug_set_bytes(dap->debugger, address, bytes, there))
        return false;
    json_number(dap->body, "offset", 0);
    json_count(dap->body, "bytesWritten", there);
    return true;
}

bool request_write_memory(struct dap *dap)
{
    const char *text = json_member_text(dap->arguments, "data");
    unsigned char *bytes;
    size_t count;
    bool good;
    if (!text)
        return dap_fault(dap, "'data' is missing");
    bytes = malloc(strlen(text) + 1);
    if (!bytes)
        return dap_fault(dap, "out of memory");
    good = (read_base64(text, bytes, &count) || dap_fault(dap, "'data' is not base64"))
           && write_bytes(dap, bytes, count);
    free(bytes);
    return good;
}

/* ---- Instructions -------------------------------------------------------- */

/* Returns the address that is a number of instructions after this address, or before it
 * if the number is negative. */
static uint64_t move_address(const struct dap *dap, uint64_t address,
                             int64_t instructions)
{
    struct instruction_view view;
    for (; instructions < 0 && address > 0; instructions++)
        address = place_before(dap->debugger, address);
    for (; instructions > 0 && address >> 48 == 0; instructions--) {
        view_decode(&view, machine_of(dap->debugger), address);
        address += 32 * (uint64_t)view.halves;
    }
    return address;
}

static void put_origin(struct dap *dap, struct json *body, uint64_t address)
{
    const struct asm_line *line = object_line(dap->object, address);
    const char *label = object_label(dap->object, address);
    if (*label)
        json_text(body, "symbol", label);
    if (!line)
        return;
    json_object(body, "location");
    put_source_members(dap, body, line->file);
    json_end(body);
    put_line(dap, body, "line", line->number);
}

/* Writes an instruction. Returns the address of the next instruction. */
static uint64_t put_instruction(struct dap *dap, struct json *body, uint64_t address)
{
    c205 *machine = machine_of(dap->debugger);
    c205_word word = view_word_at(machine, address), there;
    char text[DISASSEMBLE_TEXT_SIZE];
    struct instruction_view view;
    struct word_text code;
    view_decode(&view, machine, address);
    code = word_text(word, view.halves == 1);
    json_object(body, NULL);
    dap_put_address(body, "address", address);
    if (c205_read(machine, address - address % 64, &there, 1)) {
        disassemble_one(word, address, text);
        json_text(body, "instructionBytes", code.hex);
        json_text(body, "instruction", text);
        put_origin(dap, body, address);
    } else {
        json_text(body, "instruction", "no memory is mapped there");
        json_text(body, "presentationHint", "invalid");
    }
    json_end(body);
    return (address + 32 * (uint64_t)view.halves) & ((UINT64_C(1) << 48) - 1);
}

/* Disassembles memory. The response has exactly the requested number of instructions,
 * even for unmapped memory. */
bool request_disassemble(struct dap *dap)
{
    enum { MAX_INSTRUCTIONS = 10000 };
    int64_t from = 0, count = -1;
    uint64_t address;
    if (!dap_address(dap, dap->arguments, "memoryReference", &address)
        || !dap_whole(dap, dap->arguments, "instructionOffset", &from)
        || !dap_whole(dap, dap->arguments, "instructionCount", &count))
        return false;
    if (address % 32 != 0)
        return dap_fault(dap, "no instruction begins at this address");
    if (count < 0 || count > MAX_INSTRUCTIONS || from > MAX_INSTRUCTIONS
        || from < -MAX_INSTRUCTIONS)
        return dap_fault(dap, "'instructionCount' must be between 0 and %d",
                         MAX_INSTRUCTIONS);
    address = move_address(dap, address, from);
    json_array(dap->body, "instructions");
    for (; count > 0; count--)
        address = put_instruction(dap, dap->body, address);
    json_end(dap->body);
    return true;
}
