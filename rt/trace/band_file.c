#include "rt/trace/band_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/hash.h"

/* A file is a list of 64-bit words, the highest byte first: the magic word,
 * the key, the width; then for each band the number of words that follow, the
 * words of the band (put_band), and a checksum of these. */
#define MAGIC UINT64_C(0x7274323035626433) /* rt205bd3 */

struct band_file {
    FILE *stream;
    char *path;
    size_t width; /* of the frame, pixels */
};

/* ---- Words in a row ------------------------------------------------------ */

struct words {
    uint64_t *items;
    size_t count, room, at; /* at: the next one to be taken */
    bool failed;            /* no memory, or taken beyond the end */
};

static void put(struct words *words, uint64_t word)
{
    if (words->count == words->room) {
        size_t room = words->room > 0 ? 2 * words->room : 1024;
        uint64_t *items = realloc(words->items, room * sizeof *items);

        if (!items) {
            words->failed = true;
            return;
        }
        words->items = items;
        words->room = room;
    }
    words->items[words->count++] = word;
}

static uint64_t take(struct words *words)
{
    if (words->at < words->count)
        return words->items[words->at++];
    words->failed = true;
    return 0;
}

static bool write_word(FILE *stream, uint64_t word)
{
    unsigned char bytes[8];

    for (int i = 0; i < 8; i++)
        bytes[i] = (unsigned char)(word >> (56 - 8 * i));
    return fwrite(bytes, 1, sizeof bytes, stream) == sizeof bytes;
}

static bool read_word(FILE *stream, uint64_t *word)
{
    unsigned char bytes[8];

    if (fread(bytes, 1, sizeof bytes, stream) != sizeof bytes)
        return false;
    *word = 0;
    for (int i = 0; i < 8; i++)
        *word = *word << 8 | bytes[i];
    return true;
}

/* ---- A band as words ----------------------------------------------------- */

static void put_name(struct words *words, const char *name)
{
    size_t length = strlen(name);

    put(words, length);
    for (size_t i = 0; i < length; i++)
        put(words, (unsigned char)name[i]);
}

static void put_account(struct words *words, const c205_account *account)
{
    put_name(words, account->name);
    for (int cause = 0; cause < C205_CAUSES; cause++)
        put(words, account->clocks[cause]);
    put(words, account->instructions);
    put(words, account->vector_instructions);
    put(words, account->elements);
    put(words, account->operations);
    put(words, account->entries);
}

static void put_band(struct words *words, const struct band *band,
                     size_t width)
{
    put(words, band->first_row);
    put(words, band->rows);
    for (int kind = 0; kind < RAY_KINDS; kind++)
        put(words, band->rays[kind]);
    put(words, band->accounts.count);
    for (size_t i = 0; i < band->accounts.count; i++)
        put_account(words, &band->accounts.items[i]);
    for (size_t i = 0; i < FRAME_CHANNELS * band->rows * width; i++)
        put(words, band->words[i]);
}

static bool take_account(struct words *words, struct accounts *accounts)
{
    char name[256];
    c205_account account = { .name = name };
    uint64_t length = take(words);

    if (length >= sizeof name)
        return false;
    for (uint64_t i = 0; i < length; i++)
        name[i] = (char)take(words);
    name[length] = '\0';
    for (int cause = 0; cause < C205_CAUSES; cause++)
        account.clocks[cause] = take(words);
    account.instructions = take(words);
    account.vector_instructions = take(words);
    account.elements = take(words);
    account.operations = take(words);
    account.entries = take(words);
    return !words->failed && accounts_add_account(accounts, &account);
}

static bool take_samples(struct words *words, struct band *band, size_t width)
{
    size_t left = words->count - words->at;
    size_t count;

    if (band->rows > left / width / FRAME_CHANNELS)
        return false;
    count = FRAME_CHANNELS * band->rows * width;
    band->words = count == left ? malloc(count * sizeof *band->words) : NULL;
    if (!band->words)
        return false;
    memcpy(band->words, words->items + words->at,
           count * sizeof *band->words);
    return true;
}

static bool take_band(struct words *words, struct band *band, size_t width)
{
    uint64_t accounts;

    band->first_row = (size_t)take(words);
    band->rows = band->rows_done = (size_t)take(words);
    for (int kind = 0; kind < RAY_KINDS; kind++)
        band->rays[kind] = take(words);
    accounts = take(words);
    for (uint64_t i = 0; i < accounts && !words->failed; i++)
        if (!take_account(words, &band->accounts))
            return false;
    return !words->failed && take_samples(words, band, width);
}

/* ---- The file ------------------------------------------------------------ */

/* The words of the next band, whole and unharmed. */
static bool read_words(FILE *stream, struct words *words)
{
    uint64_t count, word = 0;

    words->count = words->at = 0;
    if (!read_word(stream, &count))
        return false;
    for (uint64_t i = 0; i < count && !words->failed; i++) {
        if (!read_word(stream, &word))
            return false;
        put(words, word);
    }
    return !words->failed && read_word(stream, &word)
           && word == hash_words(HASH_START, words->items, words->count);
}

/* Where the bands of a file go. */
struct taking {
    const c205_model *model;
    band_taker *take;
    void *context;
};

/* The band that the words are, if they are one; false: no memory. */
static bool take_words(struct words *words, size_t width,
                       const struct taking *taking, bool *whole)
{
    struct band band = { .accounts.model = taking->model };
    bool memory;

    *whole = take_band(words, &band, width);
    memory = !*whole || taking->take(taking->context, &band);
    band_free(&band);
    return memory;
}

