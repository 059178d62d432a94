/* pixel_rays.h - finds the rays of a pixel in the current queue of a machine, and the
 * elements of vectors that belong to these rays.
 *
 * All data is read from the machine's memory and registers, at any time of a run. A
 * queue is current from the generation of its rays to their shading. The descriptor of
 * its importances (queue_importance in rt/kernels/solids/levels_vector.s) identifies
 * it. A camera ray belongs to the pixel if both have the same index in the planes of
 * the band. The indices of a queue's camera rays are consecutive, or are in a vector
 * (queue_order). Every other ray has the index of its parent ray (LIST_PARENT), and the
 * chain of parents leads to a camera ray.
 *
 * The vectors of the queue always have an element for each ray. While a kernel tests
 * rays, the vector `ray_index` has the positions of these rays in the queue, and other
 * vectors of queue.s with the same length have the same rays in the same order. While
 * hits are shaded, the vector `at` has the positions of the hits in the queue, and the
 * vectors after `at` have the same hits in the same order.
 */
#ifndef RT_PIXEL_RAYS_H
#define RT_PIXEL_RAYS_H

#include "rt/view/frame_pixel.h"

/* Groups of vectors. In a group, element i of all vectors belongs to the same ray. */
enum pixel_group {
    PIXEL_QUEUE, /* all rays of the queue; in the scalar form only the pixel */
    PIXEL_NEAR,  /* the rays that a kernel currently tests */
    PIXEL_HITS,  /* the hits, during shading; vector form only */
    PIXEL_GROUPS
};

/* The element of a vector that belongs to a ray of the pixel. Until the kernels write
 * the element, its word is from an earlier queue. */
struct pixel_element {
    enum pixel_group group;
    size_t list; /* list of the queue; 0: camera rays; n: rays spawned by list n - 1 */
    size_t lane, length;
    const char *vector; /* name of the vector in the program */
    c205_word word;
};

/* Calls the listener for each vector element that belongs to a ray of the pixel, ray by
 * ray and group by group. Returns the number of rays of the pixel in the current
 * queue. */
typedef void pixel_listener(void *context, const struct pixel_element *element);
size_t pixel_elements(const struct frame_pixel *pixel, const c205 *machine,
                      pixel_listener *listener, void *context);

bool pixel_is_in_queue(const struct frame_pixel *pixel, const c205 *machine);
/* Returns true if the machine is at the label where a queue with rays of the pixel has
 * just been generated. */
bool pixel_is_made(const struct frame_pixel *pixel, const c205 *machine);
/* Returns the label that pixel_is_made tests, at which a queue has just been
 * generated. */
const char *pixel_made_label(const struct frame_pixel *pixel);

#endif
