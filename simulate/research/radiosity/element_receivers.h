/* element_receivers.h - gathers the light of receivers: the requested points, and
 * points of the working plane for its average.
 *
 * Direct and reflected light are gathered at separate points of the plane. Direct light
 * changes quickly over the plane; reflected light changes slowly and needs fewer
 * points.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_ELEMENT_RECEIVERS_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_ELEMENT_RECEIVERS_H

#include "simulate/research/radiosity/plane_points.h"
#include "simulate/research/radiosity/radiosity_system.h"

struct pp_element_receiver {
    struct pp_receiver at;
    struct pp_light_sum openings, elements;
    struct pp_wanted wanted;
    double openings_value[PP_LIGHT_PARTS], elements_value[PP_LIGHT_PARTS];
    double df; /* direct and reflected light, without an allowance for decorations */
};

struct pp_element_receivers {
    struct pp_element_receiver
        *list; /* requested receivers, then the plane's points for openings, then those
                * for elements */
    int asked, count;
    struct pp_plane_points direct, reflected; /* points of the plane for direct and for
                                               * reflected light */
    struct pp_radiosity_system *system;       /* source of the receivers' light; not
                                               * owned */
    int level;
};

/* Copies the requested receivers. */
enum pp_status pp_element_receivers_init(struct pp_element_receivers *receivers,
                                         const struct pp_receiver *asked, int count,
                                         struct pp_error *err);
void pp_element_receivers_clear(struct pp_element_receivers *receivers);

/* Clears all received light, and sets the plane's points of this level, if there is a
 * room. */
enum pp_status pp_element_receivers_begin(struct pp_element_receivers *receivers,
                                          struct pp_radiosity_system *system, int level,
                                          struct pp_error *err);

/* Accuracy with which the light of elements is summed at any receiver. */
struct pp_element_light_accuracy pp_element_receivers_accuracy(int level);

/* Gather light for the requested receivers. pp_element_receivers_by_openings also
 * gathers light for new cells outside, and solves the system again.
 * pp_element_receivers_by_elements lists the elements that need division in `wanted` of
 * the receiver. */
enum pp_status pp_element_receivers_by_openings(struct pp_element_receivers *receivers,
                                                struct pp_error *err);
enum pp_status pp_element_receivers_by_elements(struct pp_element_receivers *receivers,
                                                struct pp_error *err);

/* Gathers light at the plane's points, from openings and from elements. */
enum pp_status pp_element_receivers_on_plane(struct pp_element_receivers *receivers,
                                             struct pp_error *err);

/* Daylight factors of a requested receiver, or the plane's average for index -1 (NAN if
 * the plane has no points). Reflected light is multiplied by the allowance
 * `decorations`. */
void pp_element_receivers_value(const struct pp_element_receivers *receivers, int index,
                                double decorations, double value[PP_COMPONENT_COUNT]);

#endif
