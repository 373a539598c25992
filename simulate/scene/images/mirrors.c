/* mirrors.c - the planes of mirroring parts, and images in one or two of them. */
#include "simulate/scene/images/mirrors.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/sampling/scatter.h"
#include "simulate/scene/light_scene_parts.h"

enum {
    MOST_MIRRORS = 8,      /* most planes */
    MOST_CONNECTIONS = 256 /* most pairs of a mirror path and an emitter */
};

/* Tolerances for equal planes: 1 minus the cosine of the angle between their normals,
 * and the relative difference of their offsets. */
static const double SAME_NORMAL = 1e-12, SAME_OFFSET = 1e-7;

/* ---- found ---- */

/* A part that mirrors. */
struct candidate {
    int part;
    double share, weight; /* reflectance; reflectance times area */
};

/* The part's specular reflectance at normal incidence, on the better of its sides. */
static double specular_reflectance(const struct pp_light_scene *scene, int part)
{
    double share = 0.0;
    for (int side = 0; side < 2; side++) {
        int material = scene->parts[part].material[side];
        if (!pp_light_scene_gloss(scene, material))
            share = fmax(share, pp_rgb_most(pp_scatter_specular_reflectance(
                                    &scene->materials[material], 1.0)));
    }
    return share;
}

static int by_weight(const void *a, const void *b)
{
    const struct candidate *x = a, *y = b;
    if (x->weight != y->weight)
        return x->weight < y->weight ? 1 : -1;
    return x->part - y->part;
}

/* The plane of the part; false if the part is curved. */
static bool mirror_plane(const struct pp_light_scene *scene, int index,
                         struct pp_mirror *plane)
{
    const struct pp_light_part *part = &scene->parts[index];
    *plane = (struct pp_mirror){.normal = part->normal, .offset_m = part->offset_m};
    if (part->round < 0)
        return true;
    const struct pp_shape *round = &scene->rounds[part->round];
    if (round->kind != PP_SHAPE_RING)
        return false;
    plane->normal = round->is.ring.axis;
    plane->offset_m = pp_vec_dot(plane->normal, round->is.ring.centre);
    return true;
}

static bool same_plane(const struct pp_mirror *a, const struct pp_mirror *b)
{
    double facing = pp_vec_dot(a->normal, b->normal);
    double offset = facing < 0.0 ? -b->offset_m : b->offset_m;
    return fabs(facing) > 1.0 - SAME_NORMAL
           && fabs(offset - a->offset_m) < SAME_OFFSET * (1.0 + fabs(a->offset_m));
}

/* Index of the mirror in the part's plane. Adds the mirror if it is new. -1: the part
 * is curved, or there are too many mirrors. */
static int mirror_of(struct pp_light_scene *scene, const struct candidate *candidate)
{
    struct pp_mirror plane;
    if (!mirror_plane(scene, candidate->part, &plane))
        return -1;
    int i = 0;
    while (i < scene->mirror_count && !same_plane(&scene->mirrors[i], &plane))
        i++;
    if (i == MOST_MIRRORS)
        return -1;
    if (i == scene->mirror_count)
        scene->mirrors[scene->mirror_count++] = plane;
    struct pp_mirror *mirror = &scene->mirrors[i];
    mirror->share = fmax(mirror->share, candidate->share);
    return i;
}

static enum pp_status find_mirrors(struct pp_light_scene *scene, struct pp_error *err)
{
    struct candidate *list = malloc(((size_t)scene->part_count + 1) * sizeof *list);
    if (!list)
        return pp_fail_memory(err);
    int count = 0;
    for (int i = 0; i < scene->part_count; i++) {
        double share = specular_reflectance(scene, i);
        if (share > 0.0)
            list[count++] =
                (struct candidate){i, share, share * scene->parts[i].area_m2};
    }
    qsort(list, (size_t)count, sizeof *list, by_weight);
    for (int i = 0; i < count; i++) {
        int mirror = mirror_of(scene, &list[i]);
        scene->parts[list[i].part].mirror = mirror;
        if (mirror < 0)
            scene->unsampled_share = fmax(scene->unsampled_share, list[i].share);
    }
    free(list);
    return PP_OK;
}

/* ---- mirror paths ---- */

static void add_mirror_path(struct pp_light_scene *scene, int first, int second)
{
    double share = scene->mirrors[first].share;
    if (second >= 0)
        share *= scene->mirrors[second].share;
    scene->mirror_paths[scene->mirror_path_count++] =
        (struct pp_mirror_path){{first, second}, share};
}

