/* reader.h - the state of reading one scene, and its tokens.
 *
 * Every function that reads returns false after it has reported an error; what
 * it was to make is then worth nothing.  The caller that can continue (a block,
 * or the file) skips to the next word that it knows.
 */
#ifndef RT_SCENE_READER_H
#define RT_SCENE_READER_H

#include "rt/scene/language/note.h"
#include "rt/scene/language/scene_read.h"
#include "rt/scene/language/symbol.h"

/* Bounds, so that no file takes the program's stack, memory or patience. */
#define MAX_ERRORS 200
enum {
    MAX_NESTING = 200,        /* blocks and brackets within each other */
    MAX_PRIMITIVES = 1000000, /* and lights, copies counted: 2 GB */
    MAX_TRIANGLES = 4000000,  /* of meshes, likewise: minutes, and 6 GB */
    MAX_SOLID = 10000,        /* primitives in one tree */
    MAX_FILES = 1000,         /* read; each once */
    MAX_CONDITIONS = 500,     /* within each other */
    MAX_TURNS = 2000000,      /* of one loop */
    MAX_SEEDS = 1000000       /* of random numbers: 4 MB */
};

/* Bytes of text that may be read, unless the options of the scene say another
 * number; each token counts as some more, and what a loop or a macro reads
 * again counts again.  About a minute. */
#define MAX_READING (UINT64_C(8) << 30)
enum {
    TOKEN_COST = 16,
    MEMORY_COST = 8 /* of a byte in splines and functions: 1 GiB */
};

/* A directive whose #end has not come. */
enum condition_kind {
    CONDITION_IF, /* and #ifdef, #ifndef */
    CONDITION_WHILE,
    CONDITION_FOR,
    CONDITION_SWITCH
};
struct scene_condition {
    enum condition_kind kind;
    struct scene_token at;
    size_t frame; /* its serial number */
    bool in_else;
    struct text_place again; /* of a loop: where each turn begins */
    size_t turns, errors;
    struct scene_token name; /* of #for */
    double end, step;
    double value; /* of #switch */
    bool chosen;  /* .. a case is */
};

/* The value of a declaration that is being read (semicolon.h). */
struct declared_value {
    size_t brackets; /* 1 and those open within the value; 0: no value */
    size_t depth;    /* of frames, where the declaration is */
    const struct scene_source *source; /* where it ends, if not NULL */
    struct text_place place;
};

struct reader {
    struct lexer lexer;
    struct scene_source *sources;
    size_t includes, files;   /* files: that were read */
    uint64_t bytes;           /* read, and counted as such */
    struct scene_token token; /* the next to be read, */
    struct text_place before; /* .. behind the one before it */
    size_t braces;            /* open before it */
    bool closed;              /* the one before is a closing brace */
    bool directed;            /* .. or a directive that was read well, */
    bool lost;                /* .. or one that was not */
    size_t hold;              /* of a directive's value: the braces around it */
    struct declared_value declared;
    size_t nesting;
    size_t condition_count, sealed; /* the latter of them cannot be closed */
    struct scene_condition conditions[MAX_CONDITIONS];
    size_t cells;    /* of all arrays */
    uint32_t *seeds; /* of the streams of random numbers */
    size_t seed_count;
    double version;                /* by #version */
    struct scene_token version_at; /* .. if it has a source */

    struct declared_names symbols;
    struct texture default_texture;
    struct scene_object world;
    size_t objects_room; /* for what is told of those in it */
    size_t floats_room;  /* .. for floats that have names */
    size_t primitives_made, triangles;
    size_t interiors;                /* the greatest number of one */
    const struct kept_image *images; /* the last one (image_map.c) */
    size_t image_pixels;             /* of all of them */
    struct scene *scene;
    bool camera_given;
    struct scene_token fog; /* the first one, if the scene has any */

    const struct scene_options *options;
    struct diagnostics *reports;
    struct deduplicated_warnings warnings;
    struct arena arena; /* of formulas */
    struct {
        const struct scene_source *source;
        size_t at;
    } faults[MAX_ERRORS]; /* where errors are */
    size_t fault_count;
    bool stopped; /* too many errors, or no memory */
};

