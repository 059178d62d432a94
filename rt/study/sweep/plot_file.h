/* plot_file.h - writes a plot to a file, NAME.svg or NAME.png.
 *
 * A .png is made from the .svg beside it by rsvg-convert, which must be installed.
 */
#ifndef RT_SWEEP_PLOT_FILE_H
#define RT_SWEEP_PLOT_FILE_H

#include "base/plot.h"

/* Checks that the path can be written. Call it before the work for a plot, to reject a
 * name that does not end in .svg or .png, or a missing folder. */
bool plot_check_path(const char *path, c205_error *error);
/* Returns true if the ending is that of a plot. */
bool plot_is_named(const char *path);

enum { PLOT_PATH = 4096 };
/* Writes the path of the .svg of a plot. Returns false if it is too long. */
bool plot_svg_path(const char *path, char svg[PLOT_PATH]);

/* Writes NAME.svg, and NAME.png if the path has that name, each completely or not at
 * all. If rsvg-convert fails or is not installed, which the error reports, the .svg
 * remains. */
bool plot_write(const struct plot *plot, const struct table *table, const char *path,
                c205_error *error);

#endif
