/* element_light.c - descends the element trees of all sides, and adds up the light of
 * their elements. */
#include "simulate/research/radiosity/element_light.h"

#include "model/base/array.h"
#include "simulate/research/radiosity/form_factor.h"

/* Corners are moved towards the middle by this factor before their visibility is
 * tested. At the common edge of two neighbours that hide each other, the test would
 * have no clear result. */
static const double WITHIN = 0.9;

struct descent {
    const struct pp_light_room *room;
    struct pp_element_view view;
    const struct pp_taker *taker;
    const struct pp_element_light_accuracy *accuracy;
    struct pp_light_sum *sum;
    struct pp_wanted *wanted;
};

static double factor_of(const struct descent *g, const struct pp_vec3 *corners,
                        int count)
{
    return pp_form_factor(g->taker->point, g->taker->normal, corners, count);
}

/* Visible fraction of a polygon, tested at its middle and corners: 0, 1, or a value
 * between. by_middle: tested at its middle only. */
static double seen_of(const struct descent *g, const struct pp_vec3 *corners, int count,
                      bool by_middle)
{
    struct pp_vec3 middle = pp_element_tree_middle(corners, count, NULL);
    double seen = pp_element_sight_shows(&g->view, middle);
    for (int i = 0; !by_middle && i < count; i++)
        seen += pp_element_sight_shows(
            &g->view, pp_vec_along(middle, WITHIN, pp_vec_sub(corners[i], middle)));
    return by_middle ? seen : seen / (count + 1);
}

/* Form factor of the visible part of a polygon in element `index`. */
static double factor_seen(const struct descent *g, int index,
                          const struct pp_vec3 *corners, int count)
{
    double factor = factor_of(g, corners, count);
    if (!(factor > 0.0))
        return 0.0;
    bool small = factor <= g->accuracy->least_factor;
    double seen = seen_of(g, corners, count, small);
    bool settled = factor <= g->accuracy->most_factor && (seen == 0.0 || seen == 1.0);
    if (small || settled)
        return factor * seen;
    struct pp_element_parts parts;
    double sum = 0.0;
    pp_element_tree_cut(&parts,
                        &g->room->facets->list[g->room->tree->list[index].side / 2],
                        corners, count);
    for (int i = 0; i < parts.count; i++)
        sum += factor_seen(g, index, parts.corners[i], parts.counts[i]);
    return sum;
}

/* Possible variation of the light received from an element: its spread times the form
 * factor. For distant elements, whose parts have similar form factors, this is reduced
 * by the ratio of size to distance. */
static double unevenness(const struct descent *g, const struct pp_element *element,
                         double factor)
{
    double off = pp_vec_length(pp_vec_sub(element->middle, g->taker->point));
    return factor * element->spread * fmin(1.0, sqrt(element->area_m2) / off);
}

static void want(const struct descent *g, int index)
{
    if (pp_array_reserve(&g->wanted->list, &g->wanted->room, g->wanted->count + 1,
                         sizeof *g->wanted->list, NULL)
        != PP_OK) {
        g->sum->failed = true;
        return;
    }
    g->wanted->list[g->wanted->count++] = index;
}

static void gather_from_element(const struct descent *g, int index)
{
    const struct pp_element_tree *tree = g->room->tree;
    const struct pp_element *element = &tree->list[index];
    const struct pp_vec3 *corners = &tree->corners[element->first_corner];
    bool divided = element->part_count > 0, hidden = g->view.blocker_count > 0;
    double factor = factor_of(g, corners, element->count);
    if (!(factor > 0.0))
        return;
    bool even = unevenness(g, element, factor) <= g->accuracy->tolerance;
    if (divided && (!even || (hidden && factor > g->accuracy->most_factor))) {
        for (int i = 0; i < element->part_count; i++)
            gather_from_element(g, element->first_part + i);
        return;
    }
    if (hidden)
        factor = factor_seen(g, index, corners, element->count);
    if (!divided && unevenness(g, element, factor) > g->accuracy->divided)
        want(g, index);
    if (factor > 0.0)
        pp_light_sum_add(g->sum, index, PP_IRC, factor);
}

void pp_element_light_add(const struct pp_light_room *room,
                          const struct pp_taker *taker,
                          const struct pp_element_light_accuracy *accuracy,
                          struct pp_light_sum *sum, struct pp_wanted *wanted)
{
    const struct pp_element_tree *tree = room->tree;
    struct descent g = {.room = room,
                        .taker = taker,
                        .accuracy = accuracy,
                        .sum = sum,
                        .wanted = wanted};
    bool looks = pp_element_sight_view_init(&g.view, room->sight, taker->point);
    sum->failed |= !looks;
    for (int i = 0; looks && i < room->sight->count; i++) {
        int facet = room->sight->inside[i];
        double height = pp_facet_height(&room->facets->list[facet], taker->point);
        int side = 2 * facet + (height < 0.0);
        if (facet == taker->facet || height == 0.0 || tree->roots[side][1] == 0)
            continue;
        pp_element_sight_look_at(&g.view, i);
        for (int k = 0; k < tree->roots[side][1]; k++)
            gather_from_element(&g, tree->roots[side][0] + k);
    }
    pp_element_sight_view_clear(&g.view);
}
