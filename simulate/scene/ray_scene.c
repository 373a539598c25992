/* ray_scene.c - facets, panes and triangles from a world, and rays among them. */
#include "simulate/scene/ray_scene.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "model/geometry/bounds.h"
#include "simulate/sampling/choose.h"
#include "simulate/sampling/lobe.h"
#include "simulate/sampling/triangle.h"
#include "simulate/scene/triangles.h"

/* Points nearer than this to a plane lie in it. */
static const double SAME_PLANE_M = 1e-7;

/* The middle of the room's box, or of everything's where there is no room. */
static void find_centre(struct pp_ray_scene *scene, const struct pp_world *world)
{
    struct pp_bounds3 box = pp_bounds3_empty();
    int count = scene->has_room ? world->face_count : world->surface_count;
    for (int i = 0; i < count; i++) {
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        for (int k = 0; k < outline->count; k++)
            pp_bounds3_add(&box, outline->vertices[k]);
    }
    if (count == 0)
        return;
    scene->centre = pp_vec_scale(pp_vec_add(box.low, box.high), 0.5);
    struct pp_vec3 half = pp_vec_scale(pp_vec_sub(box.high, box.low), 0.5);
    scene->size_m = fmax(half.x, fmax(half.y, half.z));
}

static struct pp_facet facet_of(const struct pp_ray_scene *scene,
                                const struct pp_polygon *outline)
{
    struct pp_facet facet = {.normal = outline->normal, .opening = -1};
    facet.offset_m =
        pp_vec_dot(outline->normal, pp_vec_sub(outline->vertices[0], scene->centre));
    pp_lobe_frame(facet.normal, &facet.a, &facet.b);
    return facet;
}

static void make_facets(struct pp_ray_scene *scene, const struct pp_world *world)
{
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        struct pp_facet facet = facet_of(scene, &surface->outline);
        facet.reflectance[PP_FRONT] = surface->front;
        facet.reflectance[PP_BACK] = surface->back;
        facet.exitance = surface->exitance;
        facet.envelope = i < world->face_count || surface->role == PP_REVEAL;
        scene->facets[i] = facet;
    }
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        const struct pp_surface *face = &world->surfaces[opening->face];
        struct pp_facet facet = facet_of(scene, &opening->outer);
        facet.reflectance[PP_FRONT] = face->front;
        facet.reflectance[PP_BACK] = face->back;
        facet.opening = i;
        scene->facets[world->surface_count + i] = facet;
    }
}

/* ---- facts of an opening that save rays ---- */

/* Does no vertex of the outline lie behind the plane through `on` with normal n? */
static bool all_before(const struct pp_polygon *outline, struct pp_vec3 on,
                       struct pp_vec3 n)
{
    for (int i = 0; i < outline->count; i++)
        if (pp_vec_dot(n, pp_vec_sub(outline->vertices[i], on)) < -SAME_PLANE_M)
            return false;
    return true;
}

static bool is_unobstructed(const struct pp_world *world,
                            const struct pp_opening *opening)
{
    struct pp_vec3 on = opening->outer.vertices[0], n = opening->outer.normal;
    for (int i = 0; i < world->surface_count; i++)
        if (!all_before(&world->surfaces[i].outline, on, n))
            return false;
    for (int i = 0; i < world->opening_count; i++)
        if (!all_before(&world->openings[i].outer, on, n))
            return false;
    return true;
}

/* Do any two points in the room see each other? */
static bool is_convex_and_empty(const struct pp_world *world)
{
    for (int i = world->face_count; i < world->surface_count; i++)
        if (world->surfaces[i].inside)
            return false; /* reveals too: from inside one, its sides hide */
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        for (int k = 0; k < world->face_count; k++)
            if (!all_before(&world->surfaces[k].outline, face->vertices[0],
                            face->normal))
                return false;
    }
    return true;
}

