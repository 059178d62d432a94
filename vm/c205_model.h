/* c205_model.h - models, which contain the timing constants of machines. */
#ifndef C205_API_MODEL_H
#define C205_API_MODEL_H

#include "c205_word.h"

/* ---- Machine models (vm/time/model.c) --------------------------------------
 *
 * A model is a text file of lines "name value unit source # remark". A source is a
 * letter: P primary, S secondary, D derived, R reconstructed (vm/insn.def), F fitted.
 * Programs run on the built-in models cyber205-1pipe, -2pipe and -4pipe. The
 * projections cdc6600 and cyber720 only supply times. All except cdc6600 are fitted,
 * and NAME-prior is NAME before the fit. NAME-32bit streams words at the rate of half
 * words. cyber205-2pipe-small has small pages.
 */
typedef struct c205_model c205_model;

typedef struct c205_constant {
    const char *name; /* for example "startup.vadd" */
    const char *text; /* the value as in the file */
    double value;     /* for display; the clock uses the exact decimal */
    const char *unit; /* "clk", "clk/element", "clk*pipe/element", "ns", ... */
    char source;      /* source of the value: P primary, S secondary, D derived, R
                         reconstructed, F fitted */
    const char *remark;
} c205_constant;

/* The agreement of a model with published figures, as its text states it. */
typedef struct c205_belief {
    unsigned figures;  /* number of figures; 0: not compared */
    double largest;    /* error in percent, with its sign */
    const char *worst; /* name of the figure with the largest error */
} c205_belief;

/* Converts a text file to plain text in place. A text file is UTF-8. A byte order mark
 * at its start is dropped. CR, LF and CR LF each end a line and become "\n". 0x1A, the
 * end mark of DOS files, ends the text. UTF-16 is rejected. The result ends with NUL,
 * so the buffer must have length + 1 bytes. Returns NULL, or the reason for which the
 * file is not a text. */
const char *c205_plain_text(char *text, size_t *length);

/* Returns a built-in model or reads a file. A name is a file name if it contains '/' or
 * ends in ".model"; "-" is stdin. The model is not changed afterwards. */
c205_model *c205_model_find(const char *name, c205_error *error);
bool c205_model_is_file(const char *name); /* true for the name of a file */
c205_model *c205_model_parse(const char *name, const char *text, c205_error *error);
/* The line and the column of an error in the text of a model. c205_model_read returns
 * them separately from the message, for callers that show the line. Line 0: the error
 * is in no line. */
typedef struct c205_place {
    unsigned line, column; /* count from 1 */
} c205_place;
c205_model *c205_model_read(const char *name, const char *text, c205_place *place,
                            c205_error *error);
void c205_model_free(c205_model *model);

const char *c205_model_name(const c205_model *model);
const char *c205_model_title(const c205_model *model);
/* Return the agreement of the model with the figures used in the fit, and with other
 * figures. */
c205_belief c205_model_fitted(const c205_model *model);
c205_belief c205_model_compared(const c205_model *model);
/* Returns true if the model only supplies times of another machine. */
bool c205_model_is_projection(const c205_model *model);
size_t c205_model_size(const c205_model *model);
const c205_constant *c205_model_constant(const c205_model *model, size_t i);
/* Returns the constant with a name, or NULL. */
const c205_constant *c205_model_lookup(const c205_model *model, const char *name);
/* Returns the model from which this model inherits its constants, or NULL. */
const c205_model *c205_model_like(const c205_model *model);

typedef struct c205_setting {
    const char *name; /* name of a constant */
    double value;     /* in its unit; rounded to six decimal places */
} c205_setting;

/* Returns a copy of a model with these constants changed; their source is R. If several
 * settings name one constant, the last applies. The name of the copy lists the settings
 * ("cyber205-2pipe with machine.pipes 4"), and c205_model_like returns the original.
 * The copy has no comparisons with figures. It borrows the texts of the original, which
 * must outlive it. Returns NULL if a constant does not exist or cannot have that
 * value. */
c205_model *c205_model_change(const c205_model *model, const c205_setting *settings,
                              size_t count, c205_error *error);
/* Returns the names of the built-in models. The last element is NULL. */
const char *const *c205_model_names(void);

#endif
