/* plot_file.h - writes a plot to a file NAME.svg or NAME.png.
 *
 * rsvg-convert, which must be installed, converts the .svg to a .png in the same
 * folder.
 */
#ifndef RT_SWEEP_PLOT_FILE_H
#define RT_SWEEP_PLOT_FILE_H

#include "base/plot.h"

/* Checks that the path can be written. Call this before the measurements for a plot, to
 * reject a missing folder, or a name that does not end in .svg or .png. */
bool plot_check_path(const char *path, c205_error *error);
/* Returns true if the name ends in .svg or .png. */
bool plot_is_named(const char *path);

enum { PLOT_PATH = 4096 };
/* Computes the path of the .svg of a plot. Returns false if the path is too long. */
bool plot_svg_path(const char *path, char svg[PLOT_PATH]);

/* Writes NAME.svg, and NAME.png if the path has this ending. Each file is written
 * completely or not at all. If rsvg-convert fails or is not installed, the error
 * reports it, and the .svg stays. */
bool plot_write(const struct plot *plot, const struct table *table, const char *path,
                c205_error *error);

#endif
