/* deduplicated_warnings.h - warnings about features of a scene that are replaced or
 * ignored.
 *
 * A warning has a cause, in words, and a place in the text. Warnings belong to the
 * value that is being read. A named value keeps the warnings of its text; they are
 * reported when the value becomes part of the scene. A scene that includes a library of
 * textures and uses one of them therefore has the reports of that one only.
 *
 * All warnings with the same cause are one report, which has the number of places and
 * shows the first. A library file, which the scene's author did not write, counts as
 * one place.
 */
#ifndef RT_SCENE_NOTE_H
#define RT_SCENE_NOTE_H

#include "base/arena.h"
#include "base/diagnostic.h"
#include "rt/scene/language/scene_source.h"

#define MAX_REPORTS 200
enum { MAX_WARNINGS = 100000, WARNING_BUCKETS = 4096 };

/* The warnings of a value, which live as long as the deduplicated_warnings. */
struct value_warnings;

/* The place of a warning. */
struct warning_place {
    const struct scene_source *source;
    size_t at; /* offset in it */
    struct position position;
};

/* The warnings of a value that is being read. The page is on the stack of the function
 * that reads it. */
struct warning_page {
    struct warning_page *outer; /* of the enclosing value */
    size_t serial;
    struct value_warnings *list;
};

/* A struct deduplicated_warnings is initialised with zeros. */
struct deduplicated_warnings {
    struct arena arena;
    struct scene_warning *buckets[WARNING_BUCKETS];
    size_t count;
    struct warning_place lost; /* first beyond MAX_WARNINGS, if it has a source */
    struct warning_page *page; /* the current value; NULL: the scene itself */
    size_t pages;
    struct warning_cause *causes, *last_cause; /* reported, in order */
    size_t cause_count;
};

/* Records a warning. `calls` lists the macro calls that lead to the place, and may be
 * empty. */
void scene_warning_add(struct deduplicated_warnings *book,
                       const struct warning_place *place, const char *words,
                       const char *calls);
/* Records a warning that is reported even if its value is not used. */
void scene_warning_report(struct deduplicated_warnings *book,
                          const struct warning_place *place, const char *words,
                          const char *calls);

/* Begin and end a value: warnings recorded in between belong to it.
 * value_warnings_end returns NULL if there are none. */
void value_warnings_begin(struct deduplicated_warnings *book,
                          struct warning_page *page);
struct value_warnings *value_warnings_end(struct deduplicated_warnings *book);
/* Adds the warnings of a value that is used by the one that is being read. */
void value_warnings_use(struct deduplicated_warnings *book,
                        struct value_warnings *list);

/* Adds the reports to `reports`, with this severity. */
void warnings_report(const struct deduplicated_warnings *book, enum severity severity,
                     struct diagnostics *reports);
/* Returns true if warnings were lost because memory was exhausted. */
bool warnings_failed(const struct deduplicated_warnings *book);
void warnings_free(struct deduplicated_warnings *book);

#endif
