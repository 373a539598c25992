/* convex_room.c - the planes of an empty convex room, and the panes in or behind each
 * plane. */
#include "simulate/scene/convex_room.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "simulate/scene/light_scene_parts.h"

/* Points that are at most this far behind a plane still count as in the room. */
static const double IN_PLANE_M = 1e-9;

/* Greatest distance behind a plane at which a ray may start; in a corner, such a
 * distance is only a rounding error. */
static const double BEHIND_M = 1e-5;

/* Two faces lie in one plane, or in planes that rounding might confuse, if the scalar
 * product of their normals is above this value. */
static const double SAME_NORMAL = 1.0 - 1e-6;

struct convex_plane {
    struct pp_vec3 normal; /* into the room */
    double offset_m;       /* normal . x for all points x of the plane */
    int part;
    int first, count; /* range of the plane's panes in the list */
    bool niches;      /* true if one of the panes has a reveal */
};

struct pp_convex_room {
    struct convex_plane *planes;
    int plane_count;
    int *panes;            /* by plane */
    struct pp_vec3 middle; /* mean of all vertices, from which the whole room is
                            * visible */
};

bool pp_convex_room_is(const struct pp_world *world)
{
    for (int i = world->face_count; i < world->surface_count; i++)
        if (world->surfaces[i].inside && world->surfaces[i].role != PP_REVEAL)
            return false;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->face_count; k++)
            if (!pp_polygon_is_before(&world->surfaces[k].outline,
                                      &world->surfaces[i].outline))
                return false;
    return world->face_count > 0;
}

/* The mouth of an opening's niche: its outline in the face, in front of the pane. */
static struct pp_target mouth_of(const struct pp_pane *pane)
{
    struct pp_target mouth = pane->target;
    double depth_m = pane->opening->reveal_m;
    mouth.corner = pp_vec_along(mouth.corner, depth_m, mouth.normal);
    mouth.middle = pp_vec_along(mouth.middle, depth_m, mouth.normal);
    return mouth;
}

void pp_convex_room_find_niches(struct pp_light_scene *scene)
{
    const struct pp_world *world = scene->world;
    for (int i = world->face_count; i < world->surface_count; i++) {
        const struct pp_surface *side = &world->surfaces[i];
        if (side->role != PP_REVEAL || !world->openings[side->owner].rectangle)
            continue;
        struct pp_pane *pane = &scene->panes[side->owner];
        double x = pp_vec_dot(side->outline.normal, pane->target.along);
        double y = pp_vec_dot(side->outline.normal, pane->target.up);
        pane->sides[x > 0.5 ? 0 : x < -0.5 ? 1 : y > 0.5 ? 2 : 3] = i;
        pane->mouth = mouth_of(pane);
        scene->parts[i].niche = side->owner;
    }
}

static bool has_plane_twice(const struct pp_world *world)
{
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < i; k++)
            if (pp_vec_dot(world->surfaces[i].outline.normal,
                           world->surfaces[k].outline.normal)
                > SAME_NORMAL)
                return true;
    return false;
}

static struct pp_vec3 scene_middle(const struct pp_light_scene *scene)
{
    const struct pp_world *world = scene->world;
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    int count = 0;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++, count++)
            sum = pp_vec_add(sum, world->surfaces[i].outline.vertices[k]);
    return pp_vec_sub(pp_vec_scale(sum, 1.0 / count), scene->centre);
}

enum pp_status pp_convex_room_create(struct pp_convex_room **result,
                                     const struct pp_light_scene *scene,
                                     struct pp_error *err)
{
    const struct pp_world *world = scene->world;
    *result = NULL;
    if (!pp_convex_room_is(world) || has_plane_twice(world))
        return PP_OK;
    struct pp_convex_room *room = calloc(1, sizeof *room);
    if (!room)
        return pp_fail_memory(err);
    room->plane_count = world->face_count;
    room->middle = scene_middle(scene);
    room->planes = calloc((size_t)world->face_count, sizeof *room->planes);
    room->panes = calloc((size_t)scene->pane_count + 1, sizeof *room->panes);
    if (!room->planes || !room->panes) {
        pp_convex_room_destroy(room);
        return pp_fail_memory(err);
    }
    int listed = 0;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_light_part *part = &scene->parts[i];
        struct convex_plane *plane = &room->planes[i];
        *plane = (struct convex_plane){.normal = part->normal,
                                       .offset_m = part->offset_m,
                                       .part = i,
                                       .first = listed};
        for (int k = 0; k < scene->pane_count; k++)
            if (world->openings[k].face == i) {
                room->panes[listed++] = k;
                plane->count++;
                plane->niches |= world->openings[k].reveal_m > 0.0;
            }
    }
    *result = room;
    return PP_OK;
}

void pp_convex_room_destroy(struct pp_convex_room *room)
{
    if (!room)
        return;
    free(room->planes);
    free(room->panes);
    free(room);
}

