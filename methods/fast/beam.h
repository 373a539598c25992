/* beam.h - parallel light through an opening on to the working plane.
 *
 * Light from a direction u reaches the plane through a part of the opening, which is
 * found by plane geometry: the opening's outlines, the plane and all obstructions
 * inside and outside are projected along u on to the opening's face. For a luminance
 * that depends only on direction, the mean over the plane is an integral over
 * directions
 *
 *     1/A integral over A of integral L(u) (n.u) domega dA
 *         = 1/A integral L(u) (w.u) a(u) domega
 *
 * where a(u) is the area of the part that transmits and w the opening's normal.
 * Polygons in space are clipped once for each opening and plane. Each direction then
 * needs only clipping in the face's plane.
 *
 * The conventions are those of visible.h: obstructions inside remove light,
 * obstructions outside add light by their reflectance and exitance, and the nearest
 * obstruction counts.
 */
#ifndef PP_METHODS_FAST_BEAM_H
#define PP_METHODS_FAST_BEAM_H

#include "methods/view/fragments.h"
#include "model/room/world.h"

struct pp_beam;

/* Working memory of one thread for areas. Must be all zero at first; cleared by the
 * caller. */
struct pp_beam_space {
    struct pp_fragments open, cut;
    double (*xy)[2];
    struct pp_fragment_ring *rings;
    double (*lights)[2]; /* reflectance and exitance of the rings */
    /* Number of ring-fragment comparisons so far, in all directions. The comparisons
     * take nearly all of the computing time. Once the number exceeds work_budget (0:
     * unlimited), no more areas are calculated. */
    long long work, work_budget;
};

/* Parts of the opening in the face's plane, m2. */
struct pp_beam_areas {
    double sky;
    double reflecting; /* sum over obstructions of area times reflectance */
    double emitting;   /* sum over obstructions of area times exitance */
};

/* Creates a beam, which refers to world. On success the caller destroys *beam.
 * with_outside false: without obstructions and skylines. */
enum pp_status pp_beam_create(struct pp_beam **beam, const struct pp_world *world,
                              const struct pp_opening *opening, bool with_outside,
                              struct pp_error *err);
void pp_beam_destroy(struct pp_beam *beam); /* NULL is allowed */

/* Areas for the direction u, a unit vector from the plane to the light: upwards and out
 * through the opening. Several threads may use one beam. */
enum pp_status pp_beam_areas(struct pp_beam_areas *areas, const struct pp_beam *beam,
                             struct pp_beam_space *space, struct pp_vec3 u,
                             struct pp_error *err);

/* True once the work has exceeded its budget. */
bool pp_beam_budget_exhausted(const struct pp_beam_space *space);

void pp_beam_space_clear(struct pp_beam_space *space);

#endif
