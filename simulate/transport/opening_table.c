/* opening_table.c - lays out patches of an opening and bins of directions, and reads
 * the table. */
#include "simulate/transport/opening_table.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/scene/light_scene_parts.h"

enum {
    SIDE = PP_OPENING_TABLE_SIDE,
    BINS = PP_OPENING_TABLE_BINS,
    MOST_PATCHES = 6, /* along either axis */
};

/* Greatest size of a patch, as a fraction of the least distance of surfaces in the
 * table. */
static const double PATCH_SIZE = 0.5;

static int patches_along(double length_m, double near_m)
{
    double count = ceil(length_m / (PATCH_SIZE * near_m));
    return count < 1.0 ? 1 : count > MOST_PATCHES ? MOST_PATCHES : (int)count;
}

enum pp_status pp_opening_table_init(struct pp_opening_table *table,
                                     const struct pp_target *target, double near_m,
                                     struct pp_error *err)
{
    *table =
        (struct pp_opening_table){.columns = patches_along(target->width_m, near_m),
                                  .rows = patches_along(target->height_m, near_m)};
    if (!isfinite(near_m))
        return PP_OK;
    size_t patches = (size_t)table->columns * (size_t)table->rows;
    table->far_m =
        fmax(target->width_m / table->columns, target->height_m / table->rows)
        / PATCH_SIZE;
    table->radiance = calloc(patches * BINS, sizeof *table->radiance);
    return table->radiance ? PP_OK : pp_fail_memory(err);
}

void pp_opening_table_clear(struct pp_opening_table *table)
{
    free(table->radiance);
    table->radiance = NULL;
}

struct pp_vec3 pp_opening_table_point(const struct pp_opening_table *table,
                                      const struct pp_target *target, int patch,
                                      double u, double v)
{
    double x = (patch % table->columns + u) / table->columns * target->width_m;
    double y = (patch / table->columns + v) / table->rows * target->height_m;
    return pp_target_point(target, x, y);
}

bool pp_opening_table_direction(const struct pp_target *target, int bin, double u,
                                double v, struct pp_vec3 *to)
{
    double x = (bin % SIDE + u) / SIDE * 2.0 - 1.0;
    double y = (bin / SIDE + v) / SIDE * 2.0 - 1.0;
    double z2 = 1.0 - x * x - y * y;
    if (!(z2 > 0.0))
        return false;
    *to = pp_vec_along(
        pp_vec_along(pp_vec_scale(target->normal, -sqrt(z2)), x, target->along), y,
        target->up);
    return true;
}

/* ---- read ---- */

static int kept_within(double x, int count)
{
    int i = (int)x;
    return i < 0 || !(x > 0.0) ? 0 : i < count ? i : count - 1;
}

static int patch_at(const struct pp_opening_table *table,
                    const struct pp_target *target, struct pp_vec3 point)
{
    struct pp_vec3 from = pp_vec_sub(point, target->corner);
    int column =
        kept_within(pp_vec_dot(from, target->along) / target->width_m * table->columns,
                    table->columns);
    int row = kept_within(pp_vec_dot(from, target->up) / target->height_m * table->rows,
                          table->rows);
    return row * table->columns + column;
}

/* Bins are squares in the plane of the direction's components along the opening's
 * axes. */
static int bin_of(const struct pp_target *target, struct pp_vec3 to)
{
    int column = kept_within((pp_vec_dot(to, target->along) + 1.0) / 2.0 * SIDE, SIDE);
    int row = kept_within((pp_vec_dot(to, target->up) + 1.0) / 2.0 * SIDE, SIDE);
    return row * SIDE + column;
}

bool pp_opening_table_takes(const struct pp_light_scene *scene, enum pp_meeting meeting,
                            const struct pp_light_hit *hit)
{
    return meeting == PP_MEETS_GROUND
           || (meeting == PP_MEETS_PART
               && scene->materials[hit->material].kind == PP_MATERIAL_OPAQUE);
}

bool pp_opening_table_radiance(const struct pp_opening_table *table,
                               const struct pp_target *target, struct pp_vec3 point,
                               struct pp_vec3 to, double distance_m,
                               struct pp_rgb *radiance)
{
    if (!table->radiance || distance_m < table->far_m)
        return false;
    *radiance = table->radiance[(size_t)patch_at(table, target, point) * BINS
                                + (size_t)bin_of(target, to)];
    return true;
}
