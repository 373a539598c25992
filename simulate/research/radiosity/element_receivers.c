/* element_receivers.c - see element_receivers.h. */
#include "simulate/research/radiosity/element_receivers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    PLANE_POINTS = 600, /* number of points at the first level */
    FEWER_POINTS = 6,   /* divisor of the number of points for reflected light */
};

static bool has_room(const struct pp_facets *facets)
{
    return facets->world->face_count > 0;
}

static void clear_receiver(struct pp_element_receiver *receiver)
{
    pp_light_sum_clear(&receiver->openings);
    pp_light_sum_clear(&receiver->elements);
    free(receiver->wanted.list);
    receiver->wanted = (struct pp_wanted){NULL, 0, 0};
}

/* ---- the receivers ---- */

enum pp_status pp_element_receivers_init(struct pp_element_receivers *receivers,
                                         const struct pp_receiver *asked, int count,
                                         struct pp_error *err)
{
    *receivers = (struct pp_element_receivers){.asked = count, .count = count};
    receivers->list = calloc((size_t)count + 1, sizeof *receivers->list);
    if (!receivers->list)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        receivers->list[i].at = asked[i];
    return PP_OK;
}

static void clear_plane(struct pp_element_receivers *receivers)
{
    pp_plane_points_clear(&receivers->direct);
    pp_plane_points_clear(&receivers->reflected);
}

void pp_element_receivers_clear(struct pp_element_receivers *receivers)
{
    for (int i = 0; receivers->list && i < receivers->count; i++)
        clear_receiver(&receivers->list[i]);
    clear_plane(receivers);
    free(receivers->list);
    *receivers = (struct pp_element_receivers){.list = NULL};
}

/* Sets the points of the plane. If there is a diffusing pane, which emits like a
 * surface, reflected light is gathered at all points. */
static enum pp_status set_plane(struct pp_element_receivers *receivers,
                                const struct pp_facets *facets, int level,
                                struct pp_error *err)
{
    int wanted = PLANE_POINTS << level, fewer = wanted / FEWER_POINTS;
    for (int i = 0; i < facets->count; i++)
        fewer = facets->list[i].through > 0.0 ? wanted : fewer;
    enum pp_status status =
        pp_plane_points_of(&receivers->direct, facets->world, wanted, err);
    if (status == PP_OK)
        status = pp_plane_points_of(&receivers->reflected, facets->world, fewer, err);
    return status;
}

enum pp_status pp_element_receivers_begin(struct pp_element_receivers *receivers,
                                          struct pp_radiosity_system *system, int level,
                                          struct pp_error *err)
{
    const struct pp_facets *facets = system->room->facets;
    const struct pp_plane_points *direct = &receivers->direct;
    const struct pp_plane_points *reflected = &receivers->reflected;
    for (int i = 0; i < receivers->count; i++)
        clear_receiver(&receivers->list[i]);
    receivers->count = receivers->asked;
    receivers->system = system;
    receivers->level = level;
    clear_plane(receivers);
    enum pp_status status = PP_OK;
    if (has_room(facets))
        status = set_plane(receivers, facets, level, err);
    if (status != PP_OK)
        return status;
    int count = receivers->asked + direct->count + reflected->count;
    struct pp_element_receiver *more =
        realloc(receivers->list, ((size_t)count + 1) * sizeof *more);
    if (!more)
        return pp_fail_memory(err);
    receivers->list = more;
    for (int i = receivers->asked; i < count; i++) {
        int k = i - receivers->asked;
        struct pp_vec3 place =
            k < direct->count ? direct->list[k] : reflected->list[k - direct->count];
        more[i] = (struct pp_element_receiver){
            .at = {.position = place, .normal = {0.0, 0.0, 1.0}}};
    }
    receivers->count = count;
    return PP_OK;
}

/* ---- gathering ---- */

static struct pp_opening_light_accuracy of_openings(int level)
{
    double finer = ldexp(1.0, level);
    return (struct pp_opening_light_accuracy){.error = 0.004 / finer,
                                              .most_factor = 0.03 / finer,
                                              .least_depth = level > 0,
                                              .stricter = 0.5};
}

struct pp_element_light_accuracy pp_element_receivers_accuracy(int level)
{
    double finer = ldexp(1.0, level);
    return (struct pp_element_light_accuracy){.most_factor = 0.05 / finer,
                                              .least_factor = 1e-3 / finer};
}

static bool take_by_openings(void *data, int worker, int index)
{
    const struct pp_element_receivers *receivers = data;
    const struct pp_radiosity_system *system = receivers->system;
    struct pp_element_receiver *receiver = &receivers->list[index];
    struct pp_taker taker = {receiver->at.position, receiver->at.normal, -1};
    struct pp_opening_light_accuracy accuracy = of_openings(receivers->level);
    (void)worker;
    pp_light_sum_clear(&receiver->openings);
    if (has_room(system->room->facets)) {
        pp_opening_light_add(system->room, &taker, &accuracy, &receiver->openings);
        return true;
    }
    struct pp_light_ray_start place = {taker.point, taker.normal, -1, false};
    pp_outside_cells_hemisphere(system->room, &place, 4096 << 2 * receivers->level,
                                (unsigned)index, 1.0, PP_DF, &receiver->openings);
    return true;
}

