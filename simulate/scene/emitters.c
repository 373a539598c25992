/* emitters.c - emitters gathered from the parts of a scene, and directions to them. */
#include "simulate/scene/emitters.h"

#include <math.h>

#include "model/base/array.h"
#include "simulate/sampling/triangle.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/scene/round.h"

/* Relative tolerance for opposite edges and right angles, within which a quadrilateral
 * counts as a rectangle. */
static const double SAME_SHAPE = 1e-6;

/* ---- gathered ---- */

static enum pp_status append_emitter(struct pp_light_scene *scene,
                                     const struct pp_emitter *emitter,
                                     struct pp_error *err)
{
    enum pp_status status = pp_array_append(&scene->emitters, scene->emitter_count,
                                            sizeof *scene->emitters, err);
    if (status == PP_OK)
        scene->emitters[scene->emitter_count++] = *emitter;
    return status;
}

static void make_target(struct pp_target *target, const struct pp_vec3 *corners,
                        int count, struct pp_vec3 normal)
{
    *target = (struct pp_target){.normal = normal};
    if (count != 4)
        return;
    struct pp_vec3 along = pp_vec_sub(corners[1], corners[0]);
    struct pp_vec3 up = pp_vec_sub(corners[3], corners[0]);
    struct pp_vec3 far = pp_vec_sub(corners[2], pp_vec_add(corners[1], up));
    double width = pp_vec_length(along), height = pp_vec_length(up);
    target->rectangle = fabs(pp_vec_dot(along, up)) < SAME_SHAPE * width * height
                        && pp_vec_length(far) < SAME_SHAPE * (width + height);
    if (!target->rectangle)
        return;
    target->width_m = width;
    target->height_m = height;
    target->corner = corners[0];
    target->along = pp_vec_scale(along, 1.0 / width);
    target->up = pp_vec_scale(up, 1.0 / height);
}

/* Copies the triangles to the scene, and sets the emitter's area and middle from
 * them. */
static enum pp_status keep_triangles(struct pp_light_scene *scene,
                                     struct pp_emitter *emitter,
                                     const struct pp_vec3 (*triangles)[3], int count,
                                     struct pp_error *err)
{
    enum pp_status status = pp_array_reserve(
        &scene->emitter_triangles, &scene->emitter_triangle_capacity,
        scene->emitter_triangle_count + count, sizeof *scene->emitter_triangles, err);
    if (status != PP_OK)
        return status;
    emitter->first_triangle = scene->emitter_triangle_count;
    emitter->triangle_count = count;
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    for (int i = 0; i < count; i++) {
        struct pp_vec3 *copy =
            scene->emitter_triangles[scene->emitter_triangle_count++];
        for (int k = 0; k < 3; k++)
            copy[k] = triangles[i][k];
        double area = pp_triangle_area(copy);
        emitter->area_m2 += area;
        for (int k = 0; k < 3; k++)
            sum = pp_vec_along(sum, area / 3.0, copy[k]);
    }
    emitter->middle = pp_vec_scale(sum, 1.0 / emitter->area_m2);
    emitter->target.area_m2 = emitter->area_m2;
    emitter->target.middle = emitter->middle;
    return PP_OK;
}

static struct pp_vec3 middle_of_round(const struct pp_shape *round)
{
    if (round->kind == PP_SHAPE_SPHERE)
        return round->is.sphere.centre;
    if (round->kind == PP_SHAPE_RING)
        return round->is.ring.centre;
    return pp_vec_scale(pp_vec_add(round->is.cone.ends[0], round->is.cone.ends[1]),
                        0.5);
}

static bool gives_light(const struct pp_light_scene *scene,
                        const struct pp_light_part *part, int side)
{
    const struct pp_material *material = &scene->materials[part->material[side]];
    return material->emits == PP_EMITS_CONCENTRATED && (side == 0 || part->back_emits)
           && !pp_rgb_is_black(material->radiance);
}

enum pp_status pp_emitters_add_part(struct pp_light_scene *scene, int index,
                                    const struct pp_vec3 *corners, int count,
                                    const struct pp_vec3 (*triangles)[3],
                                    int triangle_count, struct pp_error *err)
{
    struct pp_light_part *part = &scene->parts[index];
    for (int side = 0; side < 2; side++) {
        if (!gives_light(scene, part, side))
            continue;
        struct pp_emitter emitter = {.part = index,
                                     .distant = -1,
                                     .material = part->material[side],
                                     .back = side == 1};
        emitter.radiance = scene->materials[emitter.material].radiance;
        enum pp_status status = PP_OK;
        if (part->round >= 0) {
            emitter.round = scene->rounds[part->round];
            emitter.shape = emitter.round.kind == PP_SHAPE_SPHERE ? PP_EMITTER_SPHERE
                                                                  : PP_EMITTER_ROUND;
            emitter.area_m2 = part->area_m2;
            emitter.middle = middle_of_round(&emitter.round);
        } else {
            make_target(&emitter.target, corners, count,
                        side ? pp_vec_scale(part->normal, -1.0) : part->normal);
            status = keep_triangles(scene, &emitter, triangles, triangle_count, err);
        }
        part->emitter[side] = scene->emitter_count;
        if (status == PP_OK)
            status = append_emitter(scene, &emitter, err);
        if (status != PP_OK)
            return status;
    }
    return PP_OK;
}