bool pp_convex_room_encloses(const struct pp_convex_room *room, struct pp_vec3 point)
{
    for (int i = 0; i < room->plane_count; i++) {
        const struct convex_plane *plane = &room->planes[i];
        if (pp_vec_dot(plane->normal, point) - plane->offset_m < -IN_PLANE_M)
            return false;
    }
    return true;
}

struct pp_light_ray pp_convex_room_sight(const struct pp_convex_room *room,
                                         struct pp_vec3 point)
{
    struct pp_vec3 to = pp_vec_sub(point, room->middle);
    return (struct pp_light_ray){.from = room->middle,
                                 .to = pp_vec_scale(to, 1.0 / pp_vec_length(to)),
                                 .space = PP_INDOORS};
}

static bool in_triangle(const struct pp_vec3 t[3], struct pp_vec3 normal,
                        struct pp_vec3 point)
{
    for (int k = 0; k < 3; k++) {
        struct pp_vec3 edge = pp_vec_sub(t[(k + 1) % 3], t[k]);
        if (pp_vec_dot(normal, pp_vec_cross(edge, pp_vec_sub(point, t[k]))) < 0.0)
            return false;
    }
    return true;
}

/* True if the point is in the target, or on the normal through a point of the
 * target. */
static bool in_target(const struct pp_target *target, struct pp_vec3 point)
{
    if (target->rectangle) {
        struct pp_vec3 in = pp_vec_sub(point, target->corner);
        double x = pp_vec_dot(in, target->along), y = pp_vec_dot(in, target->up);
        return x > 0.0 && x < target->width_m && y > 0.0 && y < target->height_m;
    }
    for (int i = 0; i < target->triangle_count; i++) {
        const struct pp_vec3 *t = target->triangles[i];
        struct pp_vec3 normal =
            pp_vec_cross(pp_vec_sub(t[1], t[0]), pp_vec_sub(t[2], t[0]));
        if (in_triangle(t, normal, point))
            return true;
    }
    return false;
}

/* Sets nearest->plane to -1 if that plane has niches and the ray starts close to it or
 * behind it, since the ray may start near the mouth of a niche. Negative distances
 * become 0. */
static void settle_nearest_plane(struct pp_convex_nearest *nearest,
                                 const struct pp_convex_room *room, double from_m)
{
    if (nearest->plane >= 0 && room->planes[nearest->plane].niches && from_m < BEHIND_M)
        nearest->plane = -1;
    if (!(nearest->distance_m > 0.0))
        nearest->distance_m = 0.0;
}

static struct pp_convex_nearest nearest_plane(const struct pp_convex_room *room,
                                              const struct pp_light_ray *ray)
{
    struct pp_convex_nearest nearest = {-1, INFINITY};
    double from_m = 0.0;
    for (int i = 0; i < room->plane_count; i++) {
        const struct convex_plane *plane = &room->planes[i];
        double towards = -pp_vec_dot(plane->normal, ray->to);
        double before = pp_vec_dot(plane->normal, ray->from) - plane->offset_m;
        if (before < -BEHIND_M)
            return (struct pp_convex_nearest){-1, 0.0};
        /* before / towards < the least, which is infinite at first */
        if (towards > 0.0
            && (nearest.plane < 0 || before < nearest.distance_m * towards)) {
            nearest = (struct pp_convex_nearest){i, before / towards};
            from_m = before;
        }
    }
    settle_nearest_plane(&nearest, room, from_m);
    return nearest;
}

/* Vectorised nearest_plane for PP_LANES rays from one point; false if the point is
 * outside. */
PP_LANES_BODY bool nearest_of_lanes(const struct pp_convex_room *room,
                                    struct pp_vec3 from, const double *to_x,
                                    const double *to_y, const double *to_z,
                                    struct pp_convex_nearest nearest[])
{
    pp_lanes x, y, z, least = PP_LANES_ALL(INFINITY), from_m = PP_LANES_ALL(0.0);
    pp_lanes_mask plane_of = {-1, -1, -1, -1}; /* none */
    memcpy(&x, to_x, sizeof x);
    memcpy(&y, to_y, sizeof y);
    memcpy(&z, to_z, sizeof z);
    for (int i = 0; i < room->plane_count; i++) {
        const struct convex_plane *plane = &room->planes[i];
        pp_lanes towards =
            -(plane->normal.x * x + plane->normal.y * y + plane->normal.z * z);
        double before = pp_vec_dot(plane->normal, from) - plane->offset_m;
        if (before < -BEHIND_M)
            return false;
        /* Infinity times a positive number exceeds `before`; lanes with towards <= 0
         * are masked. */
        pp_lanes_mask nearer = (towards > 0.0) & (before < least * towards);
        least = PP_LANES_CHOOSE(nearer, before / towards, least);
        from_m = PP_LANES_CHOOSE(nearer, PP_LANES_ALL(before), from_m);
        plane_of = (nearer & i) | (~nearer & plane_of);
    }
    for (int lane = 0; lane < PP_LANES; lane++) {
        nearest[lane] = (struct pp_convex_nearest){(int)plane_of[lane], least[lane]};
        settle_nearest_plane(&nearest[lane], room, from_m[lane]);
    }
    return true;
}

