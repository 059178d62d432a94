/* many_scenes.h - arguments, exit status and files of checks with random scenes. */
#ifndef MANY_SCENES_H
#define MANY_SCENES_H

#include "rt/scene/scene.h"
#include "rt/trace/trace.h"
#include "tests/oracle/give_up.h"
#include "vm/c205.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Returns the model for the traces. The caller frees it. */
c205_model *usual_model(void);
/* Reads a scene. After an error, prints it and the messages, and exits with 2. */
struct scene *scene_of(const char *text);
/* Returns the options for a frame of this size. */
struct trace_options sized(struct trace_options form, size_t width, size_t height);
/* Returns a finished trace on check_many's model. A failure ends the program. */
struct trace *traced_in(const struct scene *scene, struct trace_options options);
/* Traces the scene of `expected` with other options, in the same size. The frames must
 * be equal bit for bit, and their numbers of rays must be equal. Otherwise writes a
 * reason of at most MANY_REASON characters, which ends with the options, and returns
 * false. */
bool same_in_form(const struct scene *scene, const struct trace *expected,
                  struct trace_options form, char *reason);
/* Writes a file in the current folder. Errors are ignored: the text is also printed. */
void keep_scene(const char *path, const char *text);

/* The model for the traces, valid during check_many. */
extern c205_model *check_model;
/* Parses CHECK [SCENES [OF SHARE]] [--first], and checks the scenes 0 to SCENES - 1
 * (default 300), or every OF-th of them from SHARE on. With --first it stops at the
 * first failure, which is not reduced. begin may be NULL. It is called for each scene,
 * up to `ahead` scenes before that scene is checked. Prints the counts, and returns the
 * exit status, which is 1 if a scene failed. */
int check_many(int count, char **words, bool (*check)(size_t number, bool first),
               void (*begin)(size_t number), size_t ahead);

/* The values in which all tracers must agree. Where faces of several objects may
 * coincide, rounding decides which face is visible. If the camera may be in a face,
 * rounding decides whether the face is visible. */
enum certainty { NOTHING_CERTAIN, DEPTH_CERTAIN, ALL_CERTAIN };

/* A random scene. other: the same objects in another order or place, or NULL. */
struct random_scene {
    size_t number;
    char *text, *other;
    size_t width, height; /* size of the frame in pixels; 0: any */
    enum certainty certainty;
    double work;    /* approximate number of tests of a ray with a primitive in this
                     * frame */
    uint64_t state; /* random state after the scene was generated */
};

/* A check of random scenes of one kind. Scene N has the seed RANDOM_SEED ^ (N + 1) *
 * seed. */
struct random_check {
    const char *kind;
    uint64_t seed;
    struct random_scene (*draw)(uint64_t *state, size_t number);
    /* Returns false on failure, with a reason of at most MANY_REASON characters. */
    bool (*passes)(struct random_scene *scene, char *reason);
    bool shrinks; /* the reduced text is checked without `other` */
    void (*begin)(size_t number);
    size_t ahead;
};
enum { MANY_REASON = 600 };

/* Calls check_many. A failing scene is reduced while it fails, printed, and written to
 * KIND_NUMBER.pov. With --first it is not reduced, and the check stops. */
int check_random(int count, char **words, const struct random_check *check);

/* Defines main for a check with these members. */
#define RANDOM_CHECK(...) \
    int main(int count, char **words) \
    { \
        static const struct random_check check = { __VA_ARGS__ }; \
        return check_random(count, words, &check); \
    }

#endif
