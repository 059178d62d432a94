/* note.c - notes, the values that they belong to, and their causes. */
#include "rt/scene/language/note.h"

#include "base/hash.h"

#include <stdio.h>
#include <string.h>

/* All that is told for the same reason. */
struct note_cause {
    struct note_cause *next;
    const char *words;
    const struct note *first;
    size_t places;
};

struct note {
    struct note *next; /* of the bucket */
    struct note_place place;
    const char *words, *calls;
    bool told;
};

struct notes {
    size_t count;
    struct note *notes[];
};

/* Where places differ; in a library they do not. */
static size_t offset_of(const struct note_place *place)
{
    return place->source->library ? 0 : place->at;
}

static struct note **bucket_of(struct notebook *book,
                               const struct note_place *place,
                               const char *words)
{
    uint64_t key = hash_bytes(HASH_START, (const unsigned char *)words,
                              strlen(words));

    return &book->buckets[(key + offset_of(place)) % NOTE_BUCKETS];
}

static struct note *new_note(struct notebook *book,
                             const struct note_place *place,
                             const char *words, const char *calls)
{
    struct note *note = NULL;

    if (book->count < NOTES_MOST)
        note = arena_take(&book->arena, sizeof *note);
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

/* The one of that place and those words, made if there is none; NULL: there
 * are too many, or there is no memory. */
static struct note *note_of(struct notebook *book,
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

/* ---- What is told ------------------------------------------------------- */

static struct note_cause *cause_of(struct notebook *book,
                                   const struct note *note)
{
    struct note_cause *cause = book->causes;

    while (cause && strcmp(cause->words, note->words))
        cause = cause->next;
    if (cause || book->cause_count > REPORTS_MOST)
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

static void tell(struct notebook *book, struct note *note)
{
    struct note_cause *cause = note->told ? NULL : cause_of(book, note);

    note->told = true;
    if (cause)
        cause->places++;
}

static void report(const struct note_cause *cause, enum severity severity,
                   struct diagnostics *reports)
{
    const struct note *first = cause->first;
    char message[2000];
    int length = snprintf(message, sizeof message, "%s%s", first->words,
                          first->calls);

    if (cause->places > 1 && length >= 0 && (size_t)length < sizeof message)
        snprintf(message + length, sizeof message - (size_t)length,
                 " (%zu places, this is the first)", cause->places);
    diagnostics_add(reports, severity, &first->place.position, message);
}

void notebook_report(const struct notebook *book, enum severity severity,
                     struct diagnostics *reports)
{
    const struct note_cause *cause = book->causes;

    for (size_t i = 0; cause && i < REPORTS_MOST; i++, cause = cause->next)
        report(cause, severity, reports);
    if (cause)
        diagnostics_add(reports, severity, &cause->first->place.position,
                        "too many reports: those from here on are left out");
}

/* ---- Of a value, or of the scene ---------------------------------------- */

static void write_down(struct notebook *book, struct note_page *page,
                       struct note *note)
{
    struct note **notes;

    for (size_t i = 0; i < page->count; i++)
        if (page->notes[i] == note)
            return;
    notes = arena_grow(&book->arena, page->notes, page->count,
                       &page->capacity, sizeof *notes);
    if (!notes)
        return;
    page->notes = notes;
    notes[page->count++] = note;
}

static void write_all(struct notebook *book, struct note_page *page,
                      const struct notes *notes)
{
    for (size_t i = 0; i < notes->count; i++)
        write_down(book, page, notes->notes[i]);
}

/* Its notes are its own from here on. */
static void part(struct notebook *book, struct note_page *page)
{
    const struct notes *same = page->same;

    page->same = NULL;
    if (same)
        write_all(book, page, same);
}

void note_add(struct notebook *book, const struct note_place *place,
              const char *words, const char *calls)
{
    struct note *note = note_of(book, place, words, calls);

    if (!note)
        return;
    if (!book->page) {
        tell(book, note);
        return;
    }
    part(book, book->page);
    write_down(book, book->page, note);
}

void note_tell(struct notebook *book, const struct note_place *place,
               const char *words, const char *calls)
{
    struct note *note = note_of(book, place, words, calls);

    if (note)
        tell(book, note);
}

void notes_begin(struct notebook *book, struct note_page *page)
{
    *page = (struct note_page){ .outer = book->page };
    book->page = page;
}

static const struct notes *bind(struct notebook *book,
                                const struct note_page *page)
{
    size_t size = page->count * sizeof *page->notes;
    struct notes *notes;

    if (page->same || !page->count)
        return page->same;
    notes = arena_take(&book->arena, sizeof *notes + size);
    if (!notes)
        return NULL;
    notes->count = page->count;
    memcpy(notes->notes, page->notes, size);
    return notes;
}

const struct notes *notes_end(struct notebook *book)
{
    const struct note_page *page = book->page;

    book->page = page->outer;
    return bind(book, page);
}

void notes_use(struct notebook *book, const struct notes *notes)
{
    struct note_page *page = book->page;

    if (!notes || (page && page->same == notes))
        return;
    if (!page) {
        for (size_t i = 0; i < notes->count; i++)
            tell(book, notes->notes[i]);
    } else if (!page->count && !page->same) {
        page->same = notes;
    } else {
        part(book, page);
        write_all(book, page, notes);
    }
}

bool notebook_failed(const struct notebook *book)
{
    return book->arena.failed;
}

void notebook_free(struct notebook *book)
{
    arena_free(&book->arena);
}