static int by_share(const void *a, const void *b)
{
    const struct pp_mirror_path *x = a, *y = b;
    if (x->share != y->share)
        return x->share < y->share ? 1 : -1;
    if (x->mirrors[0] != y->mirrors[0])
        return x->mirrors[0] - y->mirrors[0];
    return x->mirrors[1] - y->mirrors[1];
}

/* Makes paths by one mirror and by two in succession, and keeps the paths with the
 * greatest products of reflectances. */
static void make_mirror_paths(struct pp_light_scene *scene)
{
    int count = scene->mirror_count, most = MOST_CONNECTIONS / scene->emitter_count;
    for (int i = 0; i < count; i++)
        for (int k = -1; k < count; k++)
            if (k != i)
                add_mirror_path(scene, i, k);
    qsort(scene->mirror_paths, (size_t)scene->mirror_path_count,
          sizeof *scene->mirror_paths, by_share);
    for (; scene->mirror_path_count > most; scene->mirror_path_count--)
        scene->unsampled_share =
            fmax(scene->unsampled_share,
                 scene->mirror_paths[scene->mirror_path_count - 1].share);
}

/* The greatest product of three successive reflectances: of the best mirror, the second
 * best, and the best again. */
static double share_of_three(const struct pp_light_scene *scene)
{
    double first = 0.0, second = 0.0;
    for (int i = 0; i < scene->mirror_count; i++) {
        double share = scene->mirrors[i].share;
        second = fmax(second, fmin(first, share));
        first = fmax(first, share);
    }
    return first * first * second;
}

enum pp_status pp_mirrors_find(struct pp_light_scene *scene, struct pp_error *err)
{
    if (scene->emitter_count == 0)
        return PP_OK;
    scene->mirrors = calloc(MOST_MIRRORS, sizeof *scene->mirrors);
    scene->mirror_paths =
        calloc((size_t)MOST_MIRRORS * MOST_MIRRORS, sizeof *scene->mirror_paths);
    if (!scene->mirrors || !scene->mirror_paths)
        return pp_fail_memory(err);
    enum pp_status status = find_mirrors(scene, err);
    if (status != PP_OK)
        return status;
    make_mirror_paths(scene);
    scene->unsampled_share =
        fmin(1.0, fmax(scene->unsampled_share, share_of_three(scene)));
    return PP_OK;
}

/* ---- images ---- */

int pp_mirrors_path_extend(const struct pp_light_scene *scene, int mirror_path,
                           int mirror)
{
    int first = mirror, second = -1;
    if (mirror_path >= 0) {
        first = scene->mirror_paths[mirror_path].mirrors[0];
        second = mirror;
    }
    bool full =
        mirror < 0
        || (mirror_path >= 0 && scene->mirror_paths[mirror_path].mirrors[1] >= 0);
    for (int i = 0; i < scene->mirror_path_count && !full; i++)
        if (scene->mirror_paths[i].mirrors[0] == first
            && scene->mirror_paths[i].mirrors[1] == second)
            return i;
    return -1;
}

static const struct pp_mirror *mirror_in(const struct pp_light_scene *scene,
                                         int mirror_path, int i)
{
    int mirror = mirror_path < 0 ? -1 : scene->mirror_paths[mirror_path].mirrors[i];
    return mirror < 0 ? NULL : &scene->mirrors[mirror];
}

struct pp_vec3 pp_mirrors_path_point(const struct pp_light_scene *scene,
                                     int mirror_path, struct pp_vec3 p)
{
    const struct pp_mirror *mirror;
    for (int i = 0;
         i < PP_MIRROR_PATH_MOST && (mirror = mirror_in(scene, mirror_path, i)); i++)
        p = pp_vec_along(p, 2.0 * (mirror->offset_m - pp_vec_dot(mirror->normal, p)),
                         mirror->normal);
    return p;
}

struct pp_vec3 pp_mirrors_path_direction(const struct pp_light_scene *scene,
                                         int mirror_path, struct pp_vec3 u)
{
    const struct pp_mirror *mirror;
    for (int i = 0;
         i < PP_MIRROR_PATH_MOST && (mirror = mirror_in(scene, mirror_path, i)); i++)
        u = pp_vec_mirrored(u, mirror->normal);
    return u;
}

struct pp_vec3 pp_mirrors_path_unfold(const struct pp_light_scene *scene,
                                      int mirror_path, struct pp_vec3 u)
{
    const struct pp_mirror *mirror;
    for (int i = PP_MIRROR_PATH_MOST - 1; i >= 0; i--)
        if ((mirror = mirror_in(scene, mirror_path, i)))
            u = pp_vec_mirrored(u, mirror->normal);
    return u;
}
