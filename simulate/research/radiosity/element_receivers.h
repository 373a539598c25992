/* element_receivers.h - what receivers take: those asked for, and points of the working plane for its
 * average.
 *
 * By openings and by elements apart: what comes straight changes fast over the plane, what
 * is reflected slowly, and fewer of its points take that.
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
    double df; /* both, without an allowance for decorations */
};

struct pp_element_receivers {
    struct pp_element_receiver
        *list; /* those asked for, the plane's that take by openings,
                                       * the plane's that take by elements */
    int asked, count;
    struct pp_plane_points direct, reflected; /* the plane's */
    struct pp_radiosity_system *system;       /* what they take; not owned */
    int level;
};

/* Copies the receivers asked for. */
enum pp_status pp_element_receivers_init(struct pp_element_receivers *receivers,
                                         const struct pp_receiver *asked, int count,
                                         struct pp_error *err);
void pp_element_receivers_clear(struct pp_element_receivers *receivers);

/* Nothing taken yet, and the plane's points of this level, where there is a room. */
enum pp_status pp_element_receivers_begin(struct pp_element_receivers *receivers,
                                          struct pp_radiosity_system *system, int level,
                                          struct pp_error *err);

/* Accuracy with which elements are summed by any receiver. */
struct pp_element_light_accuracy pp_element_receivers_accuracy(int level);

/* Gathers light for the receivers asked for. Elements may want dividing afterwards:
 * ->wanted. Cells that are new outside are gathered, and all of it is solved again. */
enum pp_status pp_element_receivers_by_openings(struct pp_element_receivers *receivers,
                                                struct pp_error *err);
enum pp_status pp_element_receivers_by_elements(struct pp_element_receivers *receivers,
                                                struct pp_error *err);

/* Gathers light at the plane's points, by openings and by elements. */
enum pp_status pp_element_receivers_on_plane(struct pp_element_receivers *receivers,
                                             struct pp_error *err);

/* The daylight factors of one asked for, or the plane's average for index -1 (NAN where it
 * has no points); reflected light times an allowance for decorations. */
void pp_element_receivers_value(const struct pp_element_receivers *receivers, int index,
                                double decorations, double value[PP_COMPONENT_COUNT]);

#endif
