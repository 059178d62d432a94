/* note.h - what a scene's text asks for and does not get.
 *
 * Something that is replaced or left out is a note: a cause, in words, and the
 * place in the text.  Notes belong to what is being read.  A value with a name
 * keeps those of its text, and they are told when it becomes part of the
 * scene, if ever: who includes a library of textures and uses one hears of
 * that one.
 *
 * What is told of one cause is one report, which counts the places and shows
 * the first.  A file of a library, which the scene's author did not write, is
 * one place.
 */
#ifndef RT_SCENE_NOTE_H
#define RT_SCENE_NOTE_H

#include "base/arena.h"
#include "base/diagnostic.h"
#include "rt/scene/language/source.h"

#define MAX_REPORTS 200
enum { MAX_NOTES = 100000, NOTE_BUCKETS = 4096 };

/* Those of a value; they last as long as the deduplicated warnings. */
struct notes;

/* Where one is. */
struct note_place {
    const struct scene_source *source;
    size_t at; /* offset in it */
    struct position position;
};

/* The notes of a value that is being read: on the stack of who reads it. */
struct note_page {
    struct note_page *outer; /* of the value that this one is in */
    size_t serial;
    struct notes *notes;
};

/* Zero it to begin. */
struct deduplicated_warnings {
    struct arena arena;
    struct note *buckets[NOTE_BUCKETS];
    size_t count;
    struct note_place lost; /* the first beyond MAX_NOTES, if it has a
                               source */
    struct note_page *page; /* NULL: the scene itself */
    size_t pages;
    struct note_cause *causes, *last_cause; /* told, in their order */
    size_t cause_count;
};

/* `calls` says which macros lead to the place, and may be empty. */
void note_add(struct deduplicated_warnings *book, const struct note_place *place,
              const char *words, const char *calls);
/* The same, told in any case. */
void note_report(struct deduplicated_warnings *book, const struct note_place *place,
                 const char *words, const char *calls);

/* What is added in between is that of a value: NULL if nothing is. */
void notes_begin(struct deduplicated_warnings *book, struct note_page *page);
struct notes *notes_end(struct deduplicated_warnings *book);
/* What is added in between is the scene's, whatever is being read. */
struct note_page *notes_suspend(struct deduplicated_warnings *book);
void notes_resume(struct deduplicated_warnings *book, struct note_page *page);
/* A value with these notes becomes part of what is being read. */
void notes_use(struct deduplicated_warnings *book, struct notes *notes);

/* All that is told, as reports or as errors. */
void warnings_report(const struct deduplicated_warnings *book, enum severity severity,
                     struct diagnostics *reports);
/* Notes are lost for want of memory. */
bool warnings_failed(const struct deduplicated_warnings *book);
void warnings_free(struct deduplicated_warnings *book);

#endif
