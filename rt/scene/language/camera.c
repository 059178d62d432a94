/* camera.c - parses cameras as POV-Ray 3.5 and later do.
 *
 * The words may be in any order. After all words have been read, the parser applies
 * angle, look_at and the transforms, in this order.
 */
#include "rt/scene/elementary.h"
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/scene_statement.h"
#include "rt/scene/vector3.h"

#include <string.h>

#define NEAR 1e-10 /* POV-Ray's tolerance for `sky` */

/* POV-Ray's default for right is 1.33 x, not 4/3 x. */
const struct camera_setting camera_default = {
    { { 0, 0, 0 }, { 0, 0, 1 }, { 1.33, 0, 0 }, { 0, 1, 0 }, false, 0, 0, 0 },
    { 0, 1, 0 },
    false
};

struct camera_reading {
    struct camera_setting setting; /* first member: a named camera replaces it */
    double angle;                  /* in degrees; 0: not specified */
    double look_at[3];
    bool looks;
    bool spans; /* right or up is specified */
    double focal_point[3];
    bool focuses;
    struct placement placement;
};

/* Reads a vector. Records whether it is one of look_at, focal_point, right and up,
 * which are used later. */
static bool read_vector_of(struct reader *reader, const struct item *item)
{
    struct camera_reading *reading = item->subject;
    const struct camera *camera = &reading->setting.camera;
    const double *vector = item_member(item);
    reading->looks |= vector == reading->look_at;
    reading->focuses |= vector == reading->focal_point;
    reading->spans |= vector == camera->right || vector == camera->up;
    return item_vector(reader, item);
}

static bool read_angle(struct reader *reader, const struct item *item)
{
    const double *angle = item_member(item);
    return item_number(reader, item)
           && ((*angle >= 0 && *angle < 180)
               || reader_fault(reader, &item->at,
                               "the angle must be at least 0 and below 180 degrees"));
}

/* Reads the keyword `perspective` or `orthographic`. keyword->detail is true for
 * `orthographic`. */
static bool read_kind(struct reader *reader, const struct item *item)
{
    struct camera_reading *reading = item->subject;
    (void)reader;
    reading->setting.camera.orthographic = item->keyword->detail;
    return true;
}

/* Sets the radius of the lens to a quarter of the aperture. Measurements show that
 * POV-Ray's rays start at most at this distance from the location. */
static bool read_aperture(struct reader *reader, const struct item *item)
{
    struct camera_reading *reading = item->subject;
    double aperture;
    if (!read_number(reader, &aperture))
        return false;
    reading->setting.camera.lens_radius = fabs(aperture) / 4;
    return true;
}

static bool read_lens_points(struct reader *reader, const struct item *item)
{
    struct camera_reading *reading = item->subject;
    double points;
    if (!read_number(reader, &points))
        return false;
    if (points < 1)
        return reader_fault(reader, &item->at, "'blur_samples' must be at least 1");
    if (points > MAX_LENS_POINTS)
        reader_report(reader, &item->at, "'blur_samples' is limited to %d",
                      MAX_LENS_POINTS);
    reading->setting.camera.lens_points = (int)fmin(points, MAX_LENS_POINTS);
    return true;
}

static void move(void *subject, const struct placement *step)
{
    struct camera_reading *reading = subject;
    reading->placement = placement_then(&reading->placement, step);
}

#define OF(member) offsetof(struct camera_reading, member)

