/* hidden_outline.c - at one bearing a half-space n hides the altitudes a with
 *
 *     n.h cos a + n_z sin a >= 0
 *
 *   h  unit, level, in the direction of the bearing
 *
 * so that each bounds them from below or from above.
 */
#include "methods/exact/hidden_outline.h"

#include <math.h>

#include "model/base/array.h"

#define STEP_RAD (0.25 * PP_RAD)
#define END_RAD (0.001 * PP_RAD)

/* One cone's half-spaces. */
struct cone {
    const struct pp_vec3 *half_spaces;
    int count;
    double north_rad;
};

/* The altitudes hidden at that bearing; false: none. */
static bool hidden_at(const struct cone *cone, double bearing, double *low,
                      double *high)
{
    double angle = bearing - cone->north_rad;
    struct pp_vec3 h = {sin(angle), cos(angle), 0.0};
    *low = 0.0;
    *high = 0.5 * PP_PI;
    for (int i = 0; i < cone->count; i++) {
        double level = pp_vec_dot(cone->half_spaces[i], h);
        double up = cone->half_spaces[i].z;
        if (level >= 0.0 && up >= 0.0)
            continue;
        if (level < 0.0 && up <= 0.0)
            return false;
        if (level >= 0.0)
            *high = fmin(*high, atan2(level, -up));
        else
            *low = fmax(*low, atan2(-level, up));
    }
    return *high - *low > 1e-9;
}

static enum pp_status add_edge(struct pp_sky_mask_piece *piece, const struct cone *cone,
                               double bearing, struct pp_error *err)
{
    double low, high;
    if (!hidden_at(cone, bearing, &low, &high))
        return PP_OK;
    enum pp_status status = pp_array_reserve(
        &piece->edges, &piece->capacity, piece->count + 1, sizeof *piece->edges, err);
    if (status != PP_OK)
        return status;
    double *edge = piece->edges[piece->count++];
    edge[0] = bearing;
    edge[1] = low;
    edge[2] = high;
    return PP_OK;
}

/* The last bearing at which something is hidden, between one where it is and one where it is
 * not. */
static double end_between(const struct cone *cone, double hidden, double clear)
{
    double low, high;
    while (fabs(clear - hidden) > END_RAD) {
        double middle = 0.5 * (hidden + clear);
        if (hidden_at(cone, middle, &low, &high))
            hidden = middle;
        else
            clear = middle;
    }
    return hidden;
}

static enum pp_status begin_piece(struct pp_sky_mask *mask, struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&mask->pieces, mask->count, sizeof *mask->pieces, err);
    if (status == PP_OK)
        mask->pieces[mask->count++] = (struct pp_sky_mask_piece){0};
    return status;
}

static enum pp_status add_cone(struct pp_sky_mask *mask, const struct cone *cone,
                               struct pp_error *err)
{
    int steps = (int)lround(2.0 * PP_PI / STEP_RAD);
    bool before = false;
    enum pp_status status = PP_OK;
    for (int i = 0; i <= steps && status == PP_OK; i++) {
        double low, high, bearing = i * STEP_RAD;
        bool now = hidden_at(cone, bearing, &low, &high);
        if (now && !before) {
            status = begin_piece(mask, err);
            if (status == PP_OK && i > 0)
                status = add_edge(&mask->pieces[mask->count - 1], cone,
                                  end_between(cone, bearing, bearing - STEP_RAD), err);
        }
        if (status == PP_OK && now)
            status = add_edge(&mask->pieces[mask->count - 1], cone, bearing, err);
        if (status == PP_OK && before && !now)
            status = add_edge(&mask->pieces[mask->count - 1], cone,
                              end_between(cone, bearing - STEP_RAD, bearing), err);
        before = now;
    }
    return status;
}

enum pp_status pp_hidden_outline_add(struct pp_sky_mask *mask,
                                     const struct pp_hidden_cones *cones,
                                     double north_rad, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0, first = 0; i < cones->count && status == PP_OK; i++) {
        const struct cone cone = {cones->half_spaces + first,
                                  cones->cones[i].end - first, north_rad};
        status = add_cone(mask, &cone, err);
        first = cones->cones[i].end;
    }
    return status;
}
