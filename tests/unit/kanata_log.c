/* kanata_log.c - parses logs in the format Kanata 0004, and reports the first error. */
#include "tests/unit/kanata_log.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { WORDS = 4, WORD = 400, MAX_LANES = 2, STAGE = 16 };

struct alive {
    bool is;
    char stage[MAX_LANES][STAGE]; /* current stage of each lane; "": no stage */
};

struct kanata_log {
    size_t count; /* instructions declared so far */
    size_t capacity, retired, ended;
    struct alive *insns;
    bool begun;
    char words[WORDS][WORD]; /* words of the current line */
    size_t word_count;
};

/* ---- Words ----------------------------------------------------------------- */

/* Splits a line into words. Returns false for too many, long or empty words. */
static bool cut_line(struct kanata_log *log, const char *line, size_t length)
{
    size_t used = 0;
    log->word_count = 1;
    for (size_t i = 0; i < length; i++) {
        char *word = log->words[log->word_count - 1];
        if (line[i] != '\t') {
            if (used + 1 == WORD)
                return false;
            word[used++] = line[i];
            continue;
        }
        if (used == 0 || log->word_count == WORDS)
            return false;
        word[used] = '\0';
        used = 0;
        log->word_count++;
    }
    log->words[log->word_count - 1][used] = '\0';
    return used > 0;
}

static bool is_number(const char *word)
{
    return *word && strspn(word, "0123456789") == strlen(word);
}

/* Returns the value of a word that is a number. */
static uint64_t number_of(const struct kanata_log *log, size_t word)
{
    return strtoull(log->words[word], NULL, 10);
}

static struct alive *find_alive(const struct kanata_log *log, size_t word)
{
    uint64_t id = number_of(log, word);
    return id < log->count && log->insns[id].is ? &log->insns[id] : NULL;
}

/* ---- Commands -------------------------------------------------------------- */

static const char *appear(struct kanata_log *log)
{
    if (number_of(log, 1) != log->count)
        return "instructions are not numbered as they appear";
    if (log->count == log->capacity) {
        log->capacity = 2 * log->capacity + 64;
        log->insns = realloc(log->insns, log->capacity * sizeof *log->insns);
    }
    log->insns[log->count++] = (struct alive){ .is = true };
    return NULL;
}

static const char *label(struct kanata_log *log)
{
    return number_of(log, 2) <= 1 ? NULL : "there is no such kind of text";
}

static char *lane_of(const struct kanata_log *log)
{
    uint64_t lane = number_of(log, 2);
    return lane < MAX_LANES ? find_alive(log, 1)->stage[lane] : NULL;
}

static const char *enter(struct kanata_log *log)
{
    char *stage = lane_of(log);
    if (!stage || strlen(log->words[3]) >= STAGE)
        return "the lane or the stage's name is too large";
    strcpy(stage, log->words[3]);
    return NULL;
}

static const char *leave(struct kanata_log *log)
{
    char *stage = lane_of(log);
    if (!stage || strcmp(stage, log->words[3]) != 0)
        return "it leaves a stage in which it is not";
    *stage = '\0';
    return NULL;
}

static const char *retire(struct kanata_log *log)
{
    uint64_t kind = number_of(log, 3);
    find_alive(log, 1)->is = false;
    log->ended++;
    if (kind > 1)
        return "it neither retires nor is flushed";
    return kind == 1 || number_of(log, 2) == log->retired++
               ? NULL
               : "instructions are not numbered as they retire";
}

static const char *depend(struct kanata_log *log)
{
    return number_of(log, 2) < log->count ? NULL : "there is no producer";
}

/* The words after a command: n is a number, i an existing instruction, t a text. */
static const struct kanata_command {
    const char *name, *words;
    const char *(*take)(struct kanata_log *log); /* NULL: any words are accepted */
} commands[] = {
    { "C=", "n", NULL },    { "C", "n", NULL },     { "I", "nnn", appear },
    { "L", "int", label },  { "S", "int", enter },  { "E", "int", leave },
    { "R", "inn", retire }, { "W", "inn", depend },
};

static const char *take_line(struct kanata_log *log)
{
    size_t i = 0;
    while (i < sizeof commands / sizeof *commands
           && strcmp(commands[i].name, log->words[0]) != 0)
        i++;
    if (i == sizeof commands / sizeof *commands)
        return "there is no such command";
    if (log->begun == (i == 0))
        return "C= stands before all others, and once";
    log->begun = true;
    if (log->word_count != strlen(commands[i].words) + 1)
        return "the command has other words";
    for (size_t k = 1; k < log->word_count; k++) {
        char kind = commands[i].words[k - 1];
        if (kind != 't' && !is_number(log->words[k]))
            return "a number is none";
        if (kind == 'i' && !find_alive(log, k))
            return "the instruction is not there";
    }
    return commands[i].take ? commands[i].take(log) : NULL;
}

/* ---- The log --------------------------------------------------------------- */

static const char *read_lines(struct kanata_log *log, const char *text, size_t *line)
{
    const char *fault = NULL;
    for (*line = 1; !fault && *text; (*line)++) {
        size_t length = strcspn(text, "\n");
        if (text[length] != '\n')
            fault = "the last line has no end";
        else if (*line == 1)
            fault = strncmp(text, "Kanata\t0004", length) == 0 && length == 11
                        ? NULL
                        : "it is no log of this version";
        else
            fault = cut_line(log, text, length) ? take_line(log) : "words are missing";
        text += length + 1;
    }
    --*line;
    return fault ? fault : log->begun ? NULL : "it has no beginning";
}

const char *kanata_fault(const char *text, size_t *line)
{
    struct kanata_log log = { 0 };
    const char *fault = read_lines(&log, text, line);
    if (!fault && log.ended < log.count)
        fault = "an instruction is there at the end";
    free(log.insns);
    return fault;
}
