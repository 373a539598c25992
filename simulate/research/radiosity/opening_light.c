/* opening_light.c - divides panes into cells until the light of each cell agrees with
 * the light of its parts. */
#include "simulate/research/radiosity/opening_light.h"

#include <math.h>

#include "model/geometry/clip.h"
#include "model/geometry/convex_parts.h"
#include "simulate/research/radiosity/form_factor.h"

enum {
    DEEPEST = 9, /* most divisions that split a cell's light among its parts */
    NEAREST =
        48, /* most divisions in all: enough for a point at 1e-14 of the pane's size in
             * front of it */
};

/* Smaller differences in light, over Eh, are not resolved: a fifth of the path tracer's
 * least error. */
static const double UNTOLD = 4e-6;

/* Corners are moved towards the middle of their cell by this factor before they are
 * tested. */
static const double WITHIN = 0.96;
/* Rough fraction of a part's area in which light may differ if only the test at the
 * corner shows the difference. */
static const double CORNER = 0.25;

struct looking {
    const struct pp_light_room *room;
    struct pp_element_view *view;
    const struct pp_taker *taker;
    const struct pp_opening_light_accuracy *accuracy;
    struct pp_light_sum *sum;
    int pane;             /* facet of the pane */
    bool through_opening; /* only the edges of its opening limit the view of the pane */
    double tolerance;     /* tolerance of the pane's light */
};

/* A cell with the light along the ray to its middle, and the range of its terms in the
 * sum. */
struct cell {
    const struct pp_vec3 *corners;
    int count;
    double factor, light;
    struct pp_vec3 middle;
    bool seen; /* true if the middle is seen */
    struct pp_light_mark from, to;
};

/* Adds the light along the ray through a point of the pane, or along the ray mirrored
 * there. */
static void add_ray(const struct looking *l, struct pp_vec3 point, bool mirrored,
                    double weight)
{
    const struct pp_facet *pane = &l->room->facets->list[l->pane];
    struct pp_vec3 to = pp_vec_unit(pp_vec_sub(point, l->taker->point));
    double cosine = fmin(fabs(pp_vec_dot(pane->normal, to)), 1.0);
    struct pp_light_ray_start on = {point, to, l->pane, mirrored};
    weight *=
        mirrored ? pp_facet_mirrored(pane, cosine) : pp_facet_straight(pane, cosine);
    if (mirrored)
        on.to = pp_vec_mirrored(to, pane->normal);
    if (weight > 0.0)
        pp_light_ray_follow(l->room, &on, weight, mirrored ? PP_IRC : PP_DF, l->sum);
}

/* Middle of the part of the cell above the receiver's horizon. */
static struct pp_vec3 middle_above(const struct looking *l, const struct cell *cell)
{
    struct pp_vec3 above[PP_FORM_FACTOR_MOST + 1];
    int count = pp_clip_convex(above, cell->corners, cell->count, l->taker->normal,
                               pp_vec_dot(l->taker->normal, l->taker->point));
    return pp_element_tree_middle(above, count, NULL);
}

static void add_cell_light(const struct looking *l, struct cell *cell)
{
    cell->factor =
        pp_form_factor(l->taker->point, l->taker->normal, cell->corners, cell->count);
    cell->light = 0.0;
    cell->from = cell->to = pp_light_sum_mark(l->sum);
    if (!(cell->factor > 0.0))
        return;
    cell->middle = middle_above(l, cell);
    cell->seen = pp_element_sight_shows(l->view, cell->middle);
    if (cell->seen)
        add_ray(l, cell->middle, false, 1.0);
    cell->light = pp_light_ray_guess(l->room, l->sum, &cell->from);
    cell->to = pp_light_sum_mark(l->sum);
}

/* True if the light at a cell's corners also agrees with the light of its parts. The
 * middles of the parts alone may miss an obstruction at an edge. */