void pp_emitters_link_triangles(struct pp_light_scene *scene)
{
    for (int i = 0; i < scene->emitter_count; i++) {
        struct pp_emitter *emitter = &scene->emitters[i];
        if (emitter->shape != PP_EMITTER_PLANE)
            continue;
        emitter->target.triangles = &scene->emitter_triangles[emitter->first_triangle];
        emitter->target.triangle_count = emitter->triangle_count;
    }
}

enum pp_status pp_emitters_add_distant(struct pp_light_scene *scene,
                                       const struct pp_shape *shape,
                                       struct pp_error *err)
{
    const struct pp_material *material = &scene->materials[shape->material];
    double half = shape->is.distant.half_angle_rad;
    struct pp_distant distant = {.direction = shape->is.distant.direction,
                                 .cos_half = cos(half),
                                 .solid =
                                     4.0 * PP_PI * sin(half / 2.0) * sin(half / 2.0),
                                 .material = shape->material,
                                 .tag = shape->tag,
                                 .emitter = -1};
    if (half > PP_PI / 2.0 - 1e-9 && half < PP_PI / 2.0 + 1e-9)
        distant.cos_half = 0.0;
    enum pp_status status = PP_OK;
    if (material->emits == PP_EMITS_CONCENTRATED) {
        struct pp_emitter emitter = {.shape = PP_EMITTER_DISTANT,
                                     .part = -1,
                                     .distant = scene->distant_count,
                                     .material = shape->material,
                                     .radiance = material->radiance};
        distant.emitter = scene->emitter_count;
        status = append_emitter(scene, &emitter, err);
    }
    scene->distants[scene->distant_count++] = distant;
    return status;
}

/* ---- sampled ---- */

/* A direction in a cone about the axis, uniform in solid angle; fall: 1 - cos of its
 * half angle. */
static struct pp_vec3 in_cone(struct pp_vec3 axis, double fall, double u, double v)
{
    fall *= u;
    return pp_round_circle_point(pp_vec_scale(axis, 1.0 - fall), axis,
                                 sqrt(fmax(0.0, fall * (2.0 - fall))), v);
}

/* True if any direction of the cone is on the side of the normal n. */
static bool cone_before(struct pp_vec3 axis, double fall, struct pp_vec3 n)
{
    double facing = pp_vec_dot(axis, n);
    return facing > 0.0 || fall >= 1.0 || facing > -sqrt(fall * (2.0 - fall));
}

static bool init_sphere(struct pp_emitter_sampler *sampler, struct pp_vec3 n)
{
    const struct pp_shape *sphere = &sampler->emitter->round;
    struct pp_vec3 to = pp_vec_sub(sphere->is.sphere.centre, sampler->from);
    double r = sphere->is.sphere.radius_m, d = pp_vec_length(to);
    bool emits_outside = sphere->inward == sampler->emitter->back;
    if (emits_outside != (d > r))
        return false;
    sampler->axis = d > 0.0 ? pp_vec_scale(to, 1.0 / d) : pp_vec(0.0, 0.0, 1.0);
    double sine2 = r / d * (r / d);
    sampler->fall = d > r ? sine2 / (1.0 + sqrt(1.0 - sine2)) : 2.0;
    return cone_before(sampler->axis, sampler->fall, n);
}

bool pp_emitters_sampler_init(struct pp_emitter_sampler *sampler,
                              const struct pp_light_scene *scene,
                              const struct pp_emitter *emitter, struct pp_vec3 from,
                              struct pp_vec3 n)
{
    sampler->emitter = emitter;
    sampler->from = from;
    switch (emitter->shape) {
    case PP_EMITTER_PLANE:
        if (!pp_sample_polygon_in_sight(&emitter->target, from, n))
            return false;
        pp_sample_polygon_init(&sampler->plane, &emitter->target, from, n,
                               &(struct pp_brightness){.ground = 1.0});
        return true;
    case PP_EMITTER_SPHERE:
        return init_sphere(sampler, n);
    case PP_EMITTER_DISTANT:
        sampler->axis = scene->distants[emitter->distant].direction;
        sampler->fall = scene->distants[emitter->distant].solid / (2.0 * PP_PI);
        return cone_before(sampler->axis, sampler->fall, n);
    default:
        return true;
    }
}

