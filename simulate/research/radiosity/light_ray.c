/* light_ray.c - see light_ray.h. */
#include "simulate/research/radiosity/light_ray.h"

/* A ray is dropped if its weight is below LEAST, or after MOST_PANES panes. */
static const double LEAST = 1e-5;
enum { MOST_PANES = 12 };

/* Assumed illuminance over Eh of a place outside whose radiosity is not yet known. */
static const double GUESS = 0.4;

struct walk {
    const struct pp_light_room *room;
    struct pp_light_sum *sum;
};

static enum pp_component part_or(enum pp_component part, enum pp_component met)
{
    return part == PP_DF ? met : part;
}

/* First facet that the ray meets; -1 and INFINITY: none. */
static int first(const struct pp_facets *facets, const struct pp_light_ray_start *ray,
                 double *distance)
{
    if (!ray->indoors && ray->but >= 0 && facets->list[ray->but].looks_out) {
        *distance = INFINITY;
        return -1;
    }
    return pp_ray_tree_first(facets->rays, ray->from, ray->to, ray->but, distance);
}

static void follow_light_ray(const struct walk *walk,
                             const struct pp_light_ray_start *ray, double weight,
                             enum pp_component part, int panes);

/* Adds the facet's light along the ray. */
static void add_facet(const struct walk *walk, int side, bool indoors,
                      struct pp_vec3 point, double weight, enum pp_component part)
{
    const struct pp_facet *facet = &walk->room->facets->list[side / 2];
    const struct pp_facet_side *own = &facet->side[side % 2];
    if (!indoors) {
        if (own->reflectance > 0.0 || own->exitance > 0.0)
            pp_light_sum_hit(walk->sum, side, point, part_or(part, PP_ERC), weight);
        return;
    }
    int element = pp_element_tree_at(walk->room->tree, side, point);
    if (element >= 0)
        pp_light_sum_add(walk->sum, element, part_or(part, PP_IRC), weight);
}

/* Continues the ray through a clear pane, and as its reflection. */
static void pass(const struct walk *walk, const struct pp_light_ray_start *ray, int met,
                 struct pp_vec3 point, double weight, enum pp_component part, int panes)
{
    const struct pp_facet *pane = &walk->room->facets->list[met];
    double cosine = fmin(fabs(pp_vec_dot(pane->normal, ray->to)), 1.0);
    double straight = weight * pp_facet_straight(pane, cosine);
    double mirrored = weight * pp_facet_mirrored(pane, cosine);
    enum pp_component here = part_or(part, ray->indoors ? PP_DF : PP_IRC);
    struct pp_light_ray_start on = {point, ray->to, met, !ray->indoors};
    if (straight > LEAST)
        follow_light_ray(walk, &on, straight, here, panes + 1);
    on.to = pp_vec_mirrored(ray->to, pane->normal);
    on.indoors = ray->indoors;
    here = part_or(part, ray->indoors ? PP_IRC : PP_ERC);
    if (mirrored > LEAST)
        follow_light_ray(walk, &on, mirrored, here, panes + 1);
}

static void follow_light_ray(const struct walk *walk,
                             const struct pp_light_ray_start *ray, double weight,
                             enum pp_component part, int panes)
{
    const struct pp_light_room *room = walk->room;
    double distance, light, ground_m;
    int met = first(room->facets, ray, &distance);
    if (!ray->indoors) {
        enum pp_outdoors_end end = pp_outdoors_meet(room->outdoors, ray->from, ray->to,
                                                    distance, &light, &ground_m);
        enum pp_component here = part_or(part, end == PP_OUTDOORS_SKY ? PP_SC : PP_ERC);
        if (end == PP_OUTDOORS_GROUND)
            pp_light_sum_hit(walk->sum, -1, pp_vec_along(ray->from, ground_m, ray->to),
                             here, weight);
        else if (end != PP_OUTDOORS_NOTHING)
            walk->sum->fixed[here] += weight * light;
        if (end != PP_OUTDOORS_NOTHING)
            return;
    }
    if (met < 0)
        return;
    const struct pp_facet *facet = &room->facets->list[met];
    int back = pp_vec_dot(ray->to, facet->normal) > 0.0;
    struct pp_vec3 point = pp_vec_along(ray->from, distance, ray->to);
    if (facet->side[back].indoors != ray->indoors)
        return; /* the ray passed between the edges of two facets */
    add_facet(walk, 2 * met + back, ray->indoors, point, weight, part);
    if (facet->clear && panes < MOST_PANES)
        pass(walk, ray, met, point, weight, part, panes);
}

void pp_light_ray_follow(const struct pp_light_room *room,
                         const struct pp_light_ray_start *ray, double weight,
                         enum pp_component part, struct pp_light_sum *sum)
{
    follow_light_ray(&(struct walk){room, sum}, ray, weight, part, 0);
}

double pp_light_ray_guess(const struct pp_light_room *room,
                          const struct pp_light_sum *sum,
                          const struct pp_light_mark *from)
{
    double value = 0.0;
    for (int i = 0; i < PP_LIGHT_PARTS; i++)
        value += sum->fixed[i] - from->fixed[i];
    for (int i = from->term_count; i < sum->term_count; i++)
        value +=
            sum->terms[i].weight * room->tree->list[sum->terms[i].source].radiosity;
    for (int i = from->hit_count; i < sum->hit_count; i++) {
        int side = sum->hits[i].side;
        const struct pp_facet *facets = room->facets->list;
        value += sum->hits[i].weight * GUESS
                 * (side < 0 ? 2.0 * room->outdoors->light.ground_reflectance
                             : facets[side / 2].side[side % 2].reflectance);
    }
    return value;
}
