/* glass_images.c - pairs of openings, the part of one opening that is mirrored in the
 * glass of the other, and directions to this part. */
#include "simulate/scene/images/glass_images.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/sampling/sample_discrete.h"
#include "simulate/scene/light_scene_parts.h"

/* An opening counts as in front of the glass, or as partly visible, only if it is so by
 * more than this distance (m). */
static const double LEAST_M = 1e-6;

/* ---- found ---- */

static const struct pp_material *pane_material(const struct pp_light_scene *scene,
                                               int pane)
{
    const struct pp_light_part *part = &scene->parts[scene->panes[pane].part];
    return &scene->materials[part->material[0]];
}

static bool mirrors(const struct pp_light_scene *scene, int pane)
{
    return pane_material(scene, pane)->kind == PP_MATERIAL_GLASS
           && scene->panes[pane].opening->glass.panes > 0;
}

/* Light exchanged by two openings that face each other, up to a constant factor and the
 * cosines. */
static double exchange(const struct pp_target *glass, const struct pp_target *window)
{
    double apart = pp_vec_length(pp_vec_sub(glass->middle, window->middle));
    return glass->area_m2 * window->area_m2 / (apart * apart);
}

/* Index of the smallest value. */
static int least_of(const double *worth, int count)
{
    int least = 0;
    for (int i = 1; i < count; i++)
        if (worth[i] < worth[least])
            least = i;
    return least;
}

enum pp_status pp_glass_images_find(struct pp_light_scene *scene, struct pp_error *err)
{
    int count = 0;
    double worth[PP_GLASS_IMAGES_MOST];
    scene->glass_images = calloc(PP_GLASS_IMAGES_MOST, sizeof *scene->glass_images);
    if (!scene->glass_images)
        return pp_fail_memory(err);
    for (int i = 0; i < scene->pane_count; i++) {
        const struct pp_target *glass = &scene->panes[i].target;
        if (!mirrors(scene, i))
            continue;
        for (int k = 0; k < scene->pane_count; k++) {
            const struct pp_target *window = &scene->panes[k].target;
            if (!(pp_target_height(glass, window->middle) > LEAST_M
                  && pp_target_height(window, glass->middle) > LEAST_M))
                continue;
            bool full = count == PP_GLASS_IMAGES_MOST;
            int place = full ? least_of(worth, count) : count++;
            double own = exchange(glass, window);
            if (full && !(own > worth[place]))
                continue;
            scene->glass_images[place] = (struct pp_glass_image){i, k};
            worth[place] = own;
        }
    }
    scene->glass_image_count = count;
    return PP_OK;
}

bool pp_glass_images_has(const struct pp_light_scene *scene, int glass, int window)
{
    for (int i = 0; i < scene->glass_image_count; i++)
        if (scene->glass_images[i].glass == glass
            && scene->glass_images[i].window == window)
            return true;
    return false;
}

/* ---- seen ---- */

/* Least reflectance of glass. Panes of the greatest possible transmittance reflect
 * nothing at normal incidence, but some light at oblique incidence. */
static const double LEAST_REFLECTANCE = 0.01;

/* Bounds of the part of the target's plane that a point sees through an outline, along
 * the target's axes from its corner. */
struct seen_box {
    double low[2], high[2];
};

static void widen(struct seen_box *box, int axis, double value)
{
    box->low[axis] = fmin(box->low[axis], value);
    box->high[axis] = fmax(box->high[axis], value);
}

/* Projects each vertex that is on the target's side of the point onto the target's
 * plane. If an edge crosses to the other side, the box is unbounded. */
static struct seen_box seen_through(const struct pp_polygon *outline,
                                    const struct pp_target *target,
                                    struct pp_vec3 centre, struct pp_vec3 from)
{
    struct seen_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    struct pp_vec3 eye = pp_vec_add(from, centre);
    struct pp_vec3 corner = pp_vec_sub(target->corner, from);
    const struct pp_vec3 axes[2] = {target->along, target->up};
    double away = -pp_vec_dot(target->normal, corner);
    struct pp_vec3 last = pp_vec_sub(outline->vertices[outline->count - 1], eye);
    double last_ahead = -pp_vec_dot(target->normal, last);
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 v = pp_vec_sub(outline->vertices[i], eye);
        double ahead = -pp_vec_dot(target->normal, v);
        for (int k = 0; k < 2; k++) {
            double x = pp_vec_dot(v, axes[k]), last_x = pp_vec_dot(last, axes[k]);
            if (ahead > 0.0)
                widen(&box, k, away / ahead * x - pp_vec_dot(corner, axes[k]));
            double crossing = last_x * ahead - x * last_ahead;
            if ((ahead > 0.0) != (last_ahead > 0.0) && crossing != 0.0)
                widen(&box, k,
                      (crossing > 0.0) == (ahead > 0.0) ? INFINITY : -INFINITY);
        }
        last = v;
        last_ahead = ahead;
    }
    return box;
}

/* Clips the target to the box; false if nothing is left. Targets other than rectangles
 * are kept whole. */
