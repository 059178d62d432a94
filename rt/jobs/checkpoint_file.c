/* checkpoint_file.c - stores the finished units of a run in a file. */
#include "rt/jobs/checkpoint_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/array.h"
#include "vm/error.h"
#include "base/fnv_hash.h"
#include "rt/platform/processes.h"

/* The file is a list of 64-bit words, most significant byte first. It begins with the
 * magic word and the key. Each unit has its number, its count of words, a checksum of
 * these two words, its words, and a checksum of the whole unit. */
#define MAGIC UINT64_C(0x7274323035756E31) /* "rt205un1" in ASCII */
enum { WORD = 8, HEAD = 2 * WORD };

/* The position of a unit in the file. */
struct unit_place {
    uint64_t number;
    long at;
};

struct checkpoint_file {
    FILE *stream;
    char *path;
    uint64_t key;
    long end; /* position after the last complete unit */
    size_t count;
    struct unit_place *places; /* sorted by number */
};

/* ---- Words --------------------------------------------------------------- */

static bool write_word(FILE *stream, uint64_t word)
{
    unsigned char bytes[WORD];
    for (int i = 0; i < WORD; i++)
        bytes[i] = (unsigned char)(word >> (56 - 8 * i));
    return fwrite(bytes, 1, WORD, stream) == WORD;
}

static bool read_file_word(FILE *stream, uint64_t *word)
{
    unsigned char bytes[WORD];
    if (fread(bytes, 1, WORD, stream) != WORD)
        return false;
    *word = 0;
    for (int i = 0; i < WORD; i++)
        *word = *word << 8 | bytes[i];
    return true;
}

/* ---- A unit -------------------------------------------------------------- */

/* Reads the next unit. Returns false if it is incomplete or damaged. */
static bool read_unit(FILE *stream, uint64_t *number, struct serialized_result *words)
{
    uint64_t head[2], sum, word = 0;
    result_clear(words);
    if (!read_file_word(stream, &head[0]) || !read_file_word(stream, &head[1])
        || !read_file_word(stream, &sum) || sum != hash_words(HASH_START, head, 2))
        return false;
    for (uint64_t i = 0; i < head[1] && !words->failed; i++) {
        if (!read_file_word(stream, &word))
            return false;
        result_put(words, word);
    }
    *number = head[0];
    return !words->failed && read_file_word(stream, &word)
           && word == hash_words(sum, words->items, words->count);
}

static bool write_unit(FILE *stream, uint64_t number,
                       const struct serialized_result *words)
{
    const uint64_t head[2] = { number, words->count };
    uint64_t sum = hash_words(HASH_START, head, 2);
    bool good = write_word(stream, head[0]) && write_word(stream, head[1])
                && write_word(stream, sum);
    for (size_t i = 0; good && i < words->count; i++)
        good = write_word(stream, words->items[i]);
    return good && write_word(stream, hash_words(sum, words->items, words->count))
           && fflush(stream) == 0;
}

/* ---- The list of units --------------------------------------------------- */

