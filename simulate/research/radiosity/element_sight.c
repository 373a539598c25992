/* element_sight.c - see element_sight.h. */
#include "simulate/research/radiosity/element_sight.h"

#include <math.h>
#include <stdlib.h>

/* Distance (m) within which a point is in a plane. */
static const double IN_PLANE_M = 1e-7;

enum { MOST_PLANES = 64 };

static int plane_count(const struct pp_element_sight *sight)
{
    return sight->count < MOST_PLANES ? sight->count : MOST_PLANES;
}

static const struct pp_facet *inside(const struct pp_element_sight *sight, int i)
{
    return &sight->facets->list[sight->inside[i]];
}

/* Lowest and highest corner of inside[i], as heights (m) above the plane of
 * inside[plane]. */
static void reach(const struct pp_element_sight *sight, int i, int plane, double *low,
                  double *high)
{
    const struct pp_facets *facets = sight->facets;
    const struct pp_facet *facet = inside(sight, i);
    *low = INFINITY;
    *high = -INFINITY;
    for (int k = 0; k < facet->piece_count; k++) {
        const struct pp_piece *piece = &facets->pieces[facet->first_piece + k];
        for (int c = 0; c < piece->count; c++) {
            double height = pp_facet_height(inside(sight, plane),
                                            facets->corners[piece->first_corner + c]);
            *low = fmin(*low, height);
            *high = fmax(*high, height);
        }
    }
}

/* True if the facets form a convex room: each lies in front of the planes of all
 * others. */
static bool hull_is_convex(const struct pp_element_sight *sight)
{
    for (int p = 0; p < sight->count; p++) {
        if (!inside(sight, p)->envelope)
            return false;
        for (int i = 0; i < sight->count; i++) {
            double low, high;
            reach(sight, i, p, &low, &high);
            if (low < -IN_PLANE_M)
                return false;
        }
    }
    return true;
}

static void set_signs(struct pp_element_sight *sight, int i)
{
    for (int p = 0; p < plane_count(sight); p++) {
        double low, high;
        reach(sight, i, p, &low, &high);
        if (low >= -IN_PLANE_M)
            sight->above[i] |= UINT64_C(1) << p;
        if (high <= IN_PLANE_M)
            sight->below[i] |= UINT64_C(1) << p;
    }
}

enum pp_status pp_element_sight_create(struct pp_element_sight **result,
                                       const struct pp_facets *facets,
                                       struct pp_error *err)
{
    *result = NULL;
    struct pp_element_sight *sight = calloc(1, sizeof *sight);
    if (!sight)
        return pp_fail_memory(err);
    size_t room = (size_t)facets->count + 1;
    sight->facets = facets;
    sight->inside = malloc(room * sizeof *sight->inside);
    sight->above = calloc(room, sizeof *sight->above);
    sight->below = calloc(room, sizeof *sight->below);
    if (!sight->inside || !sight->above || !sight->below) {
        pp_element_sight_destroy(sight);
        return pp_fail_memory(err);
    }
    for (int i = 0; i < facets->count; i++)
        if (facets->list[i].side[0].indoors || facets->list[i].side[1].indoors)
            sight->inside[sight->count++] = i;
    for (int i = 0; i < sight->count; i++)
        set_signs(sight, i);
    sight->all_seen = hull_is_convex(sight);
    *result = sight;
    return PP_OK;
}

void pp_element_sight_destroy(struct pp_element_sight *sight)
{
    if (!sight)
        return;
    free(sight->inside);
    free(sight->above);
    free(sight->below);
    free(sight);
}

bool pp_element_sight_view_init(struct pp_element_view *view,
                                const struct pp_element_sight *sight,
                                struct pp_vec3 point)
{
    *view = (struct pp_element_view){.sight = sight, .point = point};
    view->blockers = malloc(((size_t)sight->count + 1) * sizeof *view->blockers);
    for (int p = 0; p < plane_count(sight); p++) {
        double height = pp_facet_height(inside(sight, p), point);
        if (height >= -IN_PLANE_M)
            view->above |= UINT64_C(1) << p;
        if (height <= IN_PLANE_M)
            view->below |= UINT64_C(1) << p;
    }
    return view->blockers;
}

void pp_element_sight_view_clear(struct pp_element_view *view)
{
    free(view->blockers);
}

void pp_element_sight_look_at(struct pp_element_view *view, int target)
{
    const struct pp_element_sight *sight = view->sight;
    uint64_t above = view->above & sight->above[target];
    uint64_t below = view->below & sight->below[target];
    view->blocker_count = 0;
    for (int i = 0; !sight->all_seen && i < sight->count; i++)
        if (i != target && !(above & sight->below[i]) && !(below & sight->above[i]))
            view->blockers[view->blocker_count++] = sight->inside[i];
}

bool pp_element_sight_shows(const struct pp_element_view *view, struct pp_vec3 point)
{
    struct pp_vec3 a = view->point, b = point;
    for (int i = 0; i < view->blocker_count; i++) {
        const struct pp_facet *facet = &view->sight->facets->list[view->blockers[i]];
        double at_a = pp_facet_height(facet, a), at_b = pp_facet_height(facet, b);
        if (fabs(at_a) < 1e-9 || fabs(at_b) < 1e-9 || (at_a > 0.0) == (at_b > 0.0))
            continue;
        struct pp_vec3 crossing =
            pp_vec_along(a, at_a / (at_a - at_b), pp_vec_sub(b, a));
        struct pp_vec3 from = pp_vec_sub(crossing, facet->origin);
        if (pp_region_contains(&facet->region, pp_vec_dot(from, facet->a),
                               pp_vec_dot(from, facet->b)))
            return false;
    }
    return true;
}
