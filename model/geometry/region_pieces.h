/* region_pieces.h - a plane figure in space, as outlines without holes. */
#ifndef PP_MODEL_GEOMETRY_REGION_PIECES_H
#define PP_MODEL_GEOMETRY_REGION_PIECES_H

#include "model/geometry/clipper.h"
#include "model/geometry/vec.h"

/* Outlines that cover exactly the figure. */
struct pp_region_pieces {
    struct pp_region_piece {
        int count;
        struct pp_vec3 *corners; /* counter-clockwise in (along, up) */
    } * list;
    int count;
};

/* Divides the figure, given in the orthogonal unit axes along and up from the origin. A
 * ring without holes is one piece; others become triangles. Pieces smaller than
 * least_m2 are left out. The caller clears *pieces in any case. */
enum pp_status pp_region_pieces_cut(struct pp_region_pieces *pieces,
                                    const struct pp_region *figure,
                                    struct pp_vec3 origin, struct pp_vec3 along,
                                    struct pp_vec3 up, double least_m2,
                                    struct pp_clipper *clipper, struct pp_error *err);
void pp_region_pieces_clear(struct pp_region_pieces *pieces);

#endif
