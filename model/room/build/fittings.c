/* fittings.c - see fittings.h. */
#include "model/room/build/fittings.h"

#include <math.h>

#include "model/base/array.h"
#include "model/geometry/tolerance.h"
#include "model/room/build/free_surfaces.h"

enum { SIDES_ROUND = PP_FITTING_CORNERS };

/* Name of the part in messages. */
static const char *words_of(const struct pp_fitting_part *part)
{
    static const char *const words[] = {[PP_FURNITURE] = "furniture",
                                        [PP_COLUMN] = "column",
                                        [PP_PARTITION] = "partition"};
    static const char *const as_high[] = {
        [PP_COLUMN] = "column without a height, which reaches the ceiling",
        [PP_PARTITION] = "partition without a height, which reaches the ceiling"};
    return isnan(part->height_m) && part->kind != PP_FURNITURE ? as_high[part->kind]
                                                               : words[part->kind];
}

/* Finds twelve corners outside the circle, so that the polygon has the area of the
 * circle. */
static int round_outline(double xy[PP_FITTING_CORNERS][2],
                         const struct pp_fitting_part *part)
{
    double step = 2.0 * PP_PI / SIDES_ROUND;
    double radius = 0.5 * part->width_m * sqrt(step / sin(step));
    for (int i = 0; i < SIDES_ROUND; i++) {
        xy[i][0] = part->corner.x + radius * cos(step * i);
        xy[i][1] = part->corner.y + radius * sin(step * i);
    }
    return SIDES_ROUND;
}

/* Finds the outline, counter-clockwise seen from above; returns the number of
 * corners. */
static int outline_of(double xy[PP_FITTING_CORNERS][2],
                      const struct pp_fitting_part *part)
{
    if (part->is_round)
        return round_outline(xy, part);
    double w = part->width_m, d = part->depth_m;
    double c = cos(part->rotate_rad), s = sin(part->rotate_rad);
    double left = part->kind == PP_COLUMN ? -0.5 * w : 0.0;
    double front = part->kind == PP_FURNITURE ? 0.0 : -0.5 * d;
    const double corners[4][2] = {
        {left, front}, {left + w, front}, {left + w, front + d}, {left, front + d}};
    for (int i = 0; i < 4; i++) {
        xy[i][0] = part->corner.x + c * corners[i][0] - s * corners[i][1];
        xy[i][1] = part->corner.y + s * corners[i][0] + c * corners[i][1];
    }
    return 4;
}

/* Adds a side. *good is false after a mistake: the caller then stops, so that only one
 * bad side is reported. */
static enum pp_status add_fitting_side(struct pp_resolver *r,
                                       const struct pp_fitting_part *part,
                                       struct pp_vec3 *corners, int count, bool *good,
                                       struct pp_error *err)
{
    int lines[PP_FITTING_CORNERS], faults = r->mistakes->count;
    bool own = isfinite(part->reflectance);
    for (int i = 0; i < count; i++)
        lines[i] = part->line;
    const struct pp_surface_part face = {
        .vertices = {.list = corners, .lines = lines, .count = count},
        .reflectance = own ? part->reflectance : r->room->walls,
        .finish = own ? part->finish : r->room->walls_finish,
        .name = part->name,
        .is_of_room = true,
        .line = part->line};
    enum pp_status status = pp_build_free_surfaces_add(r, &face, words_of(part), err);
    *good = r->mistakes->count == faults;
    return status;
}

static enum pp_status add_fitting(struct pp_resolver *r,
                                  const struct pp_fitting_part *part,
                                  struct pp_error *err)
{
    struct pp_world *world = r->world;
    enum pp_status status = pp_array_append(&world->fittings, world->fitting_count,
                                            sizeof *world->fittings, err);
    if (status != PP_OK)
        return status;
    struct pp_fitting *fitting = &world->fittings[world->fitting_count++];
    double low = part->corner.z;
    double high = isnan(part->height_m) ? world->height_m : low + part->height_m;
    *fitting = (struct pp_fitting){.low_m = low, .high_m = high};
    fitting->corner_count = outline_of(fitting->xy, part);

    double(*xy)[2] = fitting->xy;
    int count = fitting->corner_count;
    struct pp_vec3 ring[PP_FITTING_CORNERS];
    bool good = true;
    for (int i = 0; i < count && good && status == PP_OK; i++) {
        const double *a = xy[i], *b = xy[(i + 1) % count];
        struct pp_vec3 side[4] = {pp_vec(a[0], a[1], low), pp_vec(b[0], b[1], low),
                                  pp_vec(b[0], b[1], high), pp_vec(a[0], a[1], high)};
        status = add_fitting_side(r, part, side, 4, &good, err);
    }
    for (int top = 0; top < 2 && good && status == PP_OK; top++) {
        double z = top ? high : low;
        if (fabs(z) < PP_SAME_M || z > world->height_m - PP_SAME_M)
            continue;
        for (int i = 0; i < count; i++) {
            int k = top ? i : count - 1 - i;
            ring[i] = pp_vec(xy[k][0], xy[k][1], z);
        }
        status = add_fitting_side(r, part, ring, count, &good, err);
    }
    return status;
}

enum pp_status pp_build_fittings(struct pp_resolver *r, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < r->room->fitting_count && r->watertight && status == PP_OK; i++)
        status = add_fitting(r, &r->room->fittings[i], err);
    return status;
}