static bool corners_agree(const struct looking *l, const struct cell *cell,
                          const struct cell *parts, int count, double tolerance)
{
    struct pp_vec3 middle = pp_element_tree_middle(cell->corners, cell->count, NULL);
    for (int i = 0; i < cell->count; i++) {
        struct pp_vec3 corner =
            pp_vec_along(middle, WITHIN, pp_vec_sub(cell->corners[i], middle));
        const struct cell *nearest = NULL;
        double least = INFINITY;
        for (int k = 0; k < count; k++) {
            double off = pp_vec_length(pp_vec_sub(parts[k].middle, corner));
            if (parts[k].factor > 0.0 && off < least) {
                least = off;
                nearest = &parts[k];
            }
        }
        if (!nearest
            || pp_vec_dot(l->taker->normal, pp_vec_sub(corner, l->taker->point)) <= 0.0)
            continue;
        struct pp_light_mark from = pp_light_sum_mark(l->sum), to;
        if (pp_element_sight_shows(l->view, corner))
            add_ray(l, corner, false, 1.0);
        double light = pp_light_ray_guess(l->room, l->sum, &from);
        to = pp_light_sum_mark(l->sum);
        pp_light_sum_scale(l->sum, &from, &to, 0.0);
        if (fabs(light - nearest->light) * nearest->factor * CORNER > tolerance)
            return false;
    }
    return true;
}

/* True if the part has most of its cell's form factor, and this form factor is too
 * large for a single value. The part is then close to the receiving point, relative to
 * its size. A division then approaches the point, but does not split the light. */
static bool is_nearest(const struct looking *l, const struct cell *cell,
                       const struct cell *part)
{
    return part->factor > 0.5 * cell->factor && part->factor > l->accuracy->most_factor;
}

/* Replaces the cell by its parts, recursively. divisions: number of all divisions so
 * far; depth: number of those that split the light. Returns the light. */
static double divide_cell(const struct looking *l, const struct cell *cell, int depth,
                          int divisions, double tolerance)
{
    struct pp_element_parts cut;
    struct cell parts[PP_ELEMENT_PARTS];
    double sum = 0.0, most = 0.0;
    pp_element_tree_cut(&cut, &l->room->facets->list[l->pane], cell->corners,
                        cell->count);
    int count = cut.count;
    for (int i = 0; i < count; i++) {
        parts[i] = (struct cell){.corners = cut.corners[i], .count = cut.counts[i]};
        add_cell_light(l, &parts[i]);
        sum += parts[i].factor * parts[i].light;
        most = fmax(most, parts[i].factor);
    }
    bool enough = depth >= l->accuracy->least_depth && most <= l->accuracy->most_factor
                  && (isinf(tolerance)
                      || (fabs(sum - cell->factor * cell->light) <= tolerance
                          && corners_agree(l, cell, parts, count, tolerance)));
    if (!enough && depth < DEEPEST && divisions < NEAREST) {
        double light = 0.0;
        for (int i = 0; i < count; i++) {
            bool near = is_nearest(l, cell, &parts[i]);
            pp_light_sum_scale(l->sum, &parts[i].from, &parts[i].to, 0.0);
            if (parts[i].factor > 0.0)
                light +=
                    divide_cell(l, &parts[i], near ? depth : depth + 1, divisions + 1,
                                near ? tolerance : l->accuracy->stricter * tolerance);
        }
        return light;
    }
    for (int i = 0; i < count; i++) {
        pp_light_sum_scale(l->sum, &parts[i].from, &parts[i].to, parts[i].factor);
        if (parts[i].seen)
            add_ray(l, parts[i].middle, true, parts[i].factor);
    }
    return sum;
}

/* Clips a convex piece of a pane exactly to the part visible through the pane's opening
 * in its face, which lies between the planes through the receiver and the opening's
 * edges. *corners receives the corners of that part. Returns their number, less than 3
 * if nothing is visible. */
static int through_opening(const struct looking *l, const struct pp_piece *piece,
                           struct pp_vec3 seen[2][PP_FORM_FACTOR_MOST + 1],
                           const struct pp_vec3 **corners)
{
    const struct pp_facets *facets = l->room->facets;
    const struct pp_polygon *inner = &facets->list[l->pane].opening->inner;
    int count = piece->count;
    *corners = &facets->corners[piece->first_corner];
    if (!l->through_opening)
        return count;
    for (int i = 0; count >= 3 && i < inner->count; i++) {
        struct pp_vec3 a = pp_vec_sub(inner->vertices[i], l->taker->point);
        struct pp_vec3 b = pp_vec_sub(inner->vertices[i + 1 < inner->count ? i + 1 : 0],
                                      l->taker->point);
        /* The opening's outline is counter-clockwise seen against its normal. */
        struct pp_vec3 in = pp_vec_cross(b, a);
        double length = pp_vec_length(in);
        if (!(length > 0.0))
            continue;
        in = pp_vec_scale(in, 1.0 / length);
        count = pp_clip_convex(seen[i % 2], *corners, count, in,
                               pp_vec_dot(in, l->taker->point));
        *corners = seen[i % 2];
    }
    return count;
}

