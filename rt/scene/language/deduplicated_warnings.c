/* deduplicated_warnings.c - records warnings by value, and reports them by cause. */
#include "rt/scene/language/deduplicated_warnings.h"
#include "vm/error.h"

#include "base/fnv_hash.h"

#include <stdio.h>
#include <string.h>

/* All reported warnings with the same text. */
struct warning_cause {
    struct warning_cause *next;
    const char *words;
    const struct scene_warning *first;
    size_t places;
};

struct scene_warning {
    struct scene_warning *next; /* next warning in the hash bucket */
    struct warning_place place;
    const char *words, *calls;
    bool reported;
    size_t page; /* serial number of the last page that contains it */
};

/* An entry of a list of warnings: one warning (`warning`), or the list of another value
 * (`used`). `rest` is the next entry. */
struct value_warnings {
    struct scene_warning *warning;
    struct value_warnings *used, *rest;
    bool reported;
    size_t page;                    /* serial number of the last page that contains
                                     * it */
    struct value_warnings *waiting; /* next node on the stack of nodes to report */
};

/* Returns the offset that distinguishes places in a file. It is 0 for all places in a
 * library. */
static size_t offset_of(const struct warning_place *place)
{
    return place->source->library ? 0 : place->at;
}

static struct scene_warning **bucket_of(struct deduplicated_warnings *book,
                                        const struct warning_place *place,
                                        const char *words)
{
    uint64_t key = hash_bytes(HASH_START, (const unsigned char *)words, strlen(words));
    return &book->buckets[(key + offset_of(place)) % WARNING_BUCKETS];
}

static struct scene_warning *new_note(struct deduplicated_warnings *book,
                                      const struct warning_place *place,
                                      const char *words, const char *calls)
{
    struct scene_warning *warning = NULL;
    if (book->count < MAX_WARNINGS)
        warning = arena_take(&book->arena, sizeof *warning);
    else if (!book->lost.source)
        book->lost = *place;
    if (!warning)
        return NULL;
    warning->place = *place;
    warning->words = arena_text(&book->arena, words, strlen(words));
    warning->calls = arena_text(&book->arena, calls, strlen(calls));
    if (!warning->words || !warning->calls)
        return NULL;
    book->count++;
    return warning;
}

/* Returns the warning with this place and these words, and creates it if there is none.
 * Returns NULL if there are too many warnings, or if out of memory. */
static struct scene_warning *scene_warning_of(struct deduplicated_warnings *book,
                                              const struct warning_place *place,
                                              const char *words, const char *calls)
{
    struct scene_warning **bucket = bucket_of(book, place, words);
    struct scene_warning *warning = *bucket;
    while (warning
           && (warning->place.source != place->source
               || offset_of(&warning->place) != offset_of(place)
               || strcmp(warning->words, words)))
        warning = warning->next;
    if (warning)
        return warning;
    warning = new_note(book, place, words, calls);
    if (!warning)
        return NULL;
    warning->next = *bucket;
    return *bucket = warning;
}

/* ---- Reports ------------------------------------------------------------- */

static struct warning_cause *cause_of(struct deduplicated_warnings *book,
                                      const struct scene_warning *warning)
{
    struct warning_cause *cause = book->causes;
    while (cause && strcmp(cause->words, warning->words))
        cause = cause->next;
    if (cause || book->cause_count > MAX_REPORTS)
        return cause;
    cause = arena_take(&book->arena, sizeof *cause);
    if (!cause)
        return NULL;
    cause->words = warning->words;
    cause->first = warning;
    if (book->last_cause)
        book->last_cause->next = cause;
    else
        book->causes = cause;
    book->cause_count++;
    return book->last_cause = cause;
}

static void add_report(struct deduplicated_warnings *book,
                       struct scene_warning *warning)
{
    struct warning_cause *cause = warning->reported ? NULL : cause_of(book, warning);
    warning->reported = true;
    if (cause)
        cause->places++;
}

static void report(const struct warning_cause *cause, enum severity severity,
                   struct diagnostics *reports)
{
    const struct scene_warning *first = cause->first;
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
    const struct warning_cause *cause = book->causes;
    const struct warning_place *lost = &book->lost;
    for (size_t i = 0; cause && i < MAX_REPORTS; i++, cause = cause->next)
        report(cause, severity, reports);
    if (cause)
        lost = &cause->first->place;
    if (lost->source)
        diagnostics_add(reports, severity, &lost->position,
                        "too many reports: the rest are omitted "
                        "after " LIMIT_TEXT(MAX_REPORTS));
}

/* Reports the warnings of a value and of all values that it uses. A node is marked when
 * it is pushed on the stack `waiting`, so it is visited only once. */
static void report_all(struct deduplicated_warnings *book, struct value_warnings *list)
{
    struct value_warnings *waiting = NULL;
    for (;;) {
        for (; list && !list->reported; list = list->rest) {
            list->reported = true;
            list->waiting = waiting;
            waiting = list;
        }
        if (!waiting)
            return;
        if (waiting->warning)
            add_report(book, waiting->warning);
        list = waiting->used;
        waiting = waiting->waiting;
    }
}

/* ---- Warnings of a value or of the scene ------------------------------------ */

static void write_down(struct deduplicated_warnings *book,
                       struct scene_warning *warning, struct value_warnings *used)
{
    struct value_warnings *list = arena_take(&book->arena, sizeof *list);
    if (!list)
        return;
    *list = (struct value_warnings){ .warning = warning,
                                     .used = used,
                                     .rest = book->page->list };
    book->page->list = list;
}

/* Returns true if the entry was not yet recorded in the current page, and marks it as
 * recorded there. A loop can record the same warning in each iteration. */
static bool is_new(const struct deduplicated_warnings *book, size_t *page)
{
    bool fresh = *page != book->page->serial;
    *page = book->page->serial;
    return fresh;
}

void scene_warning_add(struct deduplicated_warnings *book,
                       const struct warning_place *place, const char *words,
                       const char *calls)
{
    struct scene_warning *warning = scene_warning_of(book, place, words, calls);
    if (!warning)
        return;
    if (!book->page)
        add_report(book, warning);
    else if (is_new(book, &warning->page))
        write_down(book, warning, NULL);
}

void scene_warning_report(struct deduplicated_warnings *book,
                          const struct warning_place *place, const char *words,
                          const char *calls)
{
    struct scene_warning *warning = scene_warning_of(book, place, words, calls);
    if (warning)
        add_report(book, warning);
}

void value_warnings_begin(struct deduplicated_warnings *book, struct warning_page *page)
{
    *page = (struct warning_page){ .outer = book->page, .serial = ++book->pages };
    book->page = page;
}

struct value_warnings *value_warnings_end(struct deduplicated_warnings *book)
{
    struct value_warnings *list = book->page->list;
    book->page = book->page->outer;
    return list;
}

void value_warnings_use(struct deduplicated_warnings *book, struct value_warnings *list)
{
    if (!list)
        return;
    if (!book->page)
        report_all(book, list);
    else if (!book->page->list)
        book->page->list = list;
    else if (is_new(book, &list->page))
        write_down(book, NULL, list);
}

bool warnings_failed(const struct deduplicated_warnings *book)
{
    return book->arena.failed;
}

void warnings_free(struct deduplicated_warnings *book)
{
    arena_free(&book->arena);
}
