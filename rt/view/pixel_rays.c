/* pixel_rays.c - finds the rays of a pixel in the queues of a machine. */
#include "rt/view/pixel_rays.h"

#include <string.h>

/* The pixel, the machine, and the function that receives the elements. */
struct pixel_look {
    const struct frame_pixel *pixel;
    const struct object *program;
    const c205 *machine;
    pixel_listener *listener;
    void *context;
};

static struct pixel_look look_at(const struct frame_pixel *pixel, const c205 *machine)
{
    return (struct pixel_look){ .pixel = pixel,
                                .program = trace_program(pixel->trace),
                                .machine = machine };
}

static enum trace_mode mode_of(const struct pixel_look *look)
{
    return trace_how(look->pixel->trace)->mode;
}

/* ---- Memory and registers, by the program's names ------------------------- */

static uint64_t value_of(const struct pixel_look *look, const char *name)
{
    return (uint64_t)object_symbol(look->program, name)->value;
}

static c205_word word_at(const struct pixel_look *look, uint64_t address)
{
    c205_word word = 0;
    c205_read(look->machine, address, &word, 1);
    return word;
}

static c205_word word_of(const struct pixel_look *look, const char *name)
{
    return word_at(look, value_of(look, name));
}

/* Returns the value of the first register with this name. It is the register that
 * queue.s declares; later declarations of the name are for other purposes. */
static c205_word register_of(const struct pixel_look *look, const char *name)
{
    const struct asm_register *known = look->program->registers;
    while (strcmp(known->name, name) != 0)
        known++;
    return c205_register(look->machine, known->number);
}

static bool is_between(const struct pixel_look *look, uint64_t address,
                       const char *first, const char *end)
{
    return address >= value_of(look, first) && address < value_of(look, end);
}

/* ---- The current queue ------------------------------------------------------ */

struct queue {
    size_t list;    /* number of the queue's list */
    size_t first;   /* index of its first ray in the list */
    size_t count;   /* number of rays */
    uint64_t order; /* address of the rays' indices in the planes, or 0 if they are
                     * consecutive */
};

/* Returns true if the program is between two queues. */
static bool is_outside(const struct pixel_look *look)
{
    static const char *const regions[] = { "frame", "generate", "resolve", "camera",
                                           "average" };
    const char *region = object_region(look->program, c205_pc(look->machine));
    for (size_t i = 0; i < sizeof regions / sizeof *regions; i++)
        if (strcmp(region, regions[i]) == 0)
            return true;
    return false;
}

/* Returns the address of vector number `vector` of a list. */
static uint64_t list_vector(const struct pixel_look *look, size_t list, uint64_t vector)
{
    return word_of(look, "scene_levels")
           + 64
                 * (list * value_of(look, "LEVEL_SIZE") + value_of(look, "LEVEL_LIST")
                    + vector * value_of(look, "LIST"));
}

/* Finds the current queue by the address of its importances. For camera rays it is the
 * address of a constant, for other rays an address in a list of rays. Returns false if
 * there is no queue. */
static bool find_queue(const struct pixel_look *look, struct queue *queue)
{
    c205_word importance = word_of(look, "queue_importance");
    uint64_t levels = word_of(look, "scene_levels");
    uint64_t record = 64 * value_of(look, "LEVEL_SIZE");
    uint64_t at = c205_descriptor_address(importance);
    *queue = (struct queue){ .count = c205_descriptor_length(importance) };
    if (queue->count == 0 || is_outside(look))
        return false;
    if (at == value_of(look, "importance_one")) {
        queue->first = (size_t)c205_to_integer(
            word_at(look, levels + 64 * value_of(look, "LEVEL_POSITION")));
        queue->order = c205_descriptor_address(word_of(look, "queue_order"));
        return true;
    }
    queue->list = (size_t)((at - levels) / record);
    at -= list_vector(look, queue->list, value_of(look, "LIST_IMPORTANCE"));
    queue->first = (size_t)(at / 64);
    return true;
}

/* Returns the index of a camera ray in the band's planes. */
static size_t place_of_ray(const struct pixel_look *look, const struct queue *queue,
                           size_t ray)
{
    return queue->order
               ? (size_t)c205_to_integer(word_at(look, queue->order + 64 * ray))
               : queue->first + ray;
}

/* Returns true if the ray of the queue descends from the pixel. */
static bool is_of_pixel(const struct pixel_look *look, const struct queue *queue,
                        size_t ray)
{
    size_t list = queue->list;
    size_t place = list > 0 ? queue->first + ray : place_of_ray(look, queue, ray);
    for (; list > 0; list--)
        place = (size_t)c205_to_integer(
            word_at(look, list_vector(look, list, value_of(look, "LIST_PARENT"))
                              + 64 * place));
    return place == look->pixel->place;
}