/* Returns the index of the first unit whose number is at least `number`. */
static size_t place_of(const struct checkpoint_file *file, uint64_t number)
{
    size_t low = 0, high = file->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (file->places[middle].number < number)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

bool checkpoint_has(const struct checkpoint_file *file, uint64_t number)
{
    size_t i = place_of(file, number);
    return i < file->count && file->places[i].number == number;
}

size_t checkpoint_count(const struct checkpoint_file *file)
{
    return file->count;
}

static bool note_unit(struct checkpoint_file *file, uint64_t number, long at)
{
    size_t i = place_of(file, number);
    if (checkpoint_has(file, number))
        return true;
    if (!array_add(&file->places, &file->count, NULL, sizeof *file->places))
        return false;
    memmove(&file->places[i + 1], &file->places[i],
            (file->count - 1 - i) * sizeof *file->places);
    file->places[i] = (struct unit_place){ number, at };
    return true;
}

/* Lists the units up to the last complete unit. The caller removes the rest of the
 * file. */
static bool find_units(struct checkpoint_file *file)
{
    struct serialized_result words = { NULL, 0, 0, 0, false };
    uint64_t number;
    bool memory = true;
    file->end = ftell(file->stream);
    while (memory && read_unit(file->stream, &number, &words)) {
        memory = note_unit(file, number, file->end);
        file->end = ftell(file->stream);
    }
    result_free(&words);
    return memory && file->end >= 0;
}

static bool drop_tail(struct checkpoint_file *file)
{
    return fseek(file->stream, file->end, SEEK_SET) == 0
           && ftruncate(fileno(file->stream), (off_t)file->end) == 0;
}

bool checkpoint_read(struct checkpoint_file *file, uint64_t number,
                     struct serialized_result *words)
{
    uint64_t found;
    return checkpoint_has(file, number)
           && fseek(file->stream, file->places[place_of(file, number)].at, SEEK_SET)
                  == 0
           && read_unit(file->stream, &found, words) && found == number;
}

bool checkpoint_add(struct checkpoint_file *file, uint64_t number,
                    const struct serialized_result *words, c205_error *error)
{
    if (checkpoint_has(file, number))
        return true;
    if (words->failed || fseek(file->stream, file->end, SEEK_SET) != 0
        || !write_unit(file->stream, number, words)
        || !note_unit(file, number, file->end))
        return error_set(error, "cannot write a unit of work to %.100s", file->path);
    file->end = ftell(file->stream);
    return true;
}

/* ---- The file ------------------------------------------------------------ */

static bool read_head(FILE *stream, uint64_t key, c205_error *error)
{
    uint64_t magic = 0, of = 0;
    if (!read_file_word(stream, &magic) || !read_file_word(stream, &of)
        || magic != MAGIC)
        return error_set(error, "the file does not hold units of work");
    return of == key
           || error_set(error, "the file belongs to another run: another scene, "
                               "other options, or another version");
}

static bool write_file_head(FILE *stream, uint64_t key)
{
    return write_word(stream, MAGIC) && write_word(stream, key) && fflush(stream) == 0;
}

/* Returns true if the path still refers to the file. A picture with the same name may
 * have replaced it. */
static bool is_there(const struct checkpoint_file *file)
{
    struct stat kept, named;
    return fstat(fileno(file->stream), &kept) == 0 && stat(file->path, &named) == 0
           && kept.st_dev == named.st_dev && kept.st_ino == named.st_ino;
}

/* Opens the file with an exclusive lock. The system releases the lock when the process
 * ends, even after a crash. */
static FILE *open_locked(const char *path, c205_error *error)
{
    int file = open(path, O_RDWR | O_CREAT, 0666);
    bool locked = file >= 0 && process_lock(file, true);
    bool in_use = file >= 0 && !locked && process_lock_is_held();
    FILE *stream = locked ? fdopen(file, "r+b") : NULL;
    if (!stream) {
        error_set(
            error, "%s",
            in_use ? "another run is using it: wait for its end, or name another file"
                   : strerror(errno));
        if (file >= 0)
            close(file);
    }
    return stream;
}

/* Opens the file. If another run held the lock, that run may have removed the file at
 * its end; the file is then opened again. */
static bool open_stream(struct checkpoint_file *file, c205_error *error)
{
    do {
        if (file->stream)
            fclose(file->stream);
        file->stream = open_locked(file->path, error);
    } while (file->stream && !is_there(file));
    return file->stream != NULL;
}

static bool is_empty(const struct checkpoint_file *file)
{
    struct stat status;
    return fstat(fileno(file->stream), &status) == 0 && status.st_size == 0;
}

static bool begin_file(struct checkpoint_file *file, c205_error *error)
{
    bool fresh;
    if (!open_stream(file, error))
        return false;
    fresh = is_empty(file);
    if (!fresh && !read_head(file->stream, file->key, error))
        return false;
    return ((!fresh || write_file_head(file->stream, file->key)) && find_units(file)
            && drop_tail(file))
           || error_set(error, "out of memory, or the disk is full");
}

static struct checkpoint_file *new_file(const char *path, uint64_t key)
{
    struct checkpoint_file *file = calloc(1, sizeof *file);
    char *copy = malloc(strlen(path) + 1);
    if (!file || !copy) {
        free(file);
        free(copy);
        return NULL;
    }
    file->path = strcpy(copy, path);
    file->key = key;
    return file;
}

static void give_back(struct checkpoint_file *file)
{
    if (file->stream)
        fclose(file->stream);
    free(file->places);
    free(file->path);
    free(file);
}

struct checkpoint_file *checkpoint_open(const char *path, uint64_t key,
                                        c205_error *error)
{
    struct checkpoint_file *file = new_file(path, key);
    c205_error why = { "out of memory" };
    if (file && begin_file(file, &why))
        return file;
    error_set(error, "%.100s: %.130s", path, why.message);
    if (file)
        give_back(file);
    return NULL;
}

void checkpoint_close(struct checkpoint_file *file, bool remove_it)
{
    if (!file)
        return;
    if (remove_it && is_there(file))
        remove(file->path);
    give_back(file);
}

/* ---- Merging two files --------------------------------------------------- */

static bool add_units(struct checkpoint_file *file, FILE *stream, c205_error *error)
{
    struct serialized_result words = { NULL, 0, 0, 0, false };
    uint64_t number;
    bool good = true;
    while (good && read_unit(stream, &number, &words))
        good = checkpoint_add(file, number, &words, error);
    result_free(&words);
    return good;
}

/* Opens another file with a shared lock. Rejects the file that is already open, because
 * closing its second stream would release the lock of the first. */
static FILE *open_other(const struct checkpoint_file *file, const char *path,
                        c205_error *error)
{
    struct stat kept, named;
    FILE *stream;
    if (fstat(fileno(file->stream), &kept) == 0 && stat(path, &named) == 0
        && kept.st_dev == named.st_dev && kept.st_ino == named.st_ino) {
        error_set(error, "the file is named twice: name each file once");
        return NULL;
    }
    stream = fopen(path, "rb");
    if (!stream)
        error_set(error, "%s", strerror(errno));
    else if (process_lock(fileno(stream), false))
        return stream;
    else
        error_set(error,
                  "another run is using it: wait for its end, or name another file");
    if (stream)
        fclose(stream);
    return NULL;
}

bool checkpoint_merge(struct checkpoint_file *file, const char *path, c205_error *error)
{
    c205_error why;
    FILE *stream = open_other(file, path, &why);
    bool good = stream && read_head(stream, file->key, &why)
                && add_units(file, stream, &why);
    if (stream)
        fclose(stream);
    return good || error_set(error, "%.100s: %.130s", path, why.message);
}
