/* reader.h - the state of the parser of one scene, and its token stream.
 *
 * Every reading function returns false after it has reported an error. Its result is
 * then invalid. A caller that can recover (a block, or the file) skips to the next
 * keyword that it accepts.
 */
#ifndef RT_SCENE_READER_H
#define RT_SCENE_READER_H

#include "rt/scene/language/deduplicated_warnings.h"
#include "rt/scene/language/scene_read.h"
#include "rt/scene/language/symbol.h"

/* Limits that protect stack, memory and time, whatever the file contains. */
#define MAX_ERRORS 200
enum {
    MAX_NESTING = 200,        /* depth of nested blocks and brackets */
    MAX_PRIMITIVES = 1000000, /* primitives and lights, including copies: 2 GB */
    MAX_TRIANGLES = 4000000,  /* triangles of all meshes, including copies: minutes, and
                               * 6 GB */
    MAX_SOLID = 10000,        /* primitives in one tree */
    MAX_FILES = 1000,         /* files that are read; a file is read only once */
    MAX_CONDITIONS = 500,     /* depth of nested conditions */
    MAX_TURNS = 2000000,      /* iterations of one loop */
    MAX_SEEDS = 1000000       /* random streams: 4 MB */
};

/* The default limit of the cost of reading, in bytes of text. Each token adds
 * TOKEN_COST. The text of a loop or macro counts each time it is read. It takes about a
 * minute to reach the limit. */
#define MAX_READING (UINT64_C(8) << 30)
enum {
    TOKEN_COST = 16,
    MEMORY_COST = 8 /* cost of a byte of memory for splines and functions, which limits
                     * it to 1 GiB */
};

/* The conditions and loops that an #end closes. A struct scene_condition is one of them
 * whose #end has not been read. */
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
    struct text_place again; /* loops: where each iteration begins */
    size_t turns, errors;
    struct scene_token name; /* #for: its variable */
    double end, step;
    double value; /* #switch: its value */
    bool chosen;  /* #switch: a case has matched */
};

/* The value of the declaration that is being read (semicolon.h). */
struct declared_value {
    size_t brackets; /* 1 + number of open brackets within the value; 0: no value */
    size_t depth;    /* depth of the frame with the declaration */
    const struct scene_source *source; /* source in which the value ends; NULL:
                                        * unknown */
    struct text_place place;
};

struct reader {
    struct lexer lexer;
    struct scene_source *sources;
    size_t includes, files;   /* files: number of files that were read */
    uint64_t bytes;           /* cost of the reading so far */
    struct scene_token token; /* the current token, which is not consumed */
    struct text_place before; /* place after the previous token */
    size_t braces;            /* number of braces that are open before the current
                               * token */
    bool closed;              /* the previous token is a closing brace */
    bool directed;            /* the previous token ended a directive that was read
                               * without error */
    bool lost;                /* the previous token ended a directive that has an
                               * error */
    size_t hold;              /* for the value of a directive: the number of braces
                               * around it */
    struct declared_value declared;
    size_t nesting;
    size_t condition_count, sealed; /* sealed: number of conditions that cannot be
                                     * closed at present */
    struct scene_condition conditions[MAX_CONDITIONS];
    size_t cells;    /* number of cells in all arrays */
    uint32_t *seeds; /* states of the random streams */
    size_t seed_count;
    double version;                /* version of the last #version */
    struct scene_token version_at; /* place of the last #version, if it has a source */

    struct declared_names symbols;
    struct texture default_texture;
    struct scene_object world;
    size_t objects_room; /* capacity of scene->objects */
    size_t floats_room;  /* capacity of scene->floats */
    size_t primitives_made, triangles;
    size_t interiors;                /* greatest number of an interior so far */
    const struct kept_image *images; /* linked list of images (image_map.c) */
    size_t image_pixels;             /* number of pixels in all images */
    struct scene *scene;
    bool camera_given;
    struct scene_token fog; /* first fog statement, if the scene has fog */

    const struct scene_options *options;
    struct diagnostics *reports;
    struct deduplicated_warnings warnings;
    struct arena arena; /* storage of formulas */
    struct {
        const struct scene_source *source;
        size_t at;
    } faults[MAX_ERRORS]; /* places of reported errors */
    size_t fault_count;
    bool stopped; /* after too many errors, or if out of memory */
};

/* Advances to the next token of a statement. Directives are executed and macros are
 * called on the way, at any position, as in POV-Ray. */
void reader_next(struct reader *reader);

/* These functions advance within a directive. The effect of a directive decides which
 * text follows it, so the token after the directive must not be interpreted before this
 * effect. reader_step reads the next token without interpreting it: it may be a
 * directive, the name of a macro or the end of a frame. reader_resolve then executes
 * directives and calls macros, up to the token that reader_next would return. */
