/* pixel_rays.h - the rays of a pixel in the queues of its band's machine, and what the queues'
 * vectors have of them, at any moment.
 *
 * All of it is read in the machine's memory and registers.  The program has a queue at hand
 * from when its rays are made to when they are shaded; a descriptor says which one
 * (queue_importance in rt/kernels/solids/levels_vector.s).  A ray of the camera is the
 * pixel's if its place in the band's planes is; places follow one another, or are in a
 * vector (queue_order).  Another ray has the place of the one that it comes of with it
 * (LIST_PARENT), and so on up to the camera.  While a kernel meets the rays at hand a vector
 * has their places in the queue (place), and the others that queue.s makes as long have the
 * same rays in the same order; while hits are shaded another one has the places of the hits
 * (at).  Of vectors besides nothing is told.
 */
#ifndef RT_PIXEL_RAYS_H
#define RT_PIXEL_RAYS_H

#include "rt/view/frame_pixel.h"

/* Vectors whose elements belong to rays in one order. */
enum pixel_group {
    PIXEL_QUEUE, /* the queue; in scalar form the pixel by itself */
    PIXEL_NEAR,  /* the rays at hand, while a kernel meets them */
    PIXEL_HITS,  /* what was hit, while it is shaded; vector form only */
    PIXEL_GROUPS
};

/* What a vector has of a ray of the pixel: of this queue, once the kernels have come to it. */
struct pixel_element {
    enum pixel_group group;
    size_t
        list; /* the queue's: 0: rays of the camera; n: what comes of those of list n - 1 */
    size_t lane, length;
    const char *vector; /* the program's name of it */
    c205_word word;
};

/* Ray by ray, group by group; how many of the pixel's rays are in the queue at hand. */
typedef void pixel_listener(void *context, const struct pixel_element *element);
size_t pixel_elements(const struct frame_pixel *pixel, const c205 *machine,
                      pixel_listener *listener, void *context);

bool pixel_is_in_queue(const struct frame_pixel *pixel, const c205 *machine);
/* Whether the machine is where a queue has just been made, with rays of the pixel. */
bool pixel_is_made(const struct frame_pixel *pixel, const c205 *machine);
/* The label of that place. */
const char *pixel_made_label(const struct frame_pixel *pixel);

#endif