static void make_target(struct pp_target *target, const struct pp_opening *opening,
                        struct pp_vec3 centre)
{
    const struct pp_polygon *outer = &opening->outer;
    *target = (struct pp_target){.normal = outer->normal,
                                 .area_m2 = outer->area_m2,
                                 .rectangle = opening->rectangle,
                                 .along = opening->along,
                                 .up = opening->up,
                                 .width_m = opening->width_m,
                                 .height_m = opening->height_m};
    double right = DBL_MAX, top = DBL_MAX;
    struct pp_vec3 base = outer->vertices[0], sum = {0.0, 0.0, 0.0};
    for (int i = 0; i < outer->count; i++) {
        struct pp_vec3 v = pp_vec_sub(outer->vertices[i], base);
        right = fmin(right, pp_vec_dot(v, opening->along));
        top = fmin(top, pp_vec_dot(v, opening->up));
        sum = pp_vec_add(sum, v);
    }
    base = pp_vec_sub(base, centre);
    target->corner =
        pp_vec_along(pp_vec_along(base, right, opening->along), top, opening->up);
    target->middle = pp_vec_along(base, 1.0 / outer->count, sum);
}

static void make_panes(struct pp_ray_scene *scene, const struct pp_world *world)
{
    bool convex = world->opening_count > 0 && is_convex_and_empty(world);
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        struct pp_pane *pane = &scene->panes[i];
        pane->opening = opening;
        pane->facet = world->surface_count + i;
        pane->seen_by_all = convex;
        pane->unobstructed = is_unobstructed(world, opening);
        make_target(&pane->target, opening, scene->centre);
    }
}

static bool facet_reflects(const struct pp_ray_scene *scene,
                           const struct pp_facet *facet)
{
    return facet->reflectance[PP_FRONT] > 0.0
           || (!facet->envelope && facet->reflectance[PP_BACK] > 0.0)
           || (facet->opening >= 0
               && scene->panes[facet->opening].opening->glass.panes > 0);
}

static void sum_up(struct pp_ray_scene *scene)
{
    for (int i = 0; i < scene->facet_count; i++) {
        scene->most_exitance = fmax(scene->most_exitance, scene->facets[i].exitance);
        scene->reflects |= facet_reflects(scene, &scene->facets[i]);
    }
}

/* ---- triangles ---- */

static enum pp_status make_triangles(struct pp_ray_scene *scene,
                                     const struct pp_world *world, struct pp_error *err)
{
    struct pp_triangles list = {.facet_of = NULL};
    struct pp_clipper *clipper = NULL;
    enum pp_status status = pp_clipper_create(&clipper, err);
    for (int i = 0; status == PP_OK && i < world->surface_count; i++)
        status = pp_triangles_of_surface(&list, clipper, world, i, scene->centre, err);
    int first_glass = list.count;
    for (int i = 0; status == PP_OK && i < world->opening_count; i++)
        status = pp_triangles_of_polygon(&list, clipper, &world->openings[i].outer,
                                         world->surface_count + i, scene->centre, err);
    if (status == PP_OK)
        status = pp_triangles_of_plane(&scene->plane, &scene->plane_count, clipper,
                                       world, scene->centre, err);
    pp_clipper_destroy(clipper);
    scene->triangles = list.corners;
    scene->facet_of_triangle = list.facet_of;
    scene->triangle_count = list.count;
    if (status != PP_OK)
        return status;

    for (int i = first_glass; i < list.count; i++) {
        struct pp_target *target =
            &scene->panes[list.facet_of[i] - world->surface_count].target;
        if (!target->triangles)
            target->triangles = &list.corners[i];
        target->triangle_count++;
    }
    for (int i = 0; i < scene->plane_count; i++)
        scene->plane_area_m2 += pp_triangle_area(scene->plane[i]);
    return PP_OK;
}

static enum pp_status make_rays(struct pp_ray_scene *scene, struct pp_error *err)
{
    float(*single)[3][3] = pp_triangles_single(
        (const struct pp_vec3(*)[3])scene->triangles, scene->triangle_count);
    if (!single)
        return pp_fail_memory(err);
    enum pp_status status = pp_rays_create(&scene->rays, (const float(*)[3][3])single,
                                           scene->triangle_count, err);
    free(single);
    return status;
}

