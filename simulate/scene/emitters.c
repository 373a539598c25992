/* emitters.c - concentrated emitters: what sides of what parts they are, and directions
 * to them. See light_parts.h.
 *
 * Plane ones are sampled as openings are (sample_polygon.h), spheres by the cone of
 * directions that they fill, distant ones by theirs, cones and rings by area.
 */
#include <math.h>
#include <stdlib.h>

#include "simulate/scene/light_parts.h"
#include "simulate/sampling/lobe.h"
#include "simulate/scene/round.h"
#include "simulate/scene/triangles.h"

/* Edges whose lengths and right angles differ by less than this share. */
static const double SAME_SHAPE = 1e-6;

/* ---- made ---- */

static enum pp_status append(struct pp_light_scene *scene,
                             const struct pp_emitter *emitter, struct pp_error *err)
{
    int count = scene->emitter_count;
    if ((count & (count + 1)) == 0) { /* 0, 1, 3, 7, ...: full */
        void *grown =
            realloc(scene->emitters, ((size_t)count * 2 + 1) * sizeof *scene->emitters);
        if (!grown)
            return pp_fail_memory(err);
        scene->emitters = grown;
    }
    scene->emitters[scene->emitter_count++] = *emitter;
    return PP_OK;
}

static bool is_rectangle(const struct pp_vec3 *corners, int count)
{
    if (count != 4)
        return false;
    struct pp_vec3 along = pp_vec_sub(corners[1], corners[0]);
    struct pp_vec3 up = pp_vec_sub(corners[3], corners[0]);
    struct pp_vec3 far = pp_vec_sub(corners[2], pp_vec_add(corners[1], up));
    double size = pp_vec_length(along) + pp_vec_length(up);
    return fabs(pp_vec_dot(along, up))
               < SAME_SHAPE * pp_vec_length(along) * pp_vec_length(up)
           && pp_vec_length(far) < SAME_SHAPE * size;
}

static void make_target(struct pp_target *target, const struct pp_vec3 *corners,
                        int count, struct pp_vec3 normal)
{
    *target =
        (struct pp_target){.normal = normal, .rectangle = is_rectangle(corners, count)};
    if (!target->rectangle)
        return;
    struct pp_vec3 along = pp_vec_sub(corners[1], corners[0]);
    struct pp_vec3 up = pp_vec_sub(corners[3], corners[0]);
    target->width_m = pp_vec_length(along);
    target->height_m = pp_vec_length(up);
    target->corner = corners[0];
    target->along = pp_vec_scale(along, 1.0 / target->width_m);
    target->up = pp_vec_scale(up, 1.0 / target->height_m);
}

/* Keeps the triangles; area and middle from them. */
static enum pp_status keep_triangles(struct pp_light_scene *scene,
                                     struct pp_emitter *emitter,
                                     const struct pp_vec3 (*triangles)[3], int count,
                                     struct pp_error *err)
{
    int all = scene->emitter_triangle_count + count;
    if (all > scene->emitter_triangle_space) {
        void *grown = realloc(scene->emitter_triangles,
                              2 * (size_t)all * sizeof *scene->emitter_triangles);
        if (!grown)
            return pp_fail_memory(err);
        scene->emitter_triangles = grown;
        scene->emitter_triangle_space = 2 * all;
    }
    emitter->first_triangle = scene->emitter_triangle_count;
    emitter->triangle_count = count;
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    for (int i = 0; i < count; i++) {
        struct pp_vec3 *copy =
            scene->emitter_triangles[scene->emitter_triangle_count++];
        for (int k = 0; k < 3; k++)
            copy[k] = triangles[i][k];
        double area = pp_triangles_area(copy);
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
            emitter.area_m2 = pp_round_area(&emitter.round);
            emitter.middle = middle_of_round(&emitter.round);
        } else {
            make_target(&emitter.target, corners, count,
                        side ? pp_vec_scale(part->normal, -1.0) : part->normal);
            status = keep_triangles(scene, &emitter, triangles, triangle_count, err);
        }
        part->emitter[side] = scene->emitter_count;
        if (status == PP_OK)
            status = append(scene, &emitter, err);
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
        status = append(scene, &emitter, err);
    }
    scene->distants[scene->distant_count++] = distant;
    return status;
}

/* ---- aimed at ---- */

/* Directions in a cone about the axis, uniform in solid angle; fall: 1 - cos of its
 * half angle, which loses no digits where that is small. */
