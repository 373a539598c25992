/* sheets.h - the surfaces and panes of a world as radiosity has them: plane sheets with two
 * matt sides, those in the room cut into convex pieces.
 *
 * A sheet's index is its surface's; those of panes follow, in the order of the openings.
 * The pane of an opening is where its glass stands. Positions are the world's.
 */
#ifndef PP_SIMULATE_ELEMENTS_SHEETS_H
#define PP_SIMULATE_ELEMENTS_SHEETS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/region.h"
#include "model/room/world.h"
#include "simulate/elements/ray_tree.h"

/* A side of a sheet, by an index: twice its sheet's, one more for the back. */
struct pp_sheet_side {
    bool indoors;
    double reflectance, exitance; /* diffuse, over Eh; of clear glass its frame's */
};

struct pp_sheet {
    struct pp_vec3 origin, a, b, normal; /* axes in its plane; a x b is the normal */
    struct pp_sheet_side side[2]; /* front, which the normal points from, and back */
    const struct pp_opening *opening; /* of a pane; NULL: a surface */
    bool clear;                       /* a pane that is seen through */
    double through;          /* transmittance of a pane that scatters, 0 elsewhere */
    bool envelope;           /* is one side in the room and the other outdoors? */
    struct pp_region region; /* in a and b from the origin, without openings; of sheets
                                * with a side in the room only */
    int first_piece, piece_count;
};

/* A convex polygon, counter-clockwise seen against its sheet's normal. */
struct pp_piece {
    int sheet, first_corner, count;
};

struct pp_sheets {
    const struct pp_world *world; /* not owned */
    struct pp_sheet *list;
    int count;
    struct pp_piece *pieces; /* of sheets with a side in the room, in their order */
    int piece_count;
    struct pp_vec3 *corners; /* of pieces */
    int corner_count, corner_room;
    struct pp_ray_tree *rays; /* of all sheets, which are the owners */
    struct pp_bounds3 room;   /* round the pieces, or round everything */
    double reach_m;           /* from the room's middle to the farthest corner */
};

enum pp_status pp_sheets_create(struct pp_sheets **sheets, const struct pp_world *world,
                                struct pp_error *err);
void pp_sheets_destroy(struct pp_sheets *sheets); /* NULL is allowed */

/* Height of a point over a sheet's plane, on the side that its normal points to, m. */
static inline double pp_sheet_height(const struct pp_sheet *sheet, struct pp_vec3 point)
{
    return pp_vec_dot(sheet->normal, pp_vec_sub(point, sheet->origin));
}

/* The share of the light at this cosine of incidence that goes straight through a clear
 * pane, and that it mirrors. */
double pp_sheet_straight(const struct pp_sheet *sheet, double cosine);
double pp_sheet_mirrored(const struct pp_sheet *sheet, double cosine);

#endif
