/* reader.h - the state of the parser of one scene, and its token stream.
 *
 * Every function that reads returns false after it has reported an error; its result is
 * then invalid. A caller that can recover (a block, or the file) skips to the next word
 * that it accepts.
 */
#ifndef RT_SCENE_READER_H
#define RT_SCENE_READER_H

#include "rt/scene/language/deduplicated_warnings.h"
#include "rt/scene/language/scene_read.h"
#include "rt/scene/language/symbol.h"

/* Limits that protect stack, memory and time against any file. */
#define MAX_ERRORS 200
enum {
    MAX_NESTING = 200,        /* nested blocks and brackets */
    MAX_PRIMITIVES = 1000000, /* and lights, copies included: 2 GB */
    MAX_TRIANGLES = 4000000,  /* of meshes, copies included: minutes, and 6 GB */
    MAX_SOLID = 10000,        /* primitives in one tree */
    MAX_FILES = 1000,         /* that are read; each is read once */
    MAX_CONDITIONS = 500,     /* nested */
    MAX_TURNS = 2000000,      /* iterations of one loop */
    MAX_SEEDS = 1000000       /* streams of random numbers: 4 MB */
};

/* Bytes of text that may be read, unless the options of the scene set another limit.
 * Each token costs TOKEN_COST more. The text of a loop or macro counts each time it is
 * read. The limit is reached after about a minute. */
#define MAX_READING (UINT64_C(8) << 30)
enum {
    TOKEN_COST = 16,
    MEMORY_COST = 8 /* cost of a byte in splines and functions: 1 GiB in all */
};

/* A directive that is open: its #end has not been read. */
enum condition_kind {
    CONDITION_IF, /* also #ifdef and #ifndef */
    CONDITION_WHILE,
    CONDITION_FOR,
    CONDITION_SWITCH
};
struct scene_condition {
    enum condition_kind kind;
    struct scene_token at;
    size_t frame; /* serial number of its frame */
    bool in_else;
    struct text_place again; /* of a loop: where each iteration begins */
    size_t turns, errors;
    struct scene_token name; /* of #for */
    double end, step;
    double value; /* of #switch */
    bool chosen;  /* of #switch: a case has matched */
};

/* The value of a declaration that is being read (semicolon.h). */
struct declared_value {
    size_t brackets; /* 1 + brackets that are open within the value; 0: no value */
    size_t depth;    /* of the frame with the declaration */
    const struct scene_source *source; /* where the value ends, if not NULL */
    struct text_place place;
};

struct reader {
    struct lexer lexer;
    struct scene_source *sources;
    size_t includes, files;   /* files: number that were read */
    uint64_t bytes;           /* cost of the reading so far */
    struct scene_token token; /* the current token, not consumed yet */
    struct text_place before; /* place after the previous token */
    size_t braces;            /* open before the current token */
    bool closed;              /* the previous token is a closing brace */
    bool directed;            /* the previous token ended a directive that was read
                               * without error */
    bool lost;                /* the previous token ended a directive that has an
                               * error */
    size_t hold;              /* of a directive's value: the number of braces around
                               * it */
    struct declared_value declared;
    size_t nesting;
    size_t condition_count, sealed; /* sealed: number of conditions that cannot be
                                     * closed now */
    struct scene_condition conditions[MAX_CONDITIONS];
    size_t cells;    /* in all arrays */
    uint32_t *seeds; /* states of the streams of random numbers */
    size_t seed_count;
    double version;                /* of the last #version */
    struct scene_token version_at; /* where it was set, if it has a source */

    struct declared_names symbols;
    struct texture default_texture;
    struct scene_object world;
    size_t objects_room; /* capacity of scene->objects */
    size_t floats_room;  /* capacity of scene->floats */
    size_t primitives_made, triangles;
    size_t interiors;                /* the greatest number of an interior */
    const struct kept_image *images; /* a linked list (image_map.c) */
    size_t image_pixels;             /* in all images */
    struct scene *scene;
    bool camera_given;
    struct scene_token fog; /* its first statement, if the scene has fog */

    const struct scene_options *options;
    struct diagnostics *reports;
    struct deduplicated_warnings warnings;
    struct arena arena; /* for formulas */
    struct {
        const struct scene_source *source;
        size_t at;
    } faults[MAX_ERRORS]; /* where errors have been reported */
    size_t fault_count;
    bool stopped; /* after too many errors, or without memory */
};

/* Advances to the next token of a statement. Directives are executed and macros are
 * called on the way, at any position, as in POV-Ray. */
void reader_next(struct reader *reader);

