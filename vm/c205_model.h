/* c205_model.h - models: the timing constants of a machine. */
#ifndef C205_API_MODEL_H
#define C205_API_MODEL_H

#include "c205_word.h"

/* ---- Machine models (vm/time/model.c) --------------------------------------
 *
 * A model is a text file of lines "name value unit source # remark". The sources are
 * the letters P S D R of the instruction table, and F: fitted. Built in are
 * cyber205-1pipe, -2pipe and -4pipe, on which programs run, and the projections cdc6600
 * and cyber720, which only supply times. All but the 6600 were fitted; NAME-prior is
 * the state of NAME before the fit. NAME-32bit streams words at the rate of half words.
 * cyber205-2pipe-small has small pages.
 */
typedef struct c205_model c205_model;

typedef struct c205_constant {
    const char *name; /* for example "startup.vadd" */
    const char *text; /* the value as written */
    double value;     /* for display; the clock uses the exact decimal */
    const char *unit; /* "clk", "clk/element", "clk*pipe/element", "ns", ... */
    char source;      /* P S D R F */
    const char *remark;
} c205_constant;

/* The agreement of a model with published figures, as stated in its text. */
typedef struct c205_belief {
    unsigned figures;  /* number of figures; 0: not compared */
    double largest;    /* the largest error, percent */
    const char *worst; /* name of the figure with the largest error */
} c205_belief;

/* Converts a text file to plain text in place. A text file is UTF-8. A byte order mark
 * at its start is dropped. CR, LF and CR LF each end a line and become "\n". 0x1A, the
 * end mark of DOS files, ends the text. UTF-16 is rejected. The result ends with NUL,
 * so there must be room for length + 1 bytes. Returns NULL, or the reason why it is not
 * a text. */
const char *c205_plain_text(char *text, size_t *length);

/* Returns a built-in model, or reads a file if the name contains '/', ends in ".model"
 * or is "-", which is stdin. The model is not changed afterwards. */
c205_model *c205_model_find(const char *name, c205_error *error);
bool c205_model_is_file(const char *name); /* returns true for the name of a file */
c205_model *c205_model_parse(const char *name, const char *text, c205_error *error);
/* c205_model_read parses a model for callers that show the line. The error message
 * lacks the place, which is returned separately; line 0: no line. */
typedef struct c205_place {
    unsigned line, column; /* from 1 */
} c205_place;
c205_model *c205_model_read(const char *name, const char *text, c205_place *place,
                            c205_error *error);
void c205_model_free(c205_model *model);

const char *c205_model_name(const c205_model *model);
const char *c205_model_title(const c205_model *model);
/* The comparisons with the figures used in the fit, and with other figures. */
c205_belief c205_model_fitted(const c205_model *model);
c205_belief c205_model_compared(const c205_model *model);
/* Returns true if the model holds the times of another machine, for a projection
 * only. */
bool c205_model_is_projection(const c205_model *model);
size_t c205_model_size(const c205_model *model);
const c205_constant *c205_model_constant(const c205_model *model, size_t i);
/* NULL: no such constant. */
const c205_constant *c205_model_lookup(const c205_model *model, const char *name);
/* Returns the model whose constants it inherits, or NULL. */
const c205_model *c205_model_like(const c205_model *model);

typedef struct c205_setting {
    const char *name; /* of a constant */
    double value;     /* in its unit; rounded to six decimal places */
} c205_setting;

/* Returns a copy of a model with these constants changed; their source is R. The last
 * of several settings of one constant counts. Its name lists the settings
 * ("cyber205-2pipe with machine.pipes 4"), c205_model_like returns the original, and it
 * has no comparisons with figures. It borrows the texts of the original, which must
 * outlive it. NULL: a constant does not exist, or cannot have that value. */
c205_model *c205_model_change(const c205_model *model, const c205_setting *settings,
                              size_t count, c205_error *error);
/* Returns the names of the built-in models, NULL at the end. */
const char *const *c205_model_names(void);

#endif
