/* cmd_check.h - what the files of c205 check share. */
#ifndef ASM_CMD_CHECK_H
#define ASM_CMD_CHECK_H

#include "asm/command/c205_command.h"
#include "asm/lesson/lesson.h"

struct check_command {
    const struct c205_arguments *arguments;
    struct command_output results;
    struct lessons lessons;
    struct lesson own;           /* a teacher's, from a folder */
    const struct lesson *lesson; /* that was named, or NULL */
};

/* Begin with zero; false: the folder is no lesson; to be freed in either case. */
bool check_read_lesson(struct lesson *lesson, const char *path, c205_error *error);
/* A file; the error does not name it. */
bool check_grade(const struct lesson *lesson, const char *path,
                 struct lesson_verdict *verdict, c205_error *error);
/* Adds the sentences, in one line. */
void check_join(struct text_buffer *buffer, const struct lesson_report *report);

/* cmd_check_lesson.c: all lessons; one, with what its tests have; its program to complete.  The
 * exit codes. */
int check_list(const struct check_command *check);
int check_show(const struct check_command *check);
int check_start(const struct check_command *check);

/* cmd_check_folder.c: a folder of answers; the exit code, and whether all that was there could be
 * graded. */
int check_folder(const struct check_command *check, bool *all_graded);

#endif
