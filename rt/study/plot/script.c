/* script.c - writes the gnuplot script of a plot. */
#include "rt/study/plot/script.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The layout in pixels, from the left and from the bottom. The fonts are those
 * that write_picture names. */
enum {
    WIDTH = 800,
    HEIGHT = 500,
    EDGE = 16,
    LETTER = 7, /* the width of most letters, a little more than many need */
    TITLE = 30, /* its centre, from the upper edge */
    LINE = 16,
    ABOVE = 22,     /* between the small print and the plot */
    BELOW = 58,     /* labels and title of the x axis */
    BESIDE = 52,    /* title of the y axis, without its labels */
    KEY_LEAST = 90, /* room on the right, for labels of marks as well */
    MAX_KEY = 320,
    KEY_SAMPLE = 48
};

/* Colours that colour-blind readers can distinguish: M. Okabe and K. Ito, "Color
 * Universal Design", 2008. Greys replace their black and are used for more curves. */
static const char *const colors[] = {
    "#0072B2", "#D55E00", "#009E73", "#E69F00", "#56B4E9",
    "#CC79A7", "#444444", "#F0E442", "#999999", "#CCCCCC",
};
enum { COLORS = sizeof colors / sizeof *colors };

/* The label of a mark. It begins at the mark's line, which leads to it, or ends at
 * the picture's edge. */
struct flag {
    const struct plot_mark *mark;
    double line, begin, end;
    int row; /* from 0, upwards */
};

struct plot_layout {
    double left, right, top;
    size_t flag_count;
    struct flag *flags;
};

/* ---- Text ----------------------------------------------------------------- */

/* Within gnuplot's single quotes only a single quote is special. */
static void put_quoted(const char *text, FILE *file)
{
    putc('\'', file);
    for (; *text != '\0'; text++) {
        unsigned char letter = (unsigned char)*text;
        if (letter == '\'')
            putc('\'', file);
        putc(letter < ' ' ? ' ' : letter, file);
    }
    putc('\'', file);
}

/* Writes a file name in this folder. Without "./", gnuplot takes a leading '<' or
 * '|' as a command. */
static void put_name(const char *name, size_t length, const char *ending, FILE *file)
{
    fputs("'./", file);
    for (size_t i = 0; i < length; i++)
        fputs(name[i] == '\'' ? "''" : (char[]){ name[i], '\0' }, file);
    fprintf(file, "%s'", ending);
}

/* Returns the width of a text in UTF-8. */
static double width_of(const char *text)
{
    size_t letters = 0;

    for (; *text != '\0'; text++)
        letters += ((unsigned char)*text & 0xC0) != 0x80;
    return LETTER * (double)letters;
}

/* ---- Layout --------------------------------------------------------------- */

static double widest_label(const struct axis *axis)
{
    struct axis_tic tics[AXIS_TICS];
    size_t count = axis_tics(axis, tics);
    double widest = 0;

    for (size_t i = 0; i < count; i++)
        widest = fmax(widest, width_of(tics[i].label));
    return widest;
}

static double key_width(const struct plot *plot)
{
    double widest = 0;

    for (size_t i = 0; i < plot->curve_count; i++)
        widest = fmax(widest, width_of(plot->curves[i].title));
    for (size_t i = 0; i < plot->level_count; i++)
        widest = fmax(widest, width_of(plot->levels[i].label));
    return fmax(KEY_LEAST, fmin(MAX_KEY, KEY_SAMPLE + widest));
}

static int from_right(const void *left, const void *right)
{
    double a = ((const struct flag *)left)->line;
    double b = ((const struct flag *)right)->line;

    return (a < b) - (a > b);
}

/* Returns a row above all labels to the right that the label would cover, or whose
 * lines it would cross. */
static int row_of(const struct flag *flags, size_t i)
{
    int row = 0;

    for (size_t j = 0; j < i; j++)
        if (flags[j].begin < flags[i].end + LETTER && flags[j].row >= row)
            row = flags[j].row + 1;
    return row;
}

static void place_flags(const struct plot *plot, const struct axis *x,
                        struct plot_layout *layout)
{
    struct flag *flags = layout->flags;
    size_t count = 0;

    for (size_t i = 0; i < plot->mark_count; i++) {
        const struct plot_mark *mark = &plot->marks[i];
        double line = layout->left
                      + axis_place(x, mark->at) * (layout->right - layout->left);
        double width = LETTER + width_of(mark->label);
        double begin = fmin(line, WIDTH - EDGE - width);
        if (isfinite(mark->at))
            flags[count++] = (struct flag){ mark, line, begin, begin + width, 0 };
    }
    qsort(flags, count, sizeof *flags, from_right);
    for (size_t i = 0; i < count; i++)
        flags[i].row = row_of(flags, i);
    layout->flag_count = count;
}