static struct pp_vec3 in_cone(struct pp_vec3 axis, double fall, double u, double v)
{
    fall *= u;
    double sine_cone = sqrt(fmax(0.0, fall * (2.0 - fall)));
    struct pp_vec3 a, b;
    double sine, cosine;
    pp_lobe_frame(axis, &a, &b);
    sincos(2.0 * PP_PI * v, &sine, &cosine);
    return pp_vec_along(
        pp_vec_along(pp_vec_scale(axis, 1.0 - fall), sine_cone * cosine, a),
        sine_cone * sine, b);
}

/* Is any direction of the cone before the plane with normal n? */
static bool cone_before(struct pp_vec3 axis, double fall, struct pp_vec3 n)
{
    double facing = pp_vec_dot(axis, n);
    return facing > 0.0 || fall >= 1.0 || facing > -sqrt(fall * (2.0 - fall));
}

static bool aim_at_sphere(struct pp_emitter_sampler *aim, struct pp_vec3 n)
{
    const struct pp_shape *sphere = &aim->emitter->round;
    struct pp_vec3 to = pp_vec_sub(sphere->is.sphere.centre, aim->from);
    double r = sphere->is.sphere.radius_m, d = pp_vec_length(to);
    bool emits_outside = sphere->inward == aim->emitter->back;
    if (emits_outside != (d > r))
        return false;
    aim->axis = d > 0.0 ? pp_vec_scale(to, 1.0 / d) : pp_vec(0.0, 0.0, 1.0);
    double sine2 = r / d * (r / d);
    aim->fall = d > r ? sine2 / (1.0 + sqrt(1.0 - sine2)) : 2.0;
    return cone_before(aim->axis, aim->fall, n);
}

bool pp_emitters_sampler_init(struct pp_emitter_sampler *aim,
                              const struct pp_light_scene *scene,
                              const struct pp_emitter *emitter, struct pp_vec3 from,
                              struct pp_vec3 n)
{
    aim->emitter = emitter;
    aim->from = from;
    switch (emitter->shape) {
    case PP_EMITTER_PLANE:
        if (!pp_sample_polygon_in_sight(&emitter->target, from, n))
            return false;
        pp_sample_polygon_init(&aim->plane, &emitter->target, from, n,
                               (struct pp_brightness){.even = true});
        return true;
    case PP_EMITTER_SPHERE:
        return aim_at_sphere(aim, n);
    case PP_EMITTER_DISTANT:
        aim->axis = scene->distants[emitter->distant].direction;
        aim->fall = scene->distants[emitter->distant].solid / (2.0 * PP_PI);
        return cone_before(aim->axis, aim->fall, n);
    default:
        return true;
    }
}

static bool sample_by_area(const struct pp_emitter_sampler *aim, double u, double v,
                           struct pp_direction_sample *aimed)
{
    const struct pp_emitter *emitter = aim->emitter;
    aimed->point = pp_round_point(&emitter->round, u, v);
    struct pp_vec3 to = pp_vec_sub(aimed->point, aim->from);
    double square = pp_vec_dot(to, to);
    aimed->distance_m = sqrt(square);
    aimed->direction = pp_vec_scale(to, 1.0 / aimed->distance_m);
    struct pp_vec3 normal = pp_round_normal(&emitter->round, aimed->point);
    double facing =
        -pp_vec_dot(normal, aimed->direction) * (emitter->back ? -1.0 : 1.0);
    aimed->per_density = emitter->area_m2 * facing / square;
    return facing > 0.0;
}

bool pp_emitters_sample(const struct pp_emitter_sampler *aim, double u, double v,
                        struct pp_direction_sample *aimed)
{
    switch (aim->emitter->shape) {
    case PP_EMITTER_PLANE:
        *aimed = pp_sample_polygon_draw(&aim->plane, u, v);
        return true;
    case PP_EMITTER_ROUND:
        return sample_by_area(aim, u, v, aimed);
    default:
        break;
    }
    aimed->direction = in_cone(aim->axis, aim->fall, u, v);
    aimed->per_density = 2.0 * PP_PI * aim->fall;
    aimed->distance_m = INFINITY;
    if (aim->emitter->shape == PP_EMITTER_SPHERE
        && !pp_round_meet(&aim->emitter->round, aim->from, aimed->direction, 1e-9,
                          INFINITY, &aimed->distance_m))
        return false; /* its very rim */
    return true;
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

uint32_t pp_emitters_direction_count(double spread, double size, int most)
{
    uint32_t count = 1;
    if (!(size > 0.0))
        return count;
    double wanted = spread / size * (spread / size);
    while ((double)count < wanted && 2 * count <= (uint32_t)most)
        count *= 2;
    return count;
}