static const struct keyword words[] = {
    { "location", item_vector, OF(setting.camera.location) },
    { "direction", item_vector, OF(setting.camera.direction) },
    { "right", read_vector_of, OF(setting.camera.right) },
    { "up", read_vector_of, OF(setting.camera.up) },
    { "sky", item_vector, OF(setting.sky) },
    { "look_at", read_vector_of, OF(look_at) },
    { "focal_point", read_vector_of, OF(focal_point) },
    { "angle", read_angle, OF(angle) },
    { "perspective", read_kind, false },
    { "orthographic", read_kind, true },
    { "aperture", read_aperture, 0 },
    { "blur_samples", read_lens_points, 0 },
    /* The thresholds at which POV-Ray stops adding random rays have no effect here. */
    { "confidence variance", item_ignored, 0 },
    { "bokeh normal", item_left_out, 0 },
    { "cylinder fisheye mesh_camera omnimax panoramic spherical ultra_wide_angle",
      item_unsupported, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "a keyword of camera",
                                        { words },
                                        .move = move };

static void set_length(double vector[3], double length)
{
    scale3(length / length3(vector), vector);
}

/* Sets the length of direction from the horizontal field of view. */
static void apply_angle(struct camera *camera, double angle)
{
    if (angle > 0)
        set_length(camera->direction,
                   length3(camera->right) / elementary_tan(angle * PI / 360) / 2);
}

/* Scales an orthographic camera so that it shows as much at look_at as a perspective
 * camera. A camera whose size is set by right or up is only scaled if it has an angle.
 * A camera that is the value of a name has already been scaled. */
static void apply_distance(struct camera_reading *reading)
{
    struct camera *camera = &reading->setting.camera;
    double ahead[3], distance;
    if (!camera->orthographic || reading->setting.spanned)
        return;
    reading->setting.spanned = true;
    if (reading->spans && reading->angle == 0)
        return;
    for (int i = 0; i < 3; i++)
        ahead[i] = reading->look_at[i] - camera->location[i];
    if (greatest3(ahead) == 0)
        return;
    distance = length3(ahead) / length3(camera->direction);
    scale3(distance, camera->right);
    scale3(distance, camera->up);
}

static double handedness(const struct camera *camera)
{
    double across[3];
    cross3(camera->up, camera->direction, across);
    return dot3(across, camera->right);
}

/* Rotates direction, right and up towards look_at. Their lengths and the handedness do
 * not change. */
static bool apply_look_at(struct reader *reader, const struct scene_token *at,
                          struct camera_reading *reading)
{
    struct camera *camera = &reading->setting.camera, before = *camera;
    double side = handedness(camera) > 0 ? 1 : -1;
    for (int i = 0; i < 3; i++)
        camera->direction[i] = reading->look_at[i] - camera->location[i];
    if (greatest3(camera->direction) == 0)
        return reader_fault(reader, at, "location and look_at are the same");
    set_length(camera->direction, 1);
    cross3(reading->setting.sky, camera->direction, camera->right);
    if (fabs(camera->right[0]) < NEAR && fabs(camera->right[1]) < NEAR
        && fabs(camera->right[2]) < NEAR) {
        reader_report(reader, at,
                      "the camera looks along its sky vector; right is unchanged");
        memcpy(camera->right, before.right, sizeof camera->right);
    }
    set_length(camera->right, 1);
    cross3(camera->direction, camera->right, camera->up);
    scale3(length3(before.direction), camera->direction);
    scale3(side * length3(before.right), camera->right);
    scale3(length3(before.up), camera->up);
    return true;
}

/* Sets the distance of the plane that is in focus to the distance of the focal point,
 * even if this point is not in front of the camera. As measured in POV-Ray, the
 * distance is computed before the transforms. */
static void apply_focal_point(struct reader *reader, const struct scene_token *at,
                              struct camera_reading *reading)
{
    struct camera *camera = &reading->setting.camera;
    double to_it[3];
    if (reading->focuses) {
        subtract3(reading->focal_point, camera->location, to_it);
        camera->focal_distance = length3(to_it);
    }
    if (camera->lens_radius > 0 && camera->lens_points > 0
        && camera->focal_distance == 0) {
        reader_report(reader, at,
                      "focal blur requires a focal_point away from the "
                      "location and is ignored");
        camera->lens_radius = 0;
    }
}

static void apply_placement(struct camera *camera, const struct transform *transform)
{
    transform_point(transform, camera->location);
    transform_direction(transform, camera->direction);
    transform_direction(transform, camera->right);
    transform_direction(transform, camera->up);
}

/* Returns true if the vectors of a camera are finite and its picture has an area. */
static bool is_sound(const struct camera *camera)
{
    double volume = handedness(camera);
    return isfinite(volume) && volume != 0
           && isfinite(dot3(camera->location, camera->location))
           && isfinite(camera->focal_distance) && isfinite(camera->lens_radius);
}

bool camera_read(struct reader *reader, const struct scene_token *at,
                 struct camera_setting *setting)
{
    struct camera_reading reading = { *setting, 0,     { 0, 0, 1 }, false,
                                      false,    { 0 }, false,       placement_none };
    struct camera *camera = &reading.setting.camera;
    if (!block_read_from(reader, &grammar, VALUE_CAMERA, &reading,
                         sizeof reading.setting))
        return false;
    apply_angle(camera, reading.angle);
    if (reading.looks && !apply_look_at(reader, at, &reading))
        return false;
    apply_distance(&reading);
    apply_focal_point(reader, at, &reading);
    apply_placement(camera, &reading.placement.to_world);
    *setting = reading.setting;
    return is_sound(camera)
           || reader_fault(reader, at,
                           "direction, right and up must be finite and "
                           "linearly independent");
}