/* All bands up to the end or to one that is not whole; the stream then stands
 * behind the last. */
static bool read_bands(FILE *stream, size_t width,
                       const struct taking *taking)
{
    struct words words = { NULL, 0, 0, 0, false };
    long end = ftell(stream);
    bool memory = true, whole = true;

    while (memory && whole && read_words(stream, &words)) {
        memory = take_words(&words, width, taking, &whole);
        if (whole)
            end = ftell(stream);
    }
    free(words.items);
    return memory && end >= 0 && fseek(stream, end, SEEK_SET) == 0;
}

/* False: the file is of something else. */
static bool read_head(FILE *stream, uint64_t key, size_t width,
                      c205_error *error)
{
    uint64_t head[3] = { 0, 0, 0 };
    bool whole = true;

    for (int i = 0; i < 3 && whole; i++)
        whole = read_word(stream, &head[i]);
    if (!whole || head[0] != MAGIC)
        snprintf(error->message, sizeof error->message,
                 "it does not hold bands of a frame");
    else if (head[1] != key || head[2] != width)
        snprintf(error->message, sizeof error->message,
                 "it holds bands of another frame, or of other options");
    else
        return true;
    return false;
}

static bool write_head(FILE *stream, uint64_t key, size_t width)
{
    return write_word(stream, MAGIC) && write_word(stream, key)
           && write_word(stream, width) && fflush(stream) == 0;
}

/* Whether the path still leads to the file: a picture of that name may have
 * come in its place. */
static bool is_there(const struct band_file *file)
{
    struct stat kept, named;

    return fstat(fileno(file->stream), &kept) == 0
           && stat(file->path, &named) == 0 && kept.st_dev == named.st_dev
           && kept.st_ino == named.st_ino;
}

/* The file for this process alone: the lock goes with the process, however it
 * ends. */
static FILE *open_locked(const char *path, c205_error *error)
{
    struct flock lock = { .l_type = F_WRLCK, .l_whence = SEEK_SET };
    int file = open(path, O_RDWR | O_CREAT, 0666);
    bool locked = file >= 0 && fcntl(file, F_SETLK, &lock) == 0;
    bool in_use = file >= 0 && !locked
                  && (errno == EAGAIN || errno == EACCES);
    FILE *stream = locked ? fdopen(file, "r+b") : NULL;

    if (!stream) {
        snprintf(error->message, sizeof error->message, "%s",
                 in_use ? "another run is using it" : strerror(errno));
        if (file >= 0)
            close(file);
    }
    return stream;
}

/* The run that held the lock before may have removed the file at its end. */
static bool open_stream(struct band_file *file, c205_error *error)
{
    do {
        if (file->stream)
            fclose(file->stream);
        file->stream = open_locked(file->path, error);
    } while (file->stream && !is_there(file));
    return file->stream != NULL;
}

static bool is_empty(const struct band_file *file)
{
    struct stat status;

    return fstat(fileno(file->stream), &status) == 0 && status.st_size == 0;
}

static bool begin(struct band_file *file, uint64_t key, size_t width,
                  const struct taking *taking, c205_error *error)
{
    bool fresh;

    if (!open_stream(file, error))
        return false;
    fresh = is_empty(file);
    if (!fresh && !read_head(file->stream, key, width, error))
        return false;
    snprintf(error->message, sizeof error->message, "no memory, or no room");
    return fresh ? write_head(file->stream, key, width)
                 : read_bands(file->stream, width, taking);
}

struct band_file *band_file_open(const char *path, uint64_t key, size_t width,
                                 const c205_model *model, band_taker *taker,
                                 void *context, c205_error *error)
{
    const struct taking taking = { model, taker, context };
    struct band_file *file = calloc(1, sizeof *file);
    char *copy = malloc(strlen(path) + 1);
    c205_error why = { "no memory" };

    if (file && copy) {
        file->path = strcpy(copy, path);
        file->width = width;
        if (begin(file, key, width, &taking, &why))
            return file;
    }
    snprintf(error->message, sizeof error->message, "%.100s: %.130s", path,
             why.message);
    if (file && file->stream)
        fclose(file->stream);
    free(copy);
    free(file);
    return NULL;
}

bool band_file_add(struct band_file *file, const struct band *band,
                   c205_error *error)
{
    struct words words = { NULL, 0, 0, 0, false };
    bool good;

    put_band(&words, band, file->width);
    good = !words.failed && write_word(file->stream, words.count);
    for (size_t i = 0; good && i < words.count; i++)
        good = write_word(file->stream, words.items[i]);
    good = good
           && write_word(file->stream,
                         hash_words(HASH_START, words.items, words.count))
           && fflush(file->stream) == 0;
    if (!good)
        snprintf(error->message, sizeof error->message,
                 "%.100s: a band cannot be added", file->path);
    free(words.items);
    return good;
}

void band_file_close(struct band_file *file, bool remove_it)
{
    if (!file)
        return;
    if (remove_it && is_there(file))
        remove(file->path);
    fclose(file->stream);
    free(file->path);
    free(file);
}

static bool add_to_key(void *context, const void *bytes, size_t count)
{
    uint64_t *key = context;

    *key = hash_bytes(*key, bytes, count);
    return true;
}

uint64_t band_file_key(const c205 *machine)
{
    uint64_t key = HASH_START;
    c205_error error;

    return c205_save(machine, add_to_key, &key, &error) ? key : 0;
}
