/* region_pieces.h - divides a plane region in space into outlines without holes. */
#ifndef PP_MODEL_GEOMETRY_REGION_PIECES_H
#define PP_MODEL_GEOMETRY_REGION_PIECES_H

#include "model/geometry/clipper.h"
#include "model/geometry/vec.h"

/* Outlines that together cover exactly the region. */
struct pp_region_pieces {
    struct pp_region_piece {
        int count;
        struct pp_vec3 *corners; /* counter-clockwise in (along, up) */
    } * list;
    int count;
};

/* Divides the region, given in the orthogonal unit axes `along` and `up` from `origin`.
 * A ring without holes is one piece; a ring with holes becomes triangles. Pieces
 * smaller than least_m2 are left out. The caller clears *pieces in any case. */
enum pp_status pp_region_pieces_cut(struct pp_region_pieces *pieces,
                                    const struct pp_region *figure,
                                    struct pp_vec3 origin, struct pp_vec3 along,
                                    struct pp_vec3 up, double least_m2,
                                    struct pp_clipper *clipper, struct pp_error *err);
void pp_region_pieces_clear(struct pp_region_pieces *pieces);

#endif
