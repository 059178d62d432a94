/* text.h - text files that are compiled into a program (made by embed.sh). */
#ifndef C205_TEXT_H
#define C205_TEXT_H

struct text {
    const char *name;         /* file name without the folder */
    const char *const *lines; /* with newlines; NULL at the end */
};

extern const struct text model_texts[];       /* files of vm/models */
extern const char *const model_texts_names[]; /* names without ".model" */
extern const struct text library_texts[];     /* files of asm/lib */
extern const struct text kernel_texts[];      /* files of rt/kernels */
extern const struct text isa_example_texts[]; /* files of asm/isa_examples */
extern const struct text card_texts[];        /* files of asm/card */
extern const struct text lesson_texts[];      /* docs/course, a folder for each
                                                 lesson */

#endif
