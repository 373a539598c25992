/* depth_profile.c - see depth_profile.h. */
#include "charts/year/depth_profile.h"

#include <math.h>
#include <stdlib.h>

static const double same_depth_m = 0.05;

static double area_of(const struct pp_opening *opening)
{
    return pp_vec_length(
        pp_polygon_area_vector(opening->inner.vertices, opening->inner.count));
}

/* Index of the wall with the largest area of vertical openings; -1: none. */
static int main_wall(const struct pp_world *world)
{
    int best = -1;
    double most = 0.0;
    for (int f = 0; f < world->face_count; f++) {
        double area = 0.0;
        for (int i = 0; i < world->opening_count; i++)
            if (world->openings[i].face == f
                && fabs(world->openings[i].inner.normal.z) < 0.02)
                area += area_of(&world->openings[i]);
        if (area > most) {
            most = area;
            best = f;
        }
    }
    return best;
}

static int by_depth(const void *left, const void *right)
{
    const struct pp_depth_step *a = left, *b = right;
    return (a->depth_m > b->depth_m) - (a->depth_m < b->depth_m);
}

/* Merges neighbouring entries of about the same depth, averaging their values. */
static void merge_steps(struct pp_depth_profile *profile)
{
    int kept = 0;
    for (int i = 0; i < profile->count; i++) {
        const struct pp_depth_step *one = &profile->steps[i];
        struct pp_depth_step *last = kept > 0 ? &profile->steps[kept - 1] : NULL;
        if (last && one->depth_m - last->depth_m < same_depth_m) {
            double share = 1.0 / ++last->count;
            last->autonomy += share * (one->autonomy - last->autonomy);
            last->blinds_autonomy +=
                share * (one->blinds_autonomy - last->blinds_autonomy);
            last->udi += share * (one->udi - last->udi);
        } else
            profile->steps[kept++] = *one;
    }
    profile->count = kept;
}

enum pp_status pp_depth_profile_find(struct pp_depth_profile *profile,
                                     const struct pp_annual_sheet *sheet,
                                     struct pp_error *err)
{
    *profile = (struct pp_depth_profile){0};
    int wall = main_wall(sheet->world);
    if (wall < 0 || sheet->receiver_count == 0)
        return PP_OK;
    const struct pp_polygon *face = &sheet->world->surfaces[wall].outline;
    profile->steps = calloc(sheet->receiver_count, sizeof *profile->steps);
    if (!profile->steps)
        return pp_fail_memory(err);
    for (int i = 0; i < sheet->receiver_count; i++) {
        double depth_m = pp_vec_dot(
            pp_vec_sub(sheet->receivers[i].position, face->vertices[0]), face->normal);
        if (depth_m < 0.0)
            continue;
        profile->steps[profile->count++] = (struct pp_depth_step){
            .depth_m = depth_m,
            .count = 1,
            .autonomy = sheet->points[i].autonomy_300.value,
            .blinds_autonomy = sheet->points[i].blinds_autonomy.value,
            .udi = sheet->points[i].udi_good.value};
    }
    if (profile->count == 0)
        return PP_OK;
    qsort(profile->steps, profile->count, sizeof *profile->steps, by_depth);
    merge_steps(profile);
    return PP_OK;
}

void pp_depth_profile_clear(struct pp_depth_profile *profile)
{
    free(profile->steps);
    *profile = (struct pp_depth_profile){0};
}