void reader_step(struct reader *reader);
void reader_resolve(struct reader *reader);
/* Advances past the last token of a value. Executes directives and calls macros that
 * follow, unless the value ends a directive (reader_hold). */
void reader_pass(struct reader *reader);
/* Returns the token after the current token in the frame, without consuming it. */
struct scene_token reader_peek(struct reader *reader);
/* Pushes the current token back. The next step reads it again if its frame is still
 * open. */
void reader_back(struct reader *reader);
/* Continues at another place of the frame. The current token is dropped, and does not
 * count as a brace. */
void reader_jump(struct reader *reader, const struct text_place *place);
/* Closes the frames above this depth. Their remaining text may only contain
 * directives. */
void reader_close_frames(struct reader *reader, size_t depth);
enum { HOLD_NONE = -1 };
/* Begins the last argument of a directive. After the last token of this argument,
 * reader_pass does not execute a directive or call a macro. Returns the previous state
 * for reader_release. */
size_t reader_hold(struct reader *reader);
/* Begins a construct, such as parentheses, within which no token can end the directive.
 * Returns the previous state for reader_release. */
size_t reader_nest(struct reader *reader);
void reader_release(struct reader *reader, size_t hold);
/* Stops reading without a further report. Returns false. */
bool reader_stop(struct reader *reader);
/* Adds bytes to the cost of reading. If the cost exceeds its limit, stops reading and
 * returns false. */
bool reader_spend(struct reader *reader, size_t bytes);

#if defined __GNUC__
#define FORMAT(n) __attribute__((format(printf, n, n + 1)))
#else
#define FORMAT(n)
#endif
/* Reports an error at the token, unless an error has been reported there. Returns
 * false. */
bool reader_fault(struct reader *reader, const struct scene_token *at,
                  const char *format, ...) FORMAT(3);
/* Records a warning about a feature that is replaced or ignored
 * (deduplicated_warnings.h). */
void reader_report(struct reader *reader, const struct scene_token *at,
                   const char *format, ...) FORMAT(3);
/* Reports a warning, even if the value that is being read is never used. */
void reader_warn(struct reader *reader, const struct scene_token *at,
                 const char *format, ...) FORMAT(3);
/* Reports that `what` is expected instead of the current token. Returns false. */
bool reader_expected(struct reader *reader, const char *what);
bool reader_no_memory(struct reader *reader);
/* Reports the error `fault` and returns false. If `fault` is NULL, returns true. */
bool reader_check(struct reader *reader, const struct scene_token *at,
                  const char *fault);

/* reader_at_sign returns true if the current token is the sign. reader_accept_sign then
 * also passes the sign. reader_expect_sign reports an error if the current token is not
 * the sign. */
bool reader_at_sign(const struct reader *reader, int sign);
bool reader_accept_sign(struct reader *reader, int sign);
bool reader_expect_sign(struct reader *reader, int sign);
/* Like reader_expect_sign, but the sign stays the current token. */
bool reader_require_sign(struct reader *reader, int sign);
bool reader_accept(struct reader *reader, const char *word);
/* Accepts a comma. Commas between arguments are optional. */
void reader_comma(struct reader *reader);

/* Looks up the value of a word and stores it in the token. Returns false if the word
 * has no value. */
bool reader_look_up(struct reader *reader, struct scene_token *token);
/* Returns the value that the current token names, or NULL. */
const struct scene_value *reader_value(const struct reader *reader);
/* Returns a copy of the name of the current token's symbol. The copy lives as long as
 * the scene. Returns NULL if out of memory. */
const char *reader_keep_name(struct reader *reader);
/* Stores a named float in the scene, for later passes. Returns false if out of
 * memory. */
bool reader_keep_float(struct reader *reader, const char *name, size_t length,
                       double value);
/* Returns a copy of the items, which the scene owns. If out of memory, reports an error
 * and returns NULL. */
void *reader_keep(struct reader *reader, const void *items, size_t size);
/* Returns the value that the current token names if it is of this kind, else NULL. */
const struct scene_value *reader_value_of(const struct reader *reader,
                                          enum scene_value_kind kind);
/* Like reader_value_of, for a value that is used: the value's warnings are added to the
 * value that is being read. */
const struct scene_value *reader_use(struct reader *reader, enum scene_value_kind kind);

/* Returns true if the scene's version is below this version. */
bool reader_is_before(const struct reader *reader, double version);

/* Finds a file that is named in the scene. is_text: the file is text, not arbitrary
 * bytes. Returns NULL after an error. */
const struct scene_source *reader_find(struct reader *reader,
                                       const struct scene_token *at, const char *name,
                                       bool is_text);

/* Enter and leave a nested construct. reader_enter reports an error if the nesting is
 * too deep. */
bool reader_enter(struct reader *reader);
void reader_leave(struct reader *reader);

#endif
