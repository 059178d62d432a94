/* many_scenes.h - what checks of random scenes have in common: how they are
 * called, how they end, what they leave. */
#ifndef MANY_SCENES_H
#define MANY_SCENES_H

#include "rt/scene/scene.h"
#include "rt/trace/trace.h"
#include "vm/c205.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Say why, and end the program with 2. */
void give_up(const char *message);
/* The model that they are traced on, which the caller frees. */
c205_model *usual_model(void);
/* Gives up, with the text and what is wrong with it, where it is no scene. */
struct scene *scene_of(const char *text);
/* A trace that has run; gives up if it fails. */
struct trace *traced_in(const struct scene *scene, struct trace_options options);
/* Bit for bit; false: the reason, in MANY_REASON characters. */
bool same_frames(const struct trace *expected, const struct trace *found, size_t width,
                 size_t height, char *reason);
/* To a file in the folder of the run; without one nothing is lost that is not
 * printed. */
void keep_scene(const char *path, const char *text);

/* CHECK [SCENES [OF SHARE]] [--first]: check the scenes 0 .. SCENES - 1 (300),
 * or every OF-th of them from SHARE on; first: until one fails, of which no
 * more is wanted.  begin, or NULL, is called for each scene, up to so many before it is
 * checked.  Prints the counts; returns the program's exit code. */
int check_many(int count, char **words, bool (*check)(size_t number, bool first),
               void (*begin)(size_t number), size_t ahead);

/* What must be the same to any tracer: where faces of several things may coincide
 * a rounding decides which is seen, and where the eye may be in one, if it is. */
enum certainty { NOTHING_CERTAIN, DEPTH_CERTAIN, ALL_CERTAIN };

/* A random scene.  Other: of the same things, in another order or another place; or
 * NULL. */
struct random_scene {
    size_t number;
    char *text, *other;
    size_t width, height; /* of its frame, in pixels; 0: any */
    enum certainty certainty;
    double work;    /* rays that meet primitives in that frame, roughly */
    uint64_t state; /* after it was drawn */
};

/* A check of random scenes: of number N from the state RANDOM_SEED ^ (N + 1) x seed. */
struct random_check {
    const char *kind;
    uint64_t seed;
    struct random_scene (*draw)(uint64_t *state, size_t number);
    /* False: the reason, in MANY_REASON characters. */
    bool (*passes)(struct random_scene *scene, char *reason);
    bool shrinks; /* a scene without its other one may be checked, too */
    void (*begin)(size_t number);
    size_t ahead;
};
enum { MANY_REASON = 600 };

/* Calls check_many.  A scene that fails is made smaller as long as it fails, printed, and
 * written to KIND_NUMBER.pov; after --first nothing more is done, not even that. */
int check_random(int count, char **words, const struct random_check *check);

#endif