static bool take_by_elements(void *data, int worker, int index)
{
    const struct pp_element_receivers *receivers = data;
    const struct pp_radiosity_system *system = receivers->system;
    struct pp_element_receiver *receiver = &receivers->list[index];
    struct pp_taker taker = {receiver->at.position, receiver->at.normal, -1};
    struct pp_element_light_accuracy accuracy =
        pp_element_receivers_accuracy(receivers->level);
    (void)worker;
    accuracy.tolerance = 0.5 * system->accuracy.even * receiver->df;
    accuracy.divided = receiver->df > 0.0
                           ? 0.008 / ldexp(1.0, receivers->level) * receiver->df
                           : INFINITY;
    pp_light_sum_clear(&receiver->elements);
    receiver->wanted.count = 0;
    if (has_room(system->room->facets))
        pp_element_light_add(system->room, &taker, &accuracy, &receiver->elements,
                             &receiver->wanted);
    return true;
}

static void set_value(const struct pp_radiosity_system *system,
                      struct pp_element_receiver *receiver)
{
    memset(receiver->openings_value, 0, sizeof receiver->openings_value);
    memset(receiver->elements_value, 0, sizeof receiver->elements_value);
    pp_radiosity_system_value(system, &receiver->openings, false,
                              receiver->openings_value);
    pp_radiosity_system_value(system, &receiver->elements, true,
                              receiver->elements_value);
    receiver->df = 0.0;
    for (int i = 0; i < PP_LIGHT_PARTS; i++)
        receiver->df += receiver->openings_value[i] + receiver->elements_value[i];
}

static enum pp_status by_openings(struct pp_element_receivers *receivers, int first,
                                  int end, struct pp_error *err)
{
    struct pp_radiosity_system *system = receivers->system;
    enum pp_status status = PP_OK;
    pp_thread_pool_run(system->pool, first, end, take_by_openings, receivers);
    for (int i = first; status == PP_OK && i < end; i++)
        status = pp_outside_cells_resolve(system->cells, system->room,
                                          &receivers->list[i].openings, err);
    if (status == PP_OK)
        status =
            pp_outside_cells_gather(system->cells, system->room, system->pool, err);
    if (status == PP_OK)
        pp_radiosity_system_solve(system);
    return status;
}

static enum pp_status by_elements(struct pp_element_receivers *receivers, int first,
                                  int end, struct pp_error *err)
{
    pp_thread_pool_run(receivers->system->pool, first, end, take_by_elements,
                       receivers);
    for (int i = first; i < end; i++) {
        set_value(receivers->system, &receivers->list[i]);
        if (receivers->list[i].elements.failed)
            return pp_fail_memory(err);
    }
    return PP_OK;
}

enum pp_status pp_element_receivers_by_openings(struct pp_element_receivers *receivers,
                                                struct pp_error *err)
{
    return by_openings(receivers, 0, receivers->asked, err);
}

enum pp_status pp_element_receivers_by_elements(struct pp_element_receivers *receivers,
                                                struct pp_error *err)
{
    return by_elements(receivers, 0, receivers->asked, err);
}

/* Gathers light for the plane's average: direct light at the points for direct light,
 * then reflected light at the (usually fewer) points for reflected light. */
enum pp_status pp_element_receivers_on_plane(struct pp_element_receivers *receivers,
                                             struct pp_error *err)
{
    int first = receivers->asked, end = first + receivers->direct.count;
    double df = 0.0;
    enum pp_status status = by_openings(receivers, first, end, err);
    for (int i = first; i < end; i++) {
        set_value(receivers->system, &receivers->list[i]);
        df += receivers->direct.shares[i - first] * receivers->list[i].df;
    }
    for (int i = end; i < receivers->count; i++)
        receivers->list[i].df = df;
    if (status == PP_OK)
        status = by_elements(receivers, end, receivers->count, err);
    return status;
}

/* ---- results ---- */

static void add_components(double value[PP_COMPONENT_COUNT],
                           const double part[PP_LIGHT_PARTS], double share,
                           double decorations)
{
    for (int i = 0; i < PP_LIGHT_PARTS; i++) {
        double more = share * part[i] * (i == PP_IRC ? decorations : 1.0);
        value[i] += more;
        value[PP_DF] += more;
    }
}

void pp_element_receivers_value(const struct pp_element_receivers *receivers, int index,
                                double decorations, double value[PP_COMPONENT_COUNT])
{
    const struct pp_plane_points *direct = &receivers->direct;
    const struct pp_plane_points *reflected = &receivers->reflected;
    const struct pp_element_receiver *receiver =
        &receivers->list[index < 0 ? receivers->asked : index];
    for (int c = 0; c < PP_COMPONENT_COUNT; c++)
        value[c] = index < 0 && direct->count == 0 ? NAN : 0.0;
    if (index >= 0) {
        add_components(value, receiver->openings_value, 1.0, decorations);
        add_components(value, receiver->elements_value, 1.0, decorations);
        return;
    }
    for (int i = 0; i < direct->count; i++, receiver++)
        add_components(value, receiver->openings_value, direct->shares[i], decorations);
    for (int i = 0; i < reflected->count; i++, receiver++)
        add_components(value, receiver->elements_value, reflected->shares[i],
                       decorations);
}