static double add_pane(const struct looking *l)
{
    const struct pp_facets *facets = l->room->facets;
    const struct pp_facet *pane = &facets->list[l->pane];
    struct pp_vec3 seen[2][PP_FORM_FACTOR_MOST + 1];
    double light = 0.0;
    for (int i = 0; i < pane->piece_count; i++) {
        const struct pp_piece *piece = &facets->pieces[pane->first_piece + i];
        struct cell cell = {.factor = 0.0};
        cell.count = through_opening(l, piece, seen, &cell.corners);
        if (cell.count < 3)
            continue;
        cell.factor =
            pp_form_factor(l->taker->point, l->taker->normal, cell.corners, cell.count);
        cell.light = NAN; /* no value yet, so that the cell is always divided at least
                           * once */
        if (cell.factor > 0.0)
            light += divide_cell(l, &cell, 0, 0, l->tolerance);
    }
    return light;
}

/* True if the receiving point is in front of the pane, on the room's side, and not on
 * the pane itself. */
static bool faces(const struct looking *l)
{
    const struct pp_facet *pane = &l->room->facets->list[l->pane];
    return l->taker->facet != l->pane && pp_facet_height(pane, l->taker->point) > 0.0;
}

/* True if the facet is the opening's face, a part of its reveal, or a door or dado on
 * its face. */
static bool is_round(const struct pp_facets *facets, const struct pp_opening *opening,
                     int facet)
{
    const struct pp_world *world = facets->world;
    if (facet == opening->face || facet >= world->surface_count)
        return facet == opening->face;
    const struct pp_surface *surface = &world->surfaces[facet];
    return (surface->role == PP_REVEAL && surface->owner == opening - world->openings)
           || (surface->role == PP_COVER && surface->owner == opening->face);
}

/* Restricts the view to the opening if the receiving point is in front of its face. The
 * opening's edges then hide everything that its face and reveal could hide. The face
 * and the reveal are therefore removed from the blockers. */
static void look_through(struct looking *l)
{
    struct pp_element_view *view = l->view;
    const struct pp_facets *facets = l->room->facets;
    const struct pp_opening *opening = facets->list[l->pane].opening;
    int left = 0;
    l->through_opening =
        view->blocker_count > 0 && opening->inner.count <= PP_FORM_FACTOR_MOST / 4
        && pp_convex_parts_is_convex(&opening->inner)
        && pp_facet_height(&facets->list[opening->face], l->taker->point) > 1e-9;
    if (!l->through_opening)
        return;
    for (int i = 0; i < view->blocker_count; i++)
        if (!is_round(facets, opening, view->blockers[i]))
            view->blockers[left++] = view->blockers[i];
    view->blocker_count = left;
}

void pp_opening_light_add(const struct pp_light_room *room,
                          const struct pp_taker *taker,
                          const struct pp_opening_light_accuracy *accuracy,
                          struct pp_light_sum *sum)
{
    struct pp_element_view view;
    struct pp_light_sum rough = {.failed = false};
    struct pp_opening_light_accuracy first = {INFINITY, INFINITY, 0, 1.0};
    double light = 0.0;
    bool looks = pp_element_sight_view_init(&view, room->sight, taker->point);
    sum->failed |= !looks;
    for (int pass = 0; looks && pass < 2; pass++)
        for (int i = 0; i < room->sight->count; i++) {
            const struct pp_facet *facet = &room->facets->list[room->sight->inside[i]];
            struct looking l = {.room = room,
                                .view = &view,
                                .taker = taker,
                                .accuracy = pass ? accuracy : &first,
                                .sum = pass ? sum : &rough,
                                .pane = room->sight->inside[i]};
            if (!facet->clear || !faces(&l))
                continue;
            pp_element_sight_look_at(&view, i);
            look_through(&l);
            l.tolerance = pass ? accuracy->error * fmax(light, UNTOLD) : INFINITY;
            double found = add_pane(&l);
            light += pass ? 0.0 : found;
        }
    sum->failed |= rough.failed;
    pp_light_sum_clear(&rough);
    pp_element_sight_view_clear(&view);
}
