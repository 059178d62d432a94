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
    const char *tests;           /* folder of unpublished tests, or NULL */
    const char *feedback;        /* folder of files for the students, or NULL */
    bool hints, start, no_fresh;
    size_t fresh, seed; /* draws of fresh tests, and the number of the first; 0: none */
};

struct check_command {
    const struct check_arguments *args;
    struct command_output results;
    struct lessons lessons;
    struct lesson own;     /* lesson from a folder */
    struct lesson *lesson; /* lesson named by the arguments, or NULL */
};

/* Appends the path of a name in a folder. Returns false if memory is exhausted. */
bool check_join_path(struct text_buffer *path, const char *folder, const char *name);

/* ---- cmd_check_read.c: lessons from folders ------------------------------------ */

/* Reads a lesson from a folder. The lesson must be zeroed. Returns false if the folder
 * is not a lesson. The lesson must be freed in all cases. */
bool check_read_lesson(struct lesson *lesson, const char *path, c205_error *error);
/* Adds unpublished tests: DIR/test-NAME.s to the lesson of the arguments, or
 * DIR/NN-LESSON/test-NAME.s to all lessons. */
bool check_read_tests(struct check_command *check, c205_error *error);

/* ---- Answers ------------------------------------------------------------------- */

/* Grades the answer in a file. The error message does not contain the name of the
 * file. */
bool check_grade(const struct check_command *check, const struct lesson *lesson,
                 const char *path, struct lesson_verdict *verdict, c205_error *error);
/* Appends all sentences of a report to a buffer, as one line. */
void check_join(struct text_buffer *buffer, const struct lesson_report *report);

/* ---- cmd_check_lesson.c: the texts of lessons ---------------------------------- */

/* check_list prints all lessons. check_show prints one lesson with its tests.
 * check_start writes the incomplete program of a lesson, which a student completes.
 * check_fresh prints the fresh tests of a draw. All four return the exit code. */
int check_list(const struct check_command *check);
int check_show(const struct check_command *check);
int check_start(const struct check_command *check);
int check_fresh(const struct check_command *check);

/* ---- cmd_check_feedback.c: files for the students ------------------------------- */

/* A graded answer of a student. student is "" if it is unknown. */
struct hand_in {
    const char *student;
    const char *path; /* within the folder of the class */
    char date[20];    /* time of the last change, in UTC; "": unknown */
    const struct lesson_verdict *verdict;
};

/* The verdicts on the answers of a student, or for a lesson if the students are
 * unknown. */
struct feedback_page {
    const char *name;
    struct text_buffer text;
};
struct feedback {
    size_t count, capacity;
    struct feedback_page *pages;
    struct arena kept;
};
void feedback_add(struct feedback *feedback, const struct hand_in *hand_in);
/* Writes a file NAME.txt for each student. */
bool feedback_write(const struct feedback *feedback, const char *folder,
                    c205_error *error);
void feedback_free(struct feedback *feedback);

/* ---- cmd_check_folder.c: folders of answers ------------------------------------- */

/* Grades a folder of answers. Returns the exit code. Sets
 * *all_graded to true if all files could be graded. */
int check_folder(const struct check_command *check, bool *all_graded);

#endif