/* Returns the number of lines of small print, including the one about cut-off
 * values. */
static size_t small_print(const struct plot *plot, const struct plot_axes *axes)
{
    return plot->subtitle_count + (isfinite(axes->cut_off) ? 1 : 0);
}

static bool lay_out(const struct plot *plot, const struct plot_axes *axes,
                    struct plot_layout *layout)
{
    int rows = 0;

    layout->flags = calloc(plot->mark_count + 1, sizeof *layout->flags);
    if (!layout->flags)
        return false;
    layout->left = BESIDE + widest_label(&axes->y);
    layout->right = WIDTH - key_width(plot);
    place_flags(plot, &axes->x, layout);
    for (size_t i = 0; i < layout->flag_count; i++)
        if (layout->flags[i].row >= rows)
            rows = layout->flags[i].row + 1;
    layout->top = HEIGHT - TITLE - ABOVE
                  - LINE * (double)(small_print(plot, axes) + (size_t)rows);
    return true;
}

/* ---- The script ----------------------------------------------------------- */

static double across(double pixels)
{
    return pixels / WIDTH;
}

static double up(double pixels)
{
    return pixels / HEIGHT;
}

static void write_picture(const char *name, FILE *file)
{
    const char *ending = strrchr(name, '.');
    size_t stem = (size_t)(ending - name);
    bool svg = strcmp(ending, ".svg") == 0;

    fputs("# Draws the plot of the data file. Run gnuplot in the folder of\n"
          "# both files.\n"
          "reset\n"
          "set encoding utf8\n",
          file);
    fprintf(file,
            "set terminal %s size %d,%d noenhanced \\\n"
            "    font 'sans-serif,%d' background rgb 'white'\n",
            svg ? "svg" : "pngcairo", WIDTH, HEIGHT, svg ? 12 : 9);
    fputs("if (!exists('piped')) set output ", file);
    put_name(name, stem, ending, file);
    fputs("\nnumbers = ", file);
    put_name(name, stem, ".dat", file);
    putc('\n', file);
}

static void write_margins(const struct plot_layout *layout, FILE *file)
{
    fprintf(file, "\nset lmargin at screen %.4f\n", across(layout->left));
    fprintf(file, "set rmargin at screen %.4f\n", across(layout->right));
    fprintf(file, "set bmargin at screen %.4f\n", up(BELOW));
    fprintf(file, "set tmargin at screen %.4f\n", up(layout->top));
}

static void write_small_print(const char *text, double left, double height, FILE *file)
{
    fputs("set label ", file);
    put_quoted(text, file);
    fprintf(file,
            " at screen %.4f, screen %.4f font ',11' \\\n"
            "    textcolor rgb '#555555'\n",
            across(left), up(height));
}

static void print_cut_off(const struct plot_axes *axes, double left, double height,
                          FILE *file)
{
    char end[AXIS_LABEL_SIZE], highest[AXIS_LABEL_SIZE], text[128];

    axis_label(end, axes->y.high);
    axis_label(highest, axes->cut_off);
    snprintf(text, sizeof text, "cut off at %s; the highest value is %s", end, highest);
    write_small_print(text, left, height, file);
}

static void write_titles(const struct plot *plot, const struct plot_axes *axes,
                         const struct plot_layout *layout, FILE *file)
{
    double line = HEIGHT - TITLE;

    fputs("\nset label ", file);
    put_quoted(plot->title, file);
    fprintf(file, " at screen %.4f, screen %.4f font ',16'\n", across(layout->left),
            up(line));
    line -= LINE + 4;
    for (size_t i = 0; i < plot->subtitle_count; i++, line -= LINE)
        write_small_print(plot->subtitles[i], layout->left, line, file);
    if (isfinite(axes->cut_off))
        print_cut_off(axes, layout->left, line, file);
}

/* Writes the range of an axis. A logarithmic axis is extended slightly, because
 * gnuplot would otherwise treat a tic at its end as outside. */
static void write_range(char name, const struct axis *axis, FILE *file)
{
    double more = axis->scale != PLOT_LINEAR ? 1e-9 : 0;

    if (axis->scale != PLOT_LINEAR)
        fprintf(file, "set logscale %c %d\n", name, (int)axis->scale);
    fprintf(file, "set %crange [%.12g:%.12g]\n", name, axis->low * (1 - more),
            axis->high * (1 + more));
}

