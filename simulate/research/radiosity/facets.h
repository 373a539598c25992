/* facets.h - the surfaces and panes of a world for radiosity: plane facets with two
 * diffuse sides. Facets of the room are cut into convex pieces.
 *
 * A facet has the index of its surface; the facets of panes follow in the order of the
 * openings. The pane of an opening is at the position of its glass. The world places a
 * door or a dado slightly in front of its wall. Here, it replaces the piece of the wall
 * behind it, in the wall's plane, so that there is no gap. Positions are in the
 * coordinates of the world.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_FACETS_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_FACETS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/region.h"
#include "model/room/world.h"
#include "simulate/research/radiosity/ray_tree.h"

/* A side of a facet. Its index is twice the facet's index, plus 1 for the back. */
struct pp_facet_side {
    bool indoors;
    double reflectance, exitance; /* diffuse, over Eh; for clear glass, values of its
                                   * frame */
};

struct pp_facet {
    const struct pp_polygon
        *outline; /* outline in the world; the outline of a door or dado is moved into
                   * its wall's plane */
    struct pp_vec3 origin, a, b, normal; /* axes of its plane; a x b is the normal */
    struct pp_facet_side side[2]; /* front, which the normal points from, and back */
    const struct pp_opening *opening; /* opening of a pane; NULL: a surface */
    bool clear;                       /* a pane that is seen through */
    bool looks_out;                   /* a pane with no surface outdoors in front of
                                       * it */
    double through;          /* transmittance of a pane that scatters, 0 elsewhere */
    bool envelope;           /* one side is in the room, the other outdoors */
    struct pp_region region; /* in a and b from the origin, without openings, doors and
                              * dados; only for facets with a side in the room */
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
    struct pp_ray_tree *rays; /* tree of the triangles of all facets; the owners are the
                               * facets */
    struct pp_bounds3 room;   /* box around the pieces, or around everything */
    double reach_m;           /* from the room's middle to the farthest corner */
};

enum pp_status pp_facets_create(struct pp_facets **facets, const struct pp_world *world,
                                struct pp_error *err);
void pp_facets_destroy(struct pp_facets *facets); /* NULL is allowed */

/* Size of the first elements (m): 0.7 of the room's smallest dimension, or more if
 * there would otherwise be more than a thousand elements. */
double pp_facets_element_m(const struct pp_facets *facets);

/* Height (m) of a point above a facet's plane, positive on the side of the normal. */
static inline double pp_facet_height(const struct pp_facet *facet, struct pp_vec3 point)
{
    return pp_vec_dot(facet->normal, pp_vec_sub(point, facet->origin));
}

/* Fractions, 0 to 1, of light at this cosine of incidence that a clear pane transmits
 * without scattering, and that it reflects. */
double pp_facet_straight(const struct pp_facet *facet, double cosine);
double pp_facet_mirrored(const struct pp_facet *facet, double cosine);

#endif
