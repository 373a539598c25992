/* radiosity.h - daylight factors of a room by finite elements: the radiosity method of
 * SuperLite, Lumen Micro and Lightscape, without random numbers.
 *
 * The room's surfaces are divided into elements of uniform radiosity, smaller where the
 * light changes (element_tree.h, element_light.h). Light through the openings, and the
 * exitance of places outside, are summed over cells (opening_light.h, outside_cells.h).
 * The equations are solved for all bounces (radiosity_system.h). Receivers gather light
 * in the same way as elements. Only the world is shared with the path tracer: rays,
 * form factors, sky and ground outdoors have their own code.
 *
 * All calculations are made in levels, each with smaller elements, more cells and more
 * directions. The change at the last level measures the remaining error; 98 of 100
 * readings lie within the stated error (docs/methods/radiosity.md).
 *
 * The caller runs the loop, as with the tracer: create, then advance until done. The
 * result depends on the world, light, receivers and the target error alone, and is
 * bit-identical in every run.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_RADIOSITY_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_RADIOSITY_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/results/reading.h"
#include "model/room/world.h"

struct pp_radiosity_options {
    double error; /* target error at every point, relative to the daylight factor or, if
                   * that is less, to 0.2 %. 0: two levels */
    int threads;  /* 0: one for each processor */
};

struct pp_radiosity;

/* Copies the receivers, which are in the room or, if the world has no room, in the
 * open. The world must outlive *radiosity. */
enum pp_status pp_radiosity_create(struct pp_radiosity **radiosity,
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_receiver *receivers,
                                   int receiver_count,
                                   const struct pp_radiosity_options *options,
                                   struct pp_error *err);

/* Advances by one level. */
enum pp_status pp_radiosity_advance(struct pp_radiosity *radiosity,
                                    struct pp_error *err);
bool pp_radiosity_done(const struct pp_radiosity *radiosity);

/* Approximate fraction of the work that is done, 0 to 1. */
double pp_radiosity_progress(const struct pp_radiosity *radiosity);

/* Largest relative error of a daylight factor at any point so far; NAN if it is not
 * known yet. */
double pp_radiosity_error(const struct pp_radiosity *radiosity);

/* The readings so far of receiver `index`, or of the average over the working plane for
 * index -1: readings[PP_SC] ... readings[PP_DF]. */
void pp_radiosity_read(const struct pp_radiosity *radiosity, int index,
                       struct pp_reading readings[PP_COMPONENT_COUNT]);

/* Present size of the system. */
struct pp_radiosity_size {
    int level;             /* number of levels done */
    int elements, divided; /* numbers of undivided and of divided elements */
    int cells;             /* number of cells outside */
    long long terms;       /* number of form factors in the equations */
};
struct pp_radiosity_size pp_radiosity_size(const struct pp_radiosity *radiosity);

void pp_radiosity_destroy(struct pp_radiosity *radiosity); /* NULL is allowed */

#endif