enum pp_status pp_ray_scene_create(struct pp_ray_scene **result,
                                   const struct pp_world *world, struct pp_error *err)
{
    *result = NULL;
    struct pp_ray_scene *scene = calloc(1, sizeof *scene);
    if (!scene)
        return pp_fail_memory(err);
    scene->has_room = world->face_count > 0;
    scene->decorations = world->decorations;
    scene->facet_count = world->surface_count + world->opening_count;
    scene->pane_count = world->opening_count;
    scene->facets = calloc((size_t)scene->facet_count + 1, sizeof *scene->facets);
    scene->panes = calloc((size_t)scene->pane_count + 1, sizeof *scene->panes);
    enum pp_status status = scene->facets && scene->panes ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK) {
        find_centre(scene, world);
        make_facets(scene, world);
        make_panes(scene, world);
        sum_up(scene);
        status = make_triangles(scene, world, err);
    }
    if (status == PP_OK)
        status = make_rays(scene, err);
    if (status == PP_OK)
        status = pp_environment_init(&scene->environment, world, scene->centre, err);
    if (status != PP_OK) {
        pp_ray_scene_destroy(scene);
        return status;
    }
    /* The overcast horizon is 3/7 of the mean luminance, the ground rho of it. */
    scene->brightness.ground = world->ground_reflectance * 7.0 / 3.0;
    *result = scene;
    return PP_OK;
}

void pp_ray_scene_destroy(struct pp_ray_scene *scene)
{
    if (!scene)
        return;
    pp_environment_clear(&scene->environment);
    pp_rays_destroy(scene->rays);
    free(scene->facets);
    free(scene->panes);
    free(scene->triangles);
    free(scene->facet_of_triangle);
    free(scene->plane);
    free(scene);
}

struct pp_vec3 pp_ray_scene_plane_point(const struct pp_ray_scene *scene, double u,
                                        double v)
{
    double left = u * scene->plane_area_m2;
    int i = 0;
    double area = pp_triangle_area(scene->plane[0]);
    while (left > area && i < scene->plane_count - 1) {
        left -= area;
        area = pp_triangle_area(scene->plane[++i]);
    }
    return pp_triangle_point(scene->plane[i], fmin(left / area, 1.0), v);
}

/* The point of a surface for which a pane is chosen. */
struct shading_point {
    const struct pp_ray_scene *scene;
    struct pp_vec3 point, normal;
};

static double importance_of(const void *of, int pane)
{
    const struct shading_point *shading = of;
    return pp_sample_polygon_importance(&shading->scene->panes[pane].target,
                                        shading->point, shading->normal,
                                        shading->scene->brightness);
}

int pp_ray_scene_choose_pane(const struct pp_ray_scene *scene, struct pp_vec3 point,
                             struct pp_vec3 normal, double u, double *probability)
{
    if (scene->pane_count == 1) {
        *probability = 1.0;
        return pp_sample_polygon_in_sight(&scene->panes[0].target, point, normal) ? 0
                                                                                  : -1;
    }
    struct shading_point shading = {scene, point, normal};
    return pp_choose(importance_of, &shading, scene->pane_count, u, probability);
}

struct pp_contact pp_ray_scene_first(const struct pp_ray_scene *scene, struct pp_vec3 p,
                                     struct pp_vec3 n, struct pp_vec3 u)
{
    struct pp_vec3 start = pp_rays_lift(p, n);
    float origin[3] = {(float)start.x, (float)start.y, (float)start.z};
    float direction[3] = {(float)u.x, (float)u.y, (float)u.z}, distance;
    int triangle = pp_rays_first(scene->rays, origin, direction, &distance);
    if (triangle < 0)
        return (struct pp_contact){.facet = -1};

    struct pp_contact contact = {.facet = scene->facet_of_triangle[triangle],
                                 .distance_m = distance};
    const struct pp_facet *facet = &scene->facets[contact.facet];
    contact.side = pp_vec_dot(facet->normal, u) < 0.0 ? PP_FRONT : PP_BACK;
    struct pp_vec3 near = pp_vec_along(p, contact.distance_m, u);
    contact.point = pp_vec_along(
        near, facet->offset_m - pp_vec_dot(facet->normal, near), facet->normal);
    return contact;
}
