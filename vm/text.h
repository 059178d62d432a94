/* text.h - text files that are compiled into a program (made by embed.sh). */
#ifndef C205_TEXT_H
#define C205_TEXT_H

struct text {
    const char *name;         /* file name without the folder */
    const char *const *lines; /* with newlines; NULL at the end */
};

extern const struct text model_texts[];       /* vm/models */
extern const char *const model_texts_names[]; /* without ".model" */
extern const struct text library_texts[];     /* asm/lib */
extern const struct text kernel_texts[];      /* rt/kernels */
extern const struct text isa_example_texts[]; /* asm/isa_examples */
extern const struct text card_texts[];        /* asm/card */
extern const struct text lesson_texts[];      /* docs/course, a folder for each
                                                 lesson */

#endif
