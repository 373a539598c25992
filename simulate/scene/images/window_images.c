/* window_images.c - pairs of a polished plane and an opening, and directions to the
 * image of the opening. */
#include "simulate/scene/images/window_images.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/sampling/sample_discrete.h"
#include "simulate/scene/light_scene_parts.h"

enum { MOST_IMAGES = 32 };

/* The image is enlarged on each side by this factor times the lobe's roughness times
 * the opening's distance from the reflector, and more if it is seen obliquely. Chosen
 * by trial. */
static const double BLUR = 2.0;

/* ---- found ---- */

static double height_over(const struct pp_reflector *reflector, struct pp_vec3 point)
{
    return pp_vec_dot(reflector->frame.z, point) - reflector->offset_m;
}

enum pp_status pp_window_images_find(struct pp_light_scene *scene, struct pp_error *err)
{
    int count = 0;
    scene->window_images = calloc(MOST_IMAGES, sizeof *scene->window_images);
    if (!scene->window_images)
        return pp_fail_memory(err);
    for (int i = 0; i < scene->reflector_count; i++)
        for (int k = 0; k < scene->pane_count && count < MOST_IMAGES; k++) {
            const struct pp_reflector *reflector = &scene->reflectors[i];
            if (height_over(reflector, scene->panes[k].target.middle) > 0.0)
                scene->window_images[count++] =
                    (struct pp_window_image){i, k, reflector->share};
        }
    scene->window_image_count = count;
    return PP_OK;
}

/* ---- seen ---- */

/* The viewer's mirror image in a reflector; false if the viewer is behind it. */
static bool image_of(const struct pp_reflector *reflector,
                     const struct pp_image_viewer *viewer,
                     struct pp_image_viewer *image)
{
    double over = height_over(reflector, viewer->point);
    *image = *viewer;
    image->point = pp_vec_along(viewer->point, -2.0 * over, reflector->frame.z);
    image->normal = pp_vec_mirrored(viewer->normal, reflector->frame.z);
    return over > 0.0;
}

/* The opening, enlarged by the blur of the gloss. from: the viewer's image in the
 * reflector. */
static struct pp_target blurred(const struct pp_light_scene *scene,
                                const struct pp_window_image *image,
                                struct pp_vec3 from)
{
    const struct pp_reflector *reflector = &scene->reflectors[image->reflector];
    struct pp_target target = scene->panes[image->window].target;
    double rough = 0.0;
    if (reflector->gloss >= 0)
        rough = fmax(scene->glosses[reflector->gloss].along,
                     scene->glosses[reflector->gloss].across);
    struct pp_vec3 to = pp_vec_sub(target.middle, from);
    double distance = pp_vec_length(to), there = height_over(reflector, target.middle),
           facing = -pp_vec_dot(to, target.normal) / distance;
    double behind = distance * there / (there - height_over(reflector, from));
    double more = BLUR * rough * behind / fmax(facing, 0.3);
    target.rectangle = true;
    target.corner = pp_vec_along(pp_vec_along(target.corner, -more, target.along),
                                 -more, target.up);
    target.width_m += 2.0 * more;
    target.height_m += 2.0 * more;
    target.area_m2 = target.width_m * target.height_m;
    target.middle =
        pp_vec_along(pp_vec_along(target.corner, 0.5 * target.width_m, target.along),
                     0.5 * target.height_m, target.up);
    return target;
}

static double importance_of(const struct pp_light_scene *scene,
                            const struct pp_image_viewer *viewer, int index)
{
    const struct pp_window_image *image = &scene->window_images[index];
    struct pp_image_viewer behind;
    if (!image_of(&scene->reflectors[image->reflector], viewer, &behind))
        return 0.0;
    return image->share
           * pp_sample_polygon_importance(&scene->panes[image->window].target,
                                          behind.point, behind.normal,
                                          behind.brightness);
}

int pp_window_images_choose(const struct pp_light_scene *scene,
                            const struct pp_image_viewer *viewer, double u,
                            double *probability)
{
    double importance[MOST_IMAGES];
    for (int i = 0; i < scene->window_image_count; i++)
        importance[i] = importance_of(scene, viewer, i);
    *probability = 1.0;
    if (scene->window_image_count == 1)
        return importance[0] > 0.0 ? 0 : -1;
    return pp_sample_discrete_defensive(importance, scene->window_image_count, u,
                                        probability);
}

bool pp_window_images_sample(const struct pp_light_scene *scene, int index,
                             const struct pp_image_viewer *viewer, double u, double v,
                             struct pp_vec3 *to, double *pdf)
{
    const struct pp_window_image *image = &scene->window_images[index];
    const struct pp_reflector *reflector = &scene->reflectors[image->reflector];
    struct pp_image_viewer behind;
    struct pp_polygon_sampler sampler;
    image_of(reflector, viewer, &behind);
    struct pp_target target = blurred(scene, image, behind.point);
    pp_sample_polygon_init(&sampler, &target, behind.point, behind.normal,
                           behind.brightness);
    struct pp_direction_sample sample = pp_sample_polygon_draw(&sampler, u, v);
    if (!(sample.per_density > 0.0))
        return false;
    *to = pp_vec_mirrored(sample.direction, reflector->frame.z);
    *pdf = 1.0 / sample.per_density;
    return pp_vec_dot(*to, reflector->frame.z) < 0.0;
}

double pp_window_images_pdf(const struct pp_light_scene *scene, int reflector,
                            int window, const struct pp_image_viewer *viewer,
                            struct pp_vec3 to)
{
    double importance[MOST_IMAGES], chosen;
    int found = -1;
    for (int i = 0; i < scene->window_image_count; i++) {
        importance[i] = importance_of(scene, viewer, i);
        if (scene->window_images[i].reflector == reflector
            && scene->window_images[i].window == window)
            found = i;
    }
    if (found < 0 || !(importance[found] > 0.0))
        return 0.0;
    chosen = pp_sample_discrete_defensive_probability(importance,
                                                      scene->window_image_count, found);
    struct pp_image_viewer behind;
    struct pp_polygon_sampler sampler;
    image_of(&scene->reflectors[reflector], viewer, &behind);
    struct pp_target target =
        blurred(scene, &scene->window_images[found], behind.point);
    pp_sample_polygon_init(&sampler, &target, behind.point, behind.normal,
                           behind.brightness);
    to = pp_vec_mirrored(to, scene->reflectors[reflector].frame.z);
    double toward = -pp_vec_dot(to, target.normal);
    if (!(toward > 0.0))
        return 0.0;
    struct pp_vec3 in = pp_vec_sub(
        pp_vec_along(behind.point, sampler.distance_m / toward, to), target.corner);
    double x = pp_vec_dot(in, target.along), y = pp_vec_dot(in, target.up);
    if (x < 0.0 || x > target.width_m || y < 0.0 || y > target.height_m)
        return 0.0;
    return chosen * pp_sample_polygon_pdf(&sampler, to);
}
