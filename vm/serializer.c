/* serializer.c - writes and reads words, counts and texts, and their hash. */
#include "vm/serializer.h"
#include "vm/error.h"

#include "vm/hash.h"

#include <string.h>

static const char damaged[] = "the saved machine is damaged";

struct serializer serializer_to(c205_writer *write, void *context, c205_error *error)
{
    struct serializer serializer = {
        write, context, NULL, 0, HASH_BEGIN, false, error
    };
    return serializer;
}

struct serializer serializer_from(const void *bytes, size_t count, c205_error *error)
{
    struct serializer serializer = {
        NULL, NULL, bytes, count, HASH_BEGIN, false, error
    };
    return serializer;
}

void serializer_refuse(struct serializer *serializer, const char *why)
{
    if (!serializer->failed)
        error_set(serializer->error, "%s", why);
    serializer->failed = true;
}

void serializer_require(struct serializer *serializer, bool holds,
                        const char *otherwise)
{
    if (serializer_is_read(serializer) && !holds)
        serializer_refuse(serializer, otherwise);
}

/* ---- Words --------------------------------------------------------------- */

static uint64_t word_at(const unsigned char *bytes)
{
    uint64_t word = 0;
    for (size_t i = 0; i < SERIALIZER_WORD_BYTES; i++)
        word = word << 8 | bytes[i];
    return word;
}

static void write_word(struct serializer *serializer, uint64_t word)
{
    unsigned char bytes[SERIALIZER_WORD_BYTES];
    for (size_t i = 0; i < SERIALIZER_WORD_BYTES; i++)
        bytes[i] = (unsigned char)(word >> (8 * (SERIALIZER_WORD_BYTES - 1 - i)));
    if (!serializer->write(serializer->context, bytes, sizeof bytes))
        serializer_refuse(serializer, "cannot write the saved machine");
}

static uint64_t serialized_word(struct serializer *serializer)
{
    if (serializer->left < SERIALIZER_WORD_BYTES) {
        serializer_refuse(serializer, damaged);
        return 0;
    }
    uint64_t word = word_at(serializer->bytes);
    serializer->bytes += SERIALIZER_WORD_BYTES;
    serializer->left -= SERIALIZER_WORD_BYTES;
    return word;
}

void serializer_word(struct serializer *serializer, uint64_t *word)
{
    if (serializer_is_read(serializer))
        *word = serializer->failed ? 0 : serialized_word(serializer);
    else if (!serializer->failed)
        write_word(serializer, *word);
    serializer->hash = hash_word(serializer->hash, *word);
}

void serializer_words(struct serializer *serializer, uint64_t *words, size_t count)
{
    for (size_t i = 0; i < count; i++)
        serializer_word(serializer, &words[i]);
}

void serializer_size(struct serializer *serializer, size_t *size, size_t most)
{
    uint64_t word = *size;
    serializer_word(serializer, &word);
    serializer_require(serializer, word <= most, damaged);
    *size = serializer_is_read(serializer) && serializer->failed ? 0 : (size_t)word;
}

void serializer_array(struct serializer *serializer, uint64_t *words, size_t count)
{
    size_t counted = count;
    serializer_size(serializer, &counted, count);
    serializer_require(serializer, counted == count, damaged);
    serializer_words(serializer, words, count);
}

size_t serializer_room(const struct serializer *serializer)
{
    return serializer->left / SERIALIZER_WORD_BYTES;
}

void serializer_count(struct serializer *serializer, size_t *count)
{
    size_t room = serializer_room(serializer); /* includes the word of the count */
    serializer_size(serializer, count, room > 0 ? room - 1 : 0);
}

/* ---- Texts: number of words, then the characters and at least one NUL ---- */

static void write_text(struct serializer *serializer, const char *text)
{
    size_t length = strlen(text), words = length / SERIALIZER_WORD_BYTES + 1;
    serializer_size(serializer, &words, words);
    for (size_t i = 0; i < words; i++) {
        unsigned char bytes[SERIALIZER_WORD_BYTES] = { 0 };
        size_t left = length - i * SERIALIZER_WORD_BYTES;
        memcpy(bytes, text + i * SERIALIZER_WORD_BYTES,
               left < sizeof bytes ? left : sizeof bytes);
        uint64_t word = word_at(bytes);
        serializer_word(serializer, &word);
    }
}

static const char *serialized_text(struct serializer *serializer)
{
    const char *text = "";
    size_t words = 0;
    serializer_count(serializer, &words);
    if (words > 0 && serializer->bytes[words * SERIALIZER_WORD_BYTES - 1] == '\0')
        text = (const char *)serializer->bytes;
    else
        serializer_refuse(serializer, damaged);
    for (uint64_t word; words > 0; words--)
        serializer_word(serializer, &word);
    return text;
}

void serializer_text(struct serializer *serializer, const char **text)
{
    if (serializer_is_read(serializer))
        *text = serialized_text(serializer);
    else
        write_text(serializer, *text);
}

/* ---- The end -------------------------------------------------------------- */

void serializer_verify(struct serializer *serializer)
{
    struct serializer ahead = *serializer;
    uint64_t word;
    serializer_require(serializer, serializer->left % SERIALIZER_WORD_BYTES == 0,
                       damaged);
    if (!serializer_is_read(serializer) || serializer->failed)
        return;
    while (serializer_room(&ahead) > 1)
        serializer_word(&ahead, &word);
    serializer_end(&ahead);
    serializer->failed = ahead.failed;
}

void serializer_end(struct serializer *serializer)
{
    uint64_t hash = serializer->hash, word = hash;
    serializer_word(serializer, &word);
    serializer_require(serializer, word == hash && serializer->left == 0, damaged);
}