/* Advance within directives. The effect of a directive decides which text follows it.
 * Its last token is therefore left with reader_step, which reads the next token without
 * interpreting it: that token may be a directive, the name of a macro or the end of a
 * frame. reader_resolve then executes directives and calls macros up to the token that
 * reader_next would return. */
void reader_step(struct reader *reader);
void reader_resolve(struct reader *reader);
/* Leaves the last token of a value: with reader_step if a directive ends there. */
void reader_pass(struct reader *reader);
/* Returns the token after the current one, as it is in the frame. It is not
 * consumed. */
struct scene_token reader_peek(struct reader *reader);
/* Pushes the current token back: the next step reads it again, if its frame
 * continues. */
void reader_back(struct reader *reader);
/* Continues at another place of the frame. The current token is dropped, and does not
 * count as a brace. */
void reader_jump(struct reader *reader, const struct text_place *place);
/* Closes the frames above this depth. The text that is left in them may contain
 * directives only. */
void reader_close_frames(struct reader *reader, size_t depth);
enum { HOLD_NONE = -1 };
/* Marks that the values that follow end the current directive. Returns the state for
 * reader_release. */
size_t reader_hold(struct reader *reader);
/* Marks that the values that follow are within the directive. */
size_t reader_nest(struct reader *reader);
void reader_release(struct reader *reader, size_t hold);
/* Ends all reading. Returns false. */
bool reader_stop(struct reader *reader);
/* Adds to the cost of the reading, in bytes. Fails and ends all reading if the limit is
 * exceeded. */
bool reader_spend(struct reader *reader, size_t bytes);

#if defined __GNUC__
#define FORMAT(n) __attribute__((format(printf, n, n + 1)))
#else
#define FORMAT(n)
#endif
/* Reports an error at the token, unless it has one already. Returns false. */
bool reader_fault(struct reader *reader, const struct scene_token *at,
                  const char *format, ...) FORMAT(3);
/* Records a warning about a feature that is replaced or ignored
 * (deduplicated_warnings.h). */
void reader_report(struct reader *reader, const struct scene_token *at,
                   const char *format, ...) FORMAT(3);
/* Reports a warning, even if the value that is being read is never used. */
void reader_warn(struct reader *reader, const struct scene_token *at,
                 const char *format, ...) FORMAT(3);
/* Reports that `what` was expected instead of the current token. Returns false. */
bool reader_expected(struct reader *reader, const char *what);
bool reader_no_memory(struct reader *reader);
/* Reports the error in `fault`; NULL: there is none, and the result is true. */
bool reader_check(struct reader *reader, const struct scene_token *at,
                  const char *fault);

bool reader_at_sign(const struct reader *reader, int sign);
bool reader_accept_sign(struct reader *reader, int sign);
bool reader_expect_sign(struct reader *reader, int sign);
/* Like reader_expect_sign, but the sign stays the current token. */
bool reader_require_sign(struct reader *reader, int sign);
bool reader_accept(struct reader *reader, const char *word);
/* Accepts a comma. Commas between arguments are optional. */
void reader_comma(struct reader *reader);

/* Looks up the value of a word and stores it in the token. Fails if the word has no
 * value. */
bool reader_look_up(struct reader *reader, struct scene_token *token);
/* Returns the value that the current token names, or NULL. */
const struct scene_value *reader_value(const struct reader *reader);
/* Returns a copy of the name of the current token's symbol, which lives as long as the
 * scene. Returns NULL without memory. */
const char *reader_keep_name(struct reader *reader);
/* Stores a named float in the scene, for later passes. Fails without memory. */
bool reader_keep_float(struct reader *reader, const char *name, size_t length,
                       double value);
/* Returns a copy of the items, which the scene owns. Returns NULL without memory, after
 * an error. */
void *reader_keep(struct reader *reader, const void *items, size_t size);
/* Returns the value that the current token names if it is of the kind, else NULL. */
const struct scene_value *reader_value_of(const struct reader *reader,
                                          enum scene_value_kind kind);
/* Like reader_value_of, for a value that is used: its warnings are added to those of
 * the value that is being read. */
const struct scene_value *reader_use(struct reader *reader, enum scene_value_kind kind);

/* Returns true if the scene's version is lower than this one. */
bool reader_is_before(const struct reader *reader, double version);

/* Finds a file that is named in the scene; is_text: not arbitrary bytes. Returns NULL
 * after an error. */
const struct scene_source *reader_find(struct reader *reader,
                                       const struct scene_token *at, const char *name,
                                       bool is_text);

/* Enter and leave a nested construct. reader_enter fails if the nesting is too deep. */
bool reader_enter(struct reader *reader);
void reader_leave(struct reader *reader);

#endif
