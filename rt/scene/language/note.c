/* note.c - records notes by value, and reports them by cause. */
#include "rt/scene/language/note.h"
#include "base/error.h"

#include "base/hash.h"

#include <stdio.h>
#include <string.h>

/* All reported notes with the same words. */
struct note_cause {
    struct note_cause *next;
    const char *words;
    const struct note *first;
    size_t places;
};

struct note {
    struct note *next; /* in the bucket */
    struct note_place place;
    const char *words, *calls;
    bool reported;
    size_t page; /* serial number of the last page that has it */
};

/* A list node: a note, or all notes of another value; then the rest. */
struct notes {
    struct note *note;
    struct notes *used, *rest;
    bool reported;
    size_t page;           /* serial number of the last page that has it */
    struct notes *waiting; /* stack of nodes to report */
};

/* Returns the offset that distinguishes places; 0 everywhere in a library. */
static size_t offset_of(const struct note_place *place)
{
    return place->source->library ? 0 : place->at;
}

static struct note **bucket_of(struct deduplicated_warnings *book,
                               const struct note_place *place, const char *words)
{
    uint64_t key = hash_bytes(HASH_START, (const unsigned char *)words, strlen(words));

    return &book->buckets[(key + offset_of(place)) % NOTE_BUCKETS];
}

static struct note *new_note(struct deduplicated_warnings *book,
                             const struct note_place *place, const char *words,
                             const char *calls)
{
    struct note *note = NULL;

    if (book->count < MAX_NOTES)
        note = arena_take(&book->arena, sizeof *note);
    else if (!book->lost.source)
        book->lost = *place;
    if (!note)
        return NULL;
    note->place = *place;
    note->words = arena_text(&book->arena, words, strlen(words));
    note->calls = arena_text(&book->arena, calls, strlen(calls));
    if (!note->words || !note->calls)
        return NULL;
    book->count++;
    return note;
}

/* Returns the note with this place and these words; it is created if there is none.
 * Returns NULL if there are too many, or without memory. */
static struct note *note_of(struct deduplicated_warnings *book,
                            const struct note_place *place, const char *words,
                            const char *calls)
{
    struct note **bucket = bucket_of(book, place, words);
    struct note *note = *bucket;

    while (note
           && (note->place.source != place->source
               || offset_of(&note->place) != offset_of(place)
               || strcmp(note->words, words)))
        note = note->next;
    if (note)
        return note;
    note = new_note(book, place, words, calls);
    if (!note)
        return NULL;
    note->next = *bucket;
    return *bucket = note;
}

/* ---- Reports ------------------------------------------------------------- */

static struct note_cause *cause_of(struct deduplicated_warnings *book,
                                   const struct note *note)
{
    struct note_cause *cause = book->causes;

    while (cause && strcmp(cause->words, note->words))
        cause = cause->next;
    if (cause || book->cause_count > MAX_REPORTS)
        return cause;
    cause = arena_take(&book->arena, sizeof *cause);
    if (!cause)
        return NULL;
    cause->words = note->words;
    cause->first = note;
    if (book->last_cause)
        book->last_cause->next = cause;
    else
        book->causes = cause;
    book->cause_count++;
    return book->last_cause = cause;
}

static void add_report(struct deduplicated_warnings *book, struct note *note)
{
    struct note_cause *cause = note->reported ? NULL : cause_of(book, note);

    note->reported = true;
    if (cause)
        cause->places++;
}

static void report(const struct note_cause *cause, enum severity severity,
                   struct diagnostics *reports)
{
    const struct note *first = cause->first;
    char message[2000];
    int length = snprintf(message, sizeof message, "%s%s", first->words, first->calls);

    if (cause->places > 1 && length >= 0 && (size_t)length < sizeof message)
        snprintf(message + length, sizeof message - (size_t)length,
                 " (%zu places, this is the first)", cause->places);
    diagnostics_add(reports, severity, &first->place.position, message);
}

void warnings_report(const struct deduplicated_warnings *book, enum severity severity,
                     struct diagnostics *reports)
{
    const struct note_cause *cause = book->causes;
    const struct note_place *lost = &book->lost;

    for (size_t i = 0; cause && i < MAX_REPORTS; i++, cause = cause->next)
        report(cause, severity, reports);
    if (cause)
        lost = &cause->first->place;
    if (lost->source)
        diagnostics_add(reports, severity, &lost->position,
                        "too many reports: those from here on are left out, "
                        "after " LIMIT_TEXT(MAX_REPORTS));
}

/* Reports the notes of a value and of all values that it uses. A node is marked as it
 * is pushed on the stack `waiting`, so each is visited once, however often it is
 * used. */
static void report_all(struct deduplicated_warnings *book, struct notes *notes)
{
    struct notes *waiting = NULL;

    for (;;) {
        for (; notes && !notes->reported; notes = notes->rest) {
            notes->reported = true;
            notes->waiting = waiting;
            waiting = notes;
        }
        if (!waiting)
            return;
        if (waiting->note)
            add_report(book, waiting->note);
        notes = waiting->used;
        waiting = waiting->waiting;
    }
}

/* ---- Notes of a value or of the scene ------------------------------------ */

static void write_down(struct deduplicated_warnings *book, struct note *note,
                       struct notes *used)
{
    struct notes *notes = arena_take(&book->arena, sizeof *notes);

    if (!notes)
        return;
    *notes = (struct notes){ .note = note, .used = used, .rest = book->page->notes };
    book->page->notes = notes;
}

/* Marks an entry with the current page. Returns false if the page has it already: a
 * loop records the same notes at each turn. */
static bool is_new(const struct deduplicated_warnings *book, size_t *page)
{
    bool fresh = *page != book->page->serial;

    *page = book->page->serial;
    return fresh;
}

void note_add(struct deduplicated_warnings *book, const struct note_place *place,
              const char *words, const char *calls)
{
    struct note *note = note_of(book, place, words, calls);

    if (!note)
        return;
    if (!book->page)
        add_report(book, note);
    else if (is_new(book, &note->page))
        write_down(book, note, NULL);
}

void note_report(struct deduplicated_warnings *book, const struct note_place *place,
                 const char *words, const char *calls)
{
    struct note *note = note_of(book, place, words, calls);

    if (note)
        add_report(book, note);
}

void notes_begin(struct deduplicated_warnings *book, struct note_page *page)
{
    *page = (struct note_page){ .outer = book->page, .serial = ++book->pages };
    book->page = page;
}

struct notes *notes_end(struct deduplicated_warnings *book)
{
    struct notes *notes = book->page->notes;

    book->page = book->page->outer;
    return notes;
}

struct note_page *notes_suspend(struct deduplicated_warnings *book)
{
    struct note_page *page = book->page;

    book->page = NULL;
    return page;
}

void notes_resume(struct deduplicated_warnings *book, struct note_page *page)
{
    book->page = page;
}

void notes_use(struct deduplicated_warnings *book, struct notes *notes)
{
    if (!notes)
        return;
    if (!book->page)
        report_all(book, notes);
    else if (!book->page->notes)
        book->page->notes = notes;
    else if (is_new(book, &notes->page))
        write_down(book, NULL, notes);
}

bool warnings_failed(const struct deduplicated_warnings *book)
{
    return book->arena.failed;
}

void warnings_free(struct deduplicated_warnings *book)
{
    arena_free(&book->arena);
}