static bool cut_to(struct pp_target *target, const struct seen_box *box)
{
    double x0 = fmax(box->low[0], 0.0), x1 = fmin(box->high[0], target->width_m);
    double y0 = fmax(box->low[1], 0.0), y1 = fmin(box->high[1], target->height_m);
    if (!(x1 - x0 > LEAST_M && y1 - y0 > LEAST_M))
        return false;
    if (!target->rectangle)
        return true;
    target->corner = pp_target_point(target, x0, y0);
    target->width_m = x1 - x0;
    target->height_m = y1 - y0;
    target->area_m2 = target->width_m * target->height_m;
    target->middle =
        pp_target_point(target, 0.5 * target->width_m, 0.5 * target->height_m);
    return true;
}

/* Mirror image of the view's point in this glass. */
static struct pp_vec3 image_point(const struct pp_target *glass,
                                  const struct pp_glass_view *view)
{
    return pp_vec_along(view->point, -2.0 * pp_target_height(glass, view->point),
                        glass->normal);
}

/* The part of the opening that is visible in the glass; false if there is none. */
static bool seen_part(const struct pp_light_scene *scene,
                      const struct pp_glass_view *view, int index,
                      struct pp_target *part)
{
    const struct pp_glass_image *image = &scene->glass_images[index];
    const struct pp_target *glass = &scene->panes[image->glass].target;
    struct pp_vec3 from = image_point(glass, view);
    *part = scene->panes[image->window].target;
    if (!(pp_target_height(glass, view->point) > 0.0)
        || !(pp_target_height(part, from) > 0.0))
        return false;
    struct seen_box box = seen_through(&scene->panes[image->glass].opening->outer, part,
                                       scene->centre, from);
    return cut_to(part, &box);
}

/* Importance of the image, with the reflectance at its middle. */
static double image_importance(const struct pp_light_scene *scene,
                               const struct pp_glass_view *view,
                               const struct pp_brightness *brightness, int index)
{
    int pane = scene->glass_images[index].glass;
    const struct pp_target *glass = &scene->panes[pane].target;
    struct pp_vec3 from = image_point(glass, view);
    struct pp_target part;
    if (!seen_part(scene, view, index, &part))
        return 0.0;
    double importance = pp_sample_polygon_importance(
        &part, from, pp_vec_mirrored(view->normal, glass->normal), brightness);
    if (!(importance > 0.0))
        return 0.0;
    struct pp_vec3 to = pp_vec_unit(pp_vec_sub(part.middle, from));
    double cosine = fabs(pp_vec_dot(to, glass->normal));
    return importance
           * fmax(pp_scatter_specular_reflectance(pane_material(scene, pane), cosine).g,
                  LEAST_REFLECTANCE);
}

static void look_from(const struct pp_light_scene *scene, struct pp_glass_view *view,
                      struct pp_vec3 point, struct pp_vec3 normal,
                      const struct pp_brightness *brightness)
{
    view->point = point;
    view->normal = normal;
    for (int i = 0; i < PP_GLASS_SIGHTS; i++)
        view->kept[i].image = 0;
    for (int i = 0; i < scene->glass_image_count; i++)
        view->share[i] = image_importance(scene, view, brightness, i);
}

/* The view of a visible image: the stored one, or a newly calculated one. */
static struct pp_glass_sight *sight_of(const struct pp_light_scene *scene,
                                       struct pp_glass_view *view,
                                       const struct pp_brightness *brightness,
                                       int index)
{
    const struct pp_target *glass =
        &scene->panes[scene->glass_images[index].glass].target;
    struct pp_glass_sight *sight = &view->kept[index % PP_GLASS_SIGHTS];
    if (sight->image != index + 1) {
        seen_part(scene, view, index, &sight->target);
        pp_sample_polygon_init(
            &sight->sampler, &sight->target, image_point(glass, view),
            pp_vec_mirrored(view->normal, glass->normal), brightness);
    }
    sight->image = index + 1;
    sight->sampler.target = &sight->target; /* reset, since the view may have been
                                             * copied */
    return sight;
}

int pp_glass_images_sample(const struct pp_light_scene *scene,
                           struct pp_glass_view *view, struct pp_vec3 point,
                           struct pp_vec3 normal,
                           const struct pp_brightness *brightness, const double u[3],
                           struct pp_vec3 *to, double *pdf)
{
    if (!pp_vec_same(view->point, point) || !pp_vec_same(view->normal, normal))
        look_from(scene, view, point, normal, brightness);
    double probability;
    int chosen = pp_sample_discrete_defensive(view->share, scene->glass_image_count,
                                              u[2], &probability);
    if (chosen < 0)
        return chosen;
    struct pp_glass_sight *sight = sight_of(scene, view, brightness, chosen);
    struct pp_direction_sample sample =
        pp_sample_polygon_draw(&sight->sampler, u[0], u[1]);
    if (!(sample.per_density > 0.0))
        return -1;
    *to =
        pp_vec_mirrored(sample.direction,
                        scene->panes[scene->glass_images[chosen].glass].target.normal);
    *pdf = probability / sample.per_density;
    return chosen;
}