PP_LANES_BODY bool nearest_of_run(const struct pp_convex_room *room,
                                  struct pp_vec3 from,
                                  const struct pp_lanes_directions *to, int count,
                                  struct pp_convex_nearest nearest[])
{
    for (int at = 0; at < count; at += PP_LANES)
        if (!nearest_of_lanes(room, from, to->x + at, to->y + at, to->z + at,
                              nearest + at))
            return false;
    return true;
}

static bool nearest_plain(const struct pp_convex_room *room, struct pp_vec3 from,
                          const struct pp_lanes_directions *to, int count,
                          struct pp_convex_nearest nearest[])
{
    return nearest_of_run(room, from, to, count, nearest);
}

PP_LANES_WIDE static bool nearest_wide(const struct pp_convex_room *room,
                                       struct pp_vec3 from,
                                       const struct pp_lanes_directions *to, int count,
                                       struct pp_convex_nearest nearest[])
{
    return nearest_of_run(room, from, to, count, nearest);
}

bool pp_convex_room_nearest(const struct pp_convex_room *room, struct pp_vec3 from,
                            const struct pp_lanes_directions *to, int count,
                            struct pp_convex_nearest nearest[PP_RUN_MOST])
{
    return (pp_lanes_are_wide() ? nearest_wide : nearest_plain)(room, from, to, count,
                                                                nearest);
}

/* Distance along a ray at which a coordinate x that changes by `step` per metre reaches
 * 0 or `width`. *high: true if it reaches `width`. */
static double to_side(double x, double width, double step, bool *high)
{
    *high = step > 0.0;
    return step == 0.0 ? INFINITY : (*high ? width - x : -x) / step;
}

int pp_convex_room_behind_mouth(const struct pp_pane *pane, struct pp_vec3 at,
                                struct pp_vec3 to, double *further_m)
{
    const struct pp_target *mouth = &pane->mouth;
    struct pp_vec3 in = pp_vec_sub(at, mouth->corner);
    bool right, top;
    double x_m = to_side(pp_vec_dot(in, mouth->along), mouth->width_m,
                         pp_vec_dot(to, mouth->along), &right);
    double y_m = to_side(pp_vec_dot(in, mouth->up), mouth->height_m,
                         pp_vec_dot(to, mouth->up), &top);
    double pane_m = pane->opening->reveal_m / -pp_vec_dot(mouth->normal, to);
    *further_m = pane_m;
    if (pane_m < x_m && pane_m < y_m)
        return pane->part;
    *further_m = fmax(0.0, fmin(x_m, y_m));
    return x_m < y_m ? pane->sides[right] : pane->sides[2 + top];
}

/* Moves a point onto its plane, to remove rounding errors. */
static struct pp_vec3 on_plane(struct pp_vec3 normal, double offset_m,
                               struct pp_vec3 point)
{
    return pp_vec_along(point, offset_m - pp_vec_dot(normal, point), normal);
}

/* The part that a ray meets beyond a point of a niche's mouth; moves *point to the
 * hit. */
static int go_in(const struct pp_light_scene *scene, const struct pp_pane *pane,
                 struct pp_vec3 to, double *distance_m, struct pp_vec3 *point)
{
    double further_m;
    int met = pp_convex_room_behind_mouth(pane, *point, to, &further_m);
    const struct pp_light_part *part = &scene->parts[met];
    *distance_m += further_m;
    *point =
        on_plane(part->normal, part->offset_m, pp_vec_along(*point, further_m, to));
    return met;
}

int pp_convex_room_meet(const struct pp_convex_room *room,
                        const struct pp_light_scene *scene,
                        const struct pp_light_ray *ray,
                        const struct pp_convex_nearest *known, double *distance_m,
                        struct pp_vec3 *point)
{
    struct pp_convex_nearest nearest = known ? *known : nearest_plane(room, ray);
    if (nearest.plane < 0)
        return -1;
    const struct convex_plane *plane = &room->planes[nearest.plane];
    *distance_m = nearest.distance_m;
    *point = on_plane(plane->normal, plane->offset_m,
                      pp_vec_along(ray->from, *distance_m, ray->to));
    for (int i = plane->first; i < plane->first + plane->count; i++) {
        const struct pp_pane *pane = &scene->panes[room->panes[i]];
        if (!in_target(&pane->target, *point))
            continue;
        if (!(pane->opening->reveal_m > 0.0))
            return pane->part;
        return pp_convex_room_has_niche(pane)
                   ? go_in(scene, pane, ray->to, distance_m, point)
                   : -1;
    }
    return plane->part;
}
