/* cmd_check.h - the arguments and the state of c205 check, and the functions that its
 * files share. */
#ifndef ASM_CMD_CHECK_H
#define ASM_CMD_CHECK_H

#include "asm/command/session.h"
#include "asm/lesson/lesson.h"

struct check_arguments {
    struct shared_arguments shared;
    const char *lesson, *answer; /* NULL: none */
    const char *folder;          /* folder of answers, or NULL */
    const char *output;          /* destination of the program to complete; NULL:
                                    stdout */
    bool hints, start, no_fresh;
    size_t fresh, seed; /* draws of fresh tests, and the number of the first; 0: none */
};

struct check_command {
    const struct check_arguments *args;
    struct command_output results;
    struct lessons lessons;
    struct lesson own;           /* lesson from a folder */
    const struct lesson *lesson; /* lesson named by the arguments, or NULL */
};

/* Reads a lesson from a folder. The lesson must be zeroed. Returns false if the folder
 * is not a lesson. The lesson must be freed in all cases. */
bool check_read_lesson(struct lesson *lesson, const char *path, c205_error *error);
/* Grades a file. The error does not contain its name. */
bool check_grade(const struct check_command *check, const struct lesson *lesson,
                 const char *path, struct lesson_verdict *verdict, c205_error *error);
/* Appends all sentences of a report to a buffer, as one line. */
void check_join(struct text_buffer *buffer, const struct lesson_report *report);

/* check_list prints all lessons. check_show prints one lesson with its tests.
 * check_start writes the incomplete program of a lesson, which a student completes
 * (cmd_check_lesson.c). All three return the exit code. */
int check_list(const struct check_command *check);
int check_show(const struct check_command *check);
int check_start(const struct check_command *check);

/* Grades a folder of answers (cmd_check_folder.c). Returns the exit code. Sets
 * *all_graded to true if all files could be graded. */
int check_folder(const struct check_command *check, bool *all_graded);

#endif