/* Evaluates a round emitter at a point that was drawn by area; false if the surface
 * faces away at that point. */
static bool sample_at(const struct pp_emitter_sampler *sampler, struct pp_vec3 point,
                      struct pp_direction_sample *sample)
{
    const struct pp_emitter *emitter = sampler->emitter;
    sample->point = point;
    struct pp_vec3 to = pp_vec_sub(sample->point, sampler->from);
    double square = pp_vec_dot(to, to);
    sample->distance_m = sqrt(square);
    sample->direction = pp_vec_scale(to, 1.0 / sample->distance_m);
    struct pp_vec3 normal = pp_round_normal(&emitter->round, sample->point);
    double facing =
        -pp_vec_dot(normal, sample->direction) * (emitter->back ? -1.0 : 1.0);
    sample->per_density = emitter->area_m2 * facing / square;
    return facing > 0.0;
}

bool pp_emitters_sample(const struct pp_emitter_sampler *sampler, double u, double v,
                        struct pp_direction_sample *sample)
{
    switch (sampler->emitter->shape) {
    case PP_EMITTER_PLANE:
        *sample = pp_sample_polygon_draw(&sampler->plane, u, v);
        return true;
    case PP_EMITTER_ROUND:
        return sample_at(sampler, pp_round_point(&sampler->emitter->round, u, v),
                         sample);
    default:
        break;
    }
    sample->direction = in_cone(sampler->axis, sampler->fall, u, v);
    sample->per_density = 2.0 * PP_PI * sampler->fall;
    sample->distance_m = INFINITY;
    if (sampler->emitter->shape == PP_EMITTER_SPHERE
        && !pp_round_meet(&sampler->emitter->round, sampler->from, sample->direction,
                          1e-9, INFINITY, &sample->distance_m))
        return false; /* a grazing ray, at the rim */
    return true;
}

double pp_emitters_pdf(const struct pp_emitter_sampler *sampler,
                       struct pp_vec3 direction)
{
    const struct pp_emitter *emitter = sampler->emitter;
    struct pp_direction_sample sample;
    double distance;
    if (emitter->shape == PP_EMITTER_PLANE)
        return pp_sample_polygon_pdf(&sampler->plane, direction);
    if (emitter->shape != PP_EMITTER_ROUND)
        return 1.0 / (2.0 * PP_PI * sampler->fall);
    if (!pp_round_meet(&emitter->round, sampler->from, direction, 1e-9, INFINITY,
                       &distance)
        || !sample_at(sampler, pp_vec_along(sampler->from, distance, direction),
                      &sample))
        return 0.0;
    return 1.0 / sample.per_density;
}

double pp_emitters_angular_size(const struct pp_emitter *emitter,
                                const struct pp_light_scene *scene, struct pp_vec3 from)
{
    if (emitter->shape == PP_EMITTER_DISTANT)
        return sqrt(scene->distants[emitter->distant].solid);
    struct pp_vec3 to = pp_vec_sub(emitter->middle, from);
    return sqrt(emitter->area_m2 / pp_vec_dot(to, to));
}

double pp_emitters_importance(const struct pp_emitter *emitter,
                              const struct pp_light_scene *scene, struct pp_vec3 from,
                              struct pp_vec3 n)
{
    double light =
        pp_rgb_luminance(emitter->radiance) + 1e-3 * pp_rgb_most(emitter->radiance);
    if (emitter->shape == PP_EMITTER_DISTANT) {
        const struct pp_distant *distant = &scene->distants[emitter->distant];
        return light * distant->solid * fmax(pp_vec_dot(n, distant->direction), 0.1);
    }
    if (emitter->shape == PP_EMITTER_PLANE
        && !pp_sample_polygon_in_sight(&emitter->target, from, n))
        return 0.0;
    struct pp_vec3 to = pp_vec_sub(emitter->middle, from);
    double square = pp_vec_dot(to, to), length = sqrt(square);
    double facing = length > 0.0 ? pp_vec_dot(n, to) / length : 1.0;
    double slant = 1.0;
    if (emitter->shape == PP_EMITTER_PLANE && length > 0.0)
        slant = -pp_vec_dot(emitter->target.normal, to) / length;
    return light * emitter->area_m2 / (square + emitter->area_m2) * fmax(facing, 0.1)
           * fmax(slant, 0.05);
}