/* To the next token of a statement: directives are carried out and macros
 * called on the way, wherever they stand, as POV-Ray does. */
void reader_next(struct reader *reader);

/* For directives.  What is behind a directive depends on what it does, so its
 * last token is left by reader_step, to the next token as it is: it may be
 * a directive, a macro's name or the end of a frame.  reader_resolve makes of
 * that what reader_next comes to. */
void reader_step(struct reader *reader);
void reader_resolve(struct reader *reader);
/* Behind the last token of a value: reader_step if a directive ends there. */
void reader_pass(struct reader *reader);
/* The token after the next one, as the frame has it; it is not read yet. */
struct scene_token reader_peek(struct reader *reader);
/* The token comes again with the next step, if its frame continues. */
void reader_back(struct reader *reader);
/* On from another place of the frame: the token is not read, nor is it a brace
 * that opens or closes anything. */
void reader_jump(struct reader *reader, const struct text_place *place);
/* The rest of the frames above, if it is directives. */
void reader_close_frames(struct reader *reader, size_t depth);
enum { HOLD_NONE = -1 };
/* The values that are read next end the directive; returns what to give to
 * reader_release. */
size_t reader_hold(struct reader *reader);
/* .. are within it. */
size_t reader_nest(struct reader *reader);
void reader_release(struct reader *reader, size_t hold);
/* All reading ends here.  Returns false. */
bool reader_stop(struct reader *reader);
/* Effort other than reading, in bytes.  False: too much, all reading ends. */
bool reader_spend(struct reader *reader, size_t bytes);

#if defined __GNUC__
#define FORMAT(n) __attribute__((format(printf, n, n + 1)))
#else
#define FORMAT(n)
#endif
/* An error at the token, unless there is one.  Returns false. */
bool reader_fault(struct reader *reader, const struct scene_token *at,
                  const char *format, ...) FORMAT(3);
/* Something that is replaced or left out: a note (note.h). */
void reader_report(struct reader *reader, const struct scene_token *at,
                   const char *format, ...) FORMAT(3);
/* Something to be told, whatever is being read. */
void reader_warn(struct reader *reader, const struct scene_token *at,
                 const char *format, ...) FORMAT(3);
/* The error that `what` stands not here.  Returns false. */
bool reader_expected(struct reader *reader, const char *what);
bool reader_no_memory(struct reader *reader);
/* The error that text says, if any. */
bool reader_check(struct reader *reader, const struct scene_token *at,
                  const char *fault);

bool reader_at_sign(const struct reader *reader, int sign);
bool reader_accept_sign(struct reader *reader, int sign);
bool reader_expect_sign(struct reader *reader, int sign);
bool reader_accept(struct reader *reader, const char *word);
/* Commas between arguments may be left out. */
void reader_comma(struct reader *reader);

/* The value of what a word names, into the token; false: it names nothing. */
bool reader_look_up(struct reader *reader, struct scene_token *token);
/* The value that the next token names, or NULL. */
const struct scene_value *reader_value(const struct reader *reader);
/* The name of the symbol that the next token stands for, as long as the scene lives;
 * NULL: no memory. */
const char *reader_keep_name(struct reader *reader);
/* A float of that name, for who reads the scene.  False: no memory. */
bool reader_keep_float(struct reader *reader, const char *name, size_t length,
                       double value);
/* The same if it is of the kind. */
const struct scene_value *reader_value_of(const struct reader *reader,
                                          enum scene_value_kind kind);
/* The same, to be used: its notes are those of what is being read. */
const struct scene_value *reader_use(struct reader *reader, enum scene_value_kind kind);

/* Whether the scene is of a version before that one. */
bool reader_is_before(const struct reader *reader, double version);

/* A file that the text names, a text or any bytes; NULL after an error. */
const struct scene_source *reader_find(struct reader *reader,
                                       const struct scene_token *at, const char *name,
                                       bool is_text);

/* Enter and leave what may be within itself; false: too deep. */
bool reader_enter(struct reader *reader);
void reader_leave(struct reader *reader);

#endif
