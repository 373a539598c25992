/* radiosity.h - a guess of what the room's surfaces give off, on coarse grids.
 *
 * A few thousand cells, each lit through the openings and by each other along a few
 * random rays (the classic gathering radiosity), bilinear between their centres. It is
 * rough, and may be: path.h adds what it leaves out, so that no error of the guess ends
 * in a result. It hangs on the room and the seed alone.
 */
#ifndef PP_SIMULATE_TRACER_RADIOSITY_H
#define PP_SIMULATE_TRACER_RADIOSITY_H

#include "model/base/error.h"
#include "model/room/world.h"
#include "simulate/scene/ray_scene.h"
#include "simulate/sampling/sobol.h"

/* The grid of one side of a facet; a cell's value stands at its centre. */
struct pp_radiosity_grid {
    int first;           /* of its values; -1: no grid on this side */
    int columns, rows;   /* along the facet's a and b */
    double a0, b0;       /* of the first centre, along a and b */
    double per_a, per_b; /* cells a metre */
};

struct pp_radiosity {
    struct pp_radiosity_grid (*patches)[2]; /* by facet and side */
    double *values;                         /* exitance over Eh */
    int count;
};

/* NULL where the room has so many surfaces that it would not pay. */
enum pp_status pp_radiosity_create(struct pp_radiosity **guess,
                                   const struct pp_ray_scene *scene,
                                   const struct pp_world *world,
                                   const struct pp_sobol *sobol, uint64_t seed,
                                   int threads, struct pp_error *err);
void pp_radiosity_destroy(struct pp_radiosity *guess); /* NULL is allowed */

/* The guess where a ray has met something; 0 where there is none. */
double pp_radiosity_at(const struct pp_radiosity *guess,
                       const struct pp_ray_scene *scene,
                       const struct pp_contact *contact);

#endif
