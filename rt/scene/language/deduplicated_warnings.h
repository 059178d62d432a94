/* deduplicated_warnings.h - warnings about features of a scene that are replaced or
 * ignored.
 *
 * A warning has a cause, in words, and a place in the text. It belongs to the value
 * that is being read. The warnings of a named value are reported only if the value
 * becomes part of the scene. Therefore, if a scene includes a library of textures, only
 * the warnings of the textures that it uses are reported.
 *
 * All warnings with the same cause are one report. It contains the number of places,
 * and shows the first place. A library file, which the scene's author did not write,
 * counts as one place.
 */
#ifndef RT_DEDUPLICATED_WARNINGS_H
#define RT_DEDUPLICATED_WARNINGS_H

#include "base/arena.h"
#include "base/diagnostic.h"
#include "rt/scene/language/scene_source.h"

#define MAX_REPORTS 200
enum { MAX_WARNINGS = 100000, WARNING_BUCKETS = 4096 };

/* The warnings of a value. They are freed together with the struct
 * deduplicated_warnings. */
struct value_warnings;

/* The place in the text to which a warning refers. */
struct warning_place {
    const struct scene_source *source;
    size_t at; /* offset in the source */
    struct position position;
};

/* The warnings of a value that is being read. Values nest, so each function that reads
 * a value has its own page, as a local variable. */
struct warning_page {
    struct warning_page *outer; /* page of the enclosing value */
    size_t serial;
    struct value_warnings *list;
};

/* A struct deduplicated_warnings is initialised with zeros. */
struct deduplicated_warnings {
    struct arena arena;
    struct scene_warning *buckets[WARNING_BUCKETS];
    size_t count;
    struct warning_place lost; /* place of the first warning after MAX_WARNINGS, if its
                                * source is not NULL */
    struct warning_page *page; /* page of the current value; NULL: the scene itself */
    size_t pages;
    struct warning_cause *causes, *last_cause; /* reported warnings, in order */
    size_t cause_count;
};

/* Records a warning. `calls` lists the macro calls that lead to the place; it may be
 * empty. */
void scene_warning_add(struct deduplicated_warnings *book,
                       const struct warning_place *place, const char *words,
                       const char *calls);
/* Records a warning that is reported even if its value is not used. */
void scene_warning_report(struct deduplicated_warnings *book,
                          const struct warning_place *place, const char *words,
                          const char *calls);

/* These functions begin and end the reading of a value. Warnings that are recorded in
 * between belong to the value. value_warnings_end returns NULL if there are none. */
void value_warnings_begin(struct deduplicated_warnings *book,
                          struct warning_page *page);
struct value_warnings *value_warnings_end(struct deduplicated_warnings *book);
/* Adds the warnings of a value to the value that is being read, which uses it. */
void value_warnings_use(struct deduplicated_warnings *book,
                        struct value_warnings *list);

/* Adds one report for each cause of warnings to `reports`, with this severity. */
void warnings_report(const struct deduplicated_warnings *book, enum severity severity,
                     struct diagnostics *reports);
/* Returns true if warnings were lost because there was no memory. */
bool warnings_failed(const struct deduplicated_warnings *book);
void warnings_free(struct deduplicated_warnings *book);

#endif
