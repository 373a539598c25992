/* angle_basis.h - the patches into which a measured pane's data divide a hemisphere.
 *
 * Two kinds of basis:
 *
 *     rings    Klems's: rings about the normal, each divided into equal patches. The
 *              first patch of a ring is centred on azimuth 0; the others follow
 *              counter-clockwise.
 *     grid     side x side cells of the unit square, mapped to the disc of the
 *              projected hemisphere by the equal-area map of Shirley and Chiu [SC97].
 *              All cells have the same projected solid angle.
 *
 * Directions are unit vectors in the axes of the pane (pane_scatter.h). A patch depends
 * only on x and y; the sign of z has no effect.
 */
#ifndef PP_MODEL_LIGHT_BSDF_ANGLE_BASIS_H
#define PP_MODEL_LIGHT_BSDF_ANGLE_BASIS_H

#include <stdbool.h>

#include "model/geometry/vec.h"

enum { PP_ANGLE_BASIS_RINGS_MOST = 32, PP_ANGLE_BASIS_PATCHES_MOST = 1024 };

struct pp_angle_ring {
    double low_rad, high_rad; /* angles from the normal */
    int patches;
    int first; /* index of its first patch */
};

struct pp_angle_basis {
    int count;      /* number of patches */
    int side;       /* cells along one side of a grid; 0: rings */
    int ring_count; /* number of rings; 0: grid */
    struct pp_angle_ring rings[PP_ANGLE_BASIS_RINGS_MOST];
};

/* Finds a basis by its name in WINDOW's files ("LBNL/Klems Full", "... Half", "...
 * Quarter"); false if there is none. */
bool pp_angle_basis_named(struct pp_angle_basis *basis, const char *name);

/* Adds the next ring to a basis (initialised with zeros). A ring must begin where the
 * previous one ends, the first at 0. The number of its patches must be 1 or even, so
 * that each patch has an opposite one. Returns false for other rings, or if there are
 * too many patches. */
bool pp_angle_basis_add_ring(struct pp_angle_basis *basis, double low_rad,
                             double high_rad, int patches);

struct pp_angle_basis pp_angle_basis_grid(int side);

bool pp_angle_basis_is_same(const struct pp_angle_basis *a,
                            const struct pp_angle_basis *b);

/* Projected solid angle of a patch; the sum over a hemisphere is pi. */
double pp_angle_basis_projected(const struct pp_angle_basis *basis, int patch);

/* The patch that contains a direction. */
int pp_angle_basis_find(const struct pp_angle_basis *basis, struct pp_vec3 direction);

/* Maps two numbers from 0 to 1 to a direction in a patch, z >= 0. The map is uniform in
 * projected solid angle: the density per steradian is cosine / projected solid angle.
 * (0.5, 0.5) gives the centre. */
struct pp_vec3 pp_angle_basis_direction(const struct pp_angle_basis *basis, int patch,
                                        double u, double v);

/* The patch at the opposite azimuth. */
int pp_angle_basis_opposite(const struct pp_angle_basis *basis, int patch);

/* True if two different patches share an edge or a corner. */
bool pp_angle_basis_is_adjacent(const struct pp_angle_basis *basis, int a, int b);

#endif
