/* facets.h - the surfaces and panes of a world for radiosity: plane facets with two
 * diffuse sides. Facets in the room are cut into convex pieces.
 *
 * A facet has the index of its surface; the facets of panes follow in the order of the
 * openings. The pane of an opening is at the position of its glass. A door or a dado,
 * which the world places slightly in front of its wall, replaces that piece of the wall
 * in the wall's plane, so that there is no gap. Positions are the world's.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_FACETS_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_FACETS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/region.h"
#include "model/room/world.h"
#include "simulate/research/radiosity/ray_tree.h"

/* A side of a facet, by an index: twice its facet's, one more for the back. */
struct pp_facet_side {
    bool indoors;
    double reflectance, exitance; /* diffuse, over Eh; for clear glass those of its
                                   * frame */
};

struct pp_facet {
    const struct pp_polygon
        *outline; /* the world's; that of a cover is moved into its wall's plane */
    struct pp_vec3 origin, a, b, normal; /* axes in its plane; a x b is the normal */
    struct pp_facet_side side[2]; /* front, which the normal points from, and back */
    const struct pp_opening *opening; /* opening of a pane; NULL: a surface */
    bool clear;                       /* a pane that is seen through */
    bool looks_out;                   /* a pane with no surface in front of it
                                       * outdoors */
    double through;          /* transmittance of a pane that scatters, 0 elsewhere */
    bool envelope;           /* one side is in the room, the other outdoors */
    struct pp_region region; /* in a and b from the origin, without openings and covers;
                                * of facets with a side in the room only */
    int first_piece, piece_count;
};

/* A convex polygon, counter-clockwise seen against its facet's normal. */
struct pp_piece {
    int facet, first_corner, count;
};

struct pp_facets {
    const struct pp_world *world; /* not owned */
    struct pp_facet *list;
    int count;
    struct pp_piece *pieces; /* pieces of facets with a side in the room, in order of
                              * the facets */
    int piece_count;
    struct pp_vec3 *corners; /* corners of pieces */
    int corner_count, corner_room;
    struct pp_ray_tree *rays; /* tree of all facets, which are the owners */
    struct pp_bounds3 room;   /* round the pieces, or round everything */
    double reach_m;           /* from the room's middle to the farthest corner */
};

enum pp_status pp_facets_create(struct pp_facets **facets, const struct pp_world *world,
                                struct pp_error *err);
void pp_facets_destroy(struct pp_facets *facets); /* NULL is allowed */

/* Size of the first elements (m): about the width or height of the room at most, unless
 * that gives more than a thousand. */
double pp_facets_element_m(const struct pp_facets *facets);

/* Height of a point over a facet's plane, on the side that its normal points to, m. */
static inline double pp_facet_height(const struct pp_facet *facet, struct pp_vec3 point)
{
    return pp_vec_dot(facet->normal, pp_vec_sub(point, facet->origin));
}

/* Shares, 0 to 1, of light at this cosine of incidence that a clear pane transmits
 * without scattering, and that it reflects. */
double pp_facet_straight(const struct pp_facet *facet, double cosine);
double pp_facet_mirrored(const struct pp_facet *facet, double cosine);

#endif
