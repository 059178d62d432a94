/* svg.c - writes the common parts of SVG pictures. */
#include "base/svg.h"

void svg_put_escaped(const struct sink *sink, const char *text)
{
    char letter[2] = "";
    for (; *text; text++) {
        letter[0] = *text;
        sink_put(sink, *text == '<'                 ? "&lt;"
                       : *text == '>'               ? "&gt;"
                       : *text == '&'               ? "&amp;"
                       : (unsigned char)*text < ' ' ? " "
                                                    : letter);
    }
}

void svg_begin(const struct sink *sink, const struct svg_sheet *sheet,
               const char *title)
{
    sink_print(sink,
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" "
               "height=\"%d\" viewBox=\"0 0 %d %d\" "
               "font-family=\"sans-serif\" font-size=\"12\">\n",
               sheet->width, sheet->height, sheet->width, sheet->height);
    sink_print(sink,
               "<style>%s</style>\n"
               "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
               sheet->style);
    sink_print(sink, "<text x=\"%d\" y=\"20\" font-size=\"15\">", sheet->left);
    svg_put_escaped(sink, title);
    sink_put(sink, "</text>\n");
}

void svg_end(const struct sink *sink)
{
    sink_put(sink, "</svg>\n");
}

uint64_t svg_round_step(uint64_t span, uint64_t most)
{
    static const unsigned parts[] = { 1, 2, 5 };
    uint64_t power = 1;
    for (;; power *= 10) {
        for (int i = 0; i < 3; i++)
            if (span / (power * parts[i]) <= most)
                return power * parts[i];
    }
}