static void write_axis(char name, const char *title, const struct axis *axis,
                       FILE *file)
{
    struct axis_tic tics[AXIS_TICS];
    size_t count = axis_tics(axis, tics);

    fprintf(file, "\nset %clabel offset %s ", name, name == 'x' ? "0,0.5" : "0.5,0");
    put_quoted(title, file);
    putc('\n', file);
    write_range(name, axis, file);
    fprintf(file, "set %ctics nomirror (", name);
    for (size_t i = 0; i < count; i++)
        fprintf(file, "%s'%s' %.12g%s", i ? ", \\\n    " : "", tics[i].label,
                tics[i].at, tics[i].label[0] != '\0' ? "" : " 1");
    fputs(")\n", file);
}

static void write_flag(const struct flag *flag, double top, FILE *file)
{
    double height = top + LINE * (flag->row + 0.5);
    bool moved = flag->begin < flag->line;

    fprintf(file,
            "set arrow from first %.12g, graph 0 to first %.12g, "
            "screen %.4f \\\n    nohead front "
            "linecolor rgb '#444444'\n",
            flag->mark->at, flag->mark->at, up(height + (moved ? -0.5 : 0.4) * LINE));
    fputs("set label ", file);
    put_quoted(flag->mark->label, file);
    if (moved)
        fprintf(file, " at screen %.4f, screen %.4f right\n", across(WIDTH - EDGE),
                up(height));
    else
        fprintf(file, " at first %.12g, screen %.4f offset 0.5,0\n", flag->mark->at,
                up(height));
}

static void write_frame(const struct plot *plot, const struct plot_layout *layout,
                        FILE *file)
{
    bool areas = plot->form == PLOT_AREAS;

    fprintf(file,
            "\nset border 3 linecolor rgb '#555555'\n"
            "set tics out scale 0.5\n"
            "set grid %s linetype 1 linewidth 0.5 linecolor rgb '%s'\n",
            areas ? "front" : "back", areas ? "#A0FFFFFF" : "#DDDDDD");
    fprintf(file,
            "set key at screen %.4f, screen %.4f left top Left "
            "reverse%s \\\n    samplen 2 spacing 1.3\n",
            across(layout->right), up(layout->top), areas ? " invert" : "");
}

/* Draws the area between the sum of the curves before this one and the sum that
 * includes it. */
static void write_area(size_t i, FILE *file)
{
    fprintf(file,
            "numbers using 1:(sum [c=2:%zu] column(c)):"
            "(sum [c=2:%zu] column(c)) \\\n    with filledcurves "
            "fillstyle solid linecolor rgb '%s'",
            i + 1, i + 2, colors[i % COLORS]);
}

/* Curves with the same colour differ in their points. */
static void write_line(size_t i, FILE *file)
{
    fprintf(file,
            "numbers using 1:%zu with linespoints linewidth 2 \\\n"
            "    pointtype %zu pointsize 0.5 linecolor rgb '%s'",
            i + 2, 1 + (6 + 2 * (i % 4) + i / COLORS) % 15, colors[i % COLORS]);
}

static void write_curves(const struct plot *plot, FILE *file)
{
    fputs("\nplot ", file);
    for (size_t i = 0; i < plot->curve_count; i++) {
        fputs(i ? ", \\\n" : "", file);
        if (plot->form == PLOT_AREAS)
            write_area(i, file);
        else
            write_line(i, file);
        fputs(" \\\n    title ", file);
        put_quoted(plot->curves[i].title, file);
    }
    for (size_t i = 0; i < plot->level_count; i++) {
        if (!isfinite(plot->levels[i].at))
            continue;
        fprintf(file,
                ", \\\n%.12g with lines linewidth 1.5 dashtype %zu "
                "linecolor rgb '#000000' \\\n    title ",
                plot->levels[i].at, 2 + i % 4);
        put_quoted(plot->levels[i].label, file);
    }
    putc('\n', file);
}

bool plot_script_write(const struct plot *plot, const struct plot_axes *axes,
                       const char *name, FILE *file)
{
    struct plot_layout layout;

    if (!lay_out(plot, axes, &layout))
        return false;
    write_picture(name, file);
    write_margins(&layout, file);
    write_titles(plot, axes, &layout, file);
    write_axis('x', plot->x.title, &axes->x, file);
    write_axis('y', plot->y.title, &axes->y, file);
    write_frame(plot, &layout, file);
    for (size_t i = 0; i < layout.flag_count; i++)
        write_flag(&layout.flags[i], layout.top, file);
    write_curves(plot, file);
    free(layout.flags);
    return true;
}