/* ---- Elements ---------------------------------------------------------------- */

static void notify(const struct pixel_look *look, const struct pixel_element *of,
                   const char *vector, uint64_t address)
{
    struct pixel_element element = *of;
    element.vector = vector;
    element.word = word_at(look, address);
    look->listener(look->context, &element);
}

/* Notifies the listener of one element of each named vector. `address` is the address
 * of the element in the first vector. The vectors are at intervals of `stride`
 * words. */
static void list_words(const struct pixel_look *look, const struct pixel_element *of,
                       const char *const *names, uint64_t address, uint64_t stride)
{
    for (; *names; names++, address += 64 * stride)
        notify(look, of, *names, address);
}

static const char *const rays[] = { "aox", "aoy", "aoz", "adx", "ady", "adz", NULL };
static const char *const hit_symbols[] = { "nearest", "nearest_primitive", "hit_s",
                                           "hit_t", NULL };
static const char *const colours[] = { "out_red", "out_green", "out_blue", NULL };
static const char *const planes[] = { "out_red",   "out_green", "out_blue",
                                      "out_depth", "out_nx",    "out_ny",
                                      "out_nz",    "out_id",    NULL };

static void list_queue(const struct pixel_look *look, const struct queue *queue,
                       size_t ray)
{
    const struct pixel_element of = { .list = queue->list,
                                      .lane = ray,
                                      .length = queue->count };
    uint64_t length = value_of(look, "QUEUE");
    uint64_t store = value_of(look, "queue_store") + 64 * ray;
    uint64_t in_list = 64 * (queue->first + ray);
    if (queue->list == 0)
        list_words(look, &of, rays, store, length);
    else
        list_words(look, &of, rays,
                   in_list + list_vector(look, queue->list, value_of(look, "LIST_RAY")),
                   value_of(look, "LIST"));
    list_words(look, &of, hit_symbols, store + 64 * 6 * length, length);
    if (queue->list == 0)
        list_words(look, &of, planes,
                   word_of(look, "scene_frame") + 64 * place_of_ray(look, queue, ray),
                   word_of(look, "scene_pixels"));
    else
        list_words(look, &of, colours,
                   in_list
                       + list_vector(look, queue->list, value_of(look, "LIST_COLOR")),
                   value_of(look, "LIST"));
}

/* Returns true while find_nearest runs. Its return address, levels_found, is then in
 * the link register; all later calls store other addresses there. */
static bool is_seeking(const struct pixel_look *look)
{
    return c205_descriptor_address(register_of(look, "link"))
           == value_of(look, "levels_found");
}

/* Returns true if a kernel is testing rays, and the registers of queue.s describe the
 * vectors of these rays. The kernels of pairs_vector.s test other rays. The root solver
 * uses the registers for other values. */
static bool meets_near(const struct pixel_look *look)
{
    static const char *const regions[] = { "bound",     "visible",     "call",
                                           "transform", "root_solver", "quartic" };
    const struct asm_symbol *pairs = object_symbol(look->program, "intersect_spheres");
    uint64_t pc = c205_pc(look->machine);
    const char *region = object_region(look->program, pc);
    for (size_t i = 0; i < sizeof regions / sizeof *regions; i++)
        if (strcmp(region, regions[i]) == 0)
            return false;
    return is_seeking(look)
           && !(pairs && is_between(look, pc, "intersect_spheres", "spheres_least"));
}

static void list_near(const struct pixel_look *look, const struct queue *queue,
                      size_t ray)
{
    static const char *const names[] = { "ray_index", "near_limit", "wox", "woy", "woz",
                                         "wdx",       "wdy",        "wdz", "ox",  "oy",
                                         "oz",        "dx",         "dy",  "dz",  "tin",
                                         "tout",      "w0",         "w1",  "w2",  "w3",
                                         "w4",        "w5",         "w6",  "w7",  "w8",
                                         "w9",        "w10",        "w11", NULL };
    size_t near = (size_t)c205_to_integer(register_of(look, "near"));
    c205_word place = register_of(look, "ray_index");
    if (!meets_near(look) || c205_descriptor_length(place) != near)
        return;
    for (size_t i = 0; i < near; i++) {
        const struct pixel_element of = {
            .group = PIXEL_NEAR, .list = queue->list, .lane = i, .length = near
        };
        if (c205_to_integer(word_at(look, c205_descriptor_address(place) + 64 * i))
            != (int64_t)ray)
            continue;
        for (const char *const *name = names; *name; name++) {
            c205_word vector = register_of(look, *name);
            if (c205_descriptor_length(vector) == near)
                notify(look, &of, *name, c205_descriptor_address(vector) + 64 * i);
        }
    }
}

