/* print.c - prints the output of a program: numbers, texts and vectors. */
#include "asm/view/print.h"

#include <inttypes.h>

/* Reads element i of a vector, right-aligned. Elements have 1, 8 or 64 bits. If the
 * element is not mapped, prints a note and returns false. */
static bool fetch(const struct printer *printer, const c205 *machine,
                  c205_word descriptor, unsigned i, unsigned bits, c205_word *element)
{
    uint64_t address = c205_descriptor_address(descriptor) / bits * bits;
    c205_word word;
    address = c205_descriptor_address(address + (uint64_t)i * bits);
    if (!c205_read(machine, address / 64 * 64, &word, 1)) {
        sink_print(&printer->sink, "(unmapped address %" PRIX64 ")", address);
        return false;
    }
    *element = word << address % 64 >> (64 - bits);
    return true;
}

/* The layout of printed numbers, as register S of a print request specifies it. */
struct number_columns {
    unsigned notation; /* 0: shortest; otherwise 1 + c205_notation */
    unsigned width;    /* minimum width; shorter numbers are padded with blanks */
    unsigned digits;
    unsigned in_line; /* elements of a vector per line; 0: all */
};

static struct number_columns columns_of(c205_word word)
{
    return (struct number_columns){ .notation = (unsigned)(word >> 32 & 0xFF),
                                    .width = (unsigned)(word >> 8 & 0xFF),
                                    .digits = (unsigned)(word & 0xFF),
                                    .in_line = (unsigned)(word >> 16 & 0xFFFF) };
}

static void put_number(const struct printer *printer, c205_word word,
                       const struct number_columns *columns)
{
    char text[C205_TEXT_SIZE];
    if (columns->notation == 0)
        c205_to_text(word, text);
    else
        c205_to_decimal(word,
                        columns->notation - 1 == C205_FIXED ? C205_FIXED
                                                            : C205_SCIENTIFIC,
                        columns->digits, text);
    sink_print(&printer->sink, "%*s", (int)columns->width, text);
}

static void print_number(const struct printer *printer, const c205 *machine,
                         const c205_event *event)
{
    struct number_columns columns = columns_of(event->s);
    (void)machine;
    put_number(printer, event->r, &columns);
}

static void print_integer(const struct printer *printer, const c205 *machine,
                          const c205_event *event)
{
    (void)machine;
    sink_print(&printer->sink, "%*" PRId64, (int)columns_of(event->s).width,
               c205_to_integer(event->r));
}

static void print_hex(const struct printer *printer, const c205 *machine,
                      const c205_event *event)
{
    char text[C205_TEXT_SIZE];
    (void)machine;
    c205_to_hex(event->r, text);
    sink_put(&printer->sink, text);
}

static void print_text(const struct printer *printer, const c205 *machine,
                       const c205_event *event)
{
    c205_word byte;
    char c;
    for (unsigned i = 0; i < c205_descriptor_length(event->r); i++) {
        if (!fetch(printer, machine, event->r, i, 8, &byte))
            return;
        c = (char)byte;
        printer->sink.put(printer->sink.context, &c, 1);
    }
}

static void print_newline(const struct printer *printer, const c205 *machine,
                          const c205_event *event)
{
    (void)machine;
    (void)event;
    sink_put(&printer->sink, "\n");
}

static void print_vector(const struct printer *printer, const c205 *machine,
                         const c205_event *event)
{
    struct number_columns columns = columns_of(event->s);
    c205_word word;
    for (unsigned i = 0; i < c205_descriptor_length(event->r); i++) {
        if (i > 0)
            sink_put(&printer->sink,
                     columns.in_line && i % columns.in_line == 0 ? "\n" : " ");
        if (!fetch(printer, machine, event->r, i, 64, &word))
            return;
        put_number(printer, word, &columns);
    }
}

static void print_bits(const struct printer *printer, const c205 *machine,
                       const c205_event *event)
{
    c205_word bit;
    for (unsigned i = 0; i < c205_descriptor_length(event->r); i++) {
        if (!fetch(printer, machine, event->r, i, 1, &bit))
            return;
        sink_put(&printer->sink, bit ? "1" : "0");
    }
}

void printer_listen(void *context, const c205 *machine, const c205_event *event)
{
    static void (*const requests[])(const struct printer *, const c205 *,
                                    const c205_event *) = {
        NULL,       print_number,  print_integer, print_hex,
        print_text, print_newline, print_vector,  print_bits
    };
    const struct printer *printer = context;
    if (event->kind != C205_EVENT_REQUEST || event->request == 0
        || event->request >= sizeof requests / sizeof *requests)
        return;
    requests[event->request](printer, machine, event);
}
