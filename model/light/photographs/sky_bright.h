/* sky_bright.h - the bright parts of a photographed sky, such as the sun, as a density
 * of directions.
 *
 * The density of a direction is proportional to the excess of its cell, in the
 * picture's table, over four times the mean luminance of the sky. A tenth of the excess
 * of each neighbouring cell is added. A sky without bright parts, such as an overcast
 * one, has none.
 *
 * For a picture that is sampled as a cube of lamps (sky_cube.h), the cells are these
 * lamps, and all of them are bright parts. The density of a lamp is proportional to its
 * light.
 *
 * Directions are drawn by the cumulative sums of the cells, and uniformly within a
 * cell: in solid angle, or on the area of a lamp.
 */
#ifndef PP_MODEL_LIGHT_PHOTOGRAPHS_SKY_BRIGHT_H
#define PP_MODEL_LIGHT_PHOTOGRAPHS_SKY_BRIGHT_H

#include "model/base/error.h"
#include "model/geometry/vec.h"
#include "model/light/sky.h"

/* Directions that represent the density, with equal shares of it. */
enum { PP_SKY_BRIGHT_SOME = 8 };

struct pp_sky_bright {
    struct pp_sky sky;
    double least_cd_m2; /* luminance above which a cell is bright */
    int edge;           /* lamps along an edge of the cube; 0: the cells are those of
                         * the picture's table */
    double integral;    /* of `density` over all cells */
    double share;       /* integral divided by the light of the whole sky; at most 1 */
    float *density;     /* by cell, not normalised: per steradian, or per area of a
                         * lamp */
    int count;          /* bright cells */
    int *cells;         /* their indices */
    double *below;      /* probability of all bright cells before each */
    struct pp_vec3 some[PP_SKY_BRIGHT_SOME];
};

/* Finds the bright parts. *bright is NULL for a sky that is no photograph, for a
 * picture whose light is found by chance, or if `share` is at most
 * 1 %. The picture must outlive *bright. */
enum pp_status pp_sky_bright_create(struct pp_sky_bright **bright,
                                    const struct pp_sky *sky, struct pp_error *err);
void pp_sky_bright_destroy(struct pp_sky_bright *bright); /* NULL is allowed */

/* A direction for two numbers in [0, 1), in the axes of the room, as in
 * pp_sky_luminance. */
struct pp_vec3 pp_sky_bright_draw(const struct pp_sky_bright *bright, double u,
                                  double v);

/* The density of a direction, per steradian. */
double pp_sky_bright_pdf(const struct pp_sky_bright *bright, struct pp_vec3 to);

#endif