/* Returns true if the hits of this queue have been sorted: neither the program counter
 * nor a link register is in the code before the end of the sort. */
static bool shades_hits(const struct pixel_look *look)
{
    return mode_of(look) == TRACE_VECTOR && !is_seeking(look)
           && !is_between(look, c205_pc(look->machine), "shade", "sort_done")
           && !is_between(look,
                          c205_descriptor_address(register_of(look, "link_inner")),
                          "shade", "sort_done")
           && !is_between(look,
                          c205_descriptor_address(register_of(look, "link_kernel")),
                          "shade", "sort_done");
}

static void list_hits(const struct pixel_look *look, const struct queue *queue,
                      size_t ray)
{
    static const char *const names[] = { "at",  "px",     "py",    "pz",   "hdx", "hdy",
                                         "hdz", "nx",     "ny",    "nz",   "cr",  "cg",
                                         "cb",  "red",    "green", "blue", "lx",  "ly",
                                         "lz",  "facing", NULL };
    uint64_t store = value_of(look, "shade_store");
    size_t hits = (size_t)c205_to_integer(register_of(look, "h"));
    if (!shades_hits(look))
        return;
    for (size_t i = 0; i < hits; i++) {
        const struct pixel_element of = {
            .group = PIXEL_HITS, .list = queue->list, .lane = i, .length = hits
        };
        if (c205_to_integer(word_at(look, store + 64 * i)) == (int64_t)ray)
            list_words(look, &of, names, store + 64 * i, value_of(look, "QUEUE"));
    }
}

/* Returns true if the scalar form is tracing this pixel and has computed its camera
 * ray. `pixel` is the address of the column and the row of the current pixel. */
static bool is_pixel_at_hand(const struct pixel_look *look)
{
    uint64_t at = value_of(look, "pixel");
    return word_at(look, at) == c205_from_double((double)look->pixel->x)
           && word_at(look, at + 64) == c205_from_double((double)look->pixel->y)
           && !is_between(look, c205_pc(look->machine), "frame_pixel", "frame_aimed");
}

static size_t list_pixel(const struct pixel_look *look)
{
    static const char *const ray[] = { "ox", "oy", "oz", "dx", "dy", "dz", NULL };
    static const char *const sample[] = {
        "red", "green", "blue", "nx", "ny", "nz", NULL
    };
    const struct pixel_element of = { .length = 1 };
    uint64_t record = word_of(look, "scene_levels");
    if (!is_pixel_at_hand(look))
        return 0;
    list_words(look, &of, ray, record + 64 * value_of(look, "L_RAY"), 1);
    list_words(look, &of, sample, record + 64 * value_of(look, "L_SAMPLE"), 1);
    return 1;
}

size_t pixel_elements(const struct frame_pixel *pixel, const c205 *machine,
                      pixel_listener *listener, void *context)
{
    struct pixel_look look = look_at(pixel, machine);
    struct queue queue;
    size_t count = 0;
    look.listener = listener;
    look.context = context;
    if (mode_of(&look) == TRACE_SCALAR)
        return list_pixel(&look);
    if (!find_queue(&look, &queue))
        return 0;
    for (size_t ray = 0; ray < queue.count; ray++) {
        if (!is_of_pixel(&look, &queue, ray))
            continue;
        list_queue(&look, &queue, ray);
        list_near(&look, &queue, ray);
        list_hits(&look, &queue, ray);
        count++;
    }
    return count;
}

/* ---- Generated queues -------------------------------------------------------- */

const char *pixel_made_label(const struct frame_pixel *pixel)
{
    return trace_how(pixel->trace)->mode == TRACE_SCALAR ? "trace" : "find_nearest";
}

static void ignore(void *context, const struct pixel_element *element)
{
    (void)context;
    (void)element;
}

bool pixel_is_in_queue(const struct frame_pixel *pixel, const c205 *machine)
{
    return pixel_elements(pixel, machine, ignore, NULL) > 0;
}

bool pixel_is_made(const struct frame_pixel *pixel, const c205 *machine)
{
    struct pixel_look look = look_at(pixel, machine);
    return c205_pc(machine) == value_of(&look, pixel_made_label(pixel))
           && pixel_is_in_queue(pixel, machine);
}
