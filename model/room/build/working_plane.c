/* working_plane.c - see working_plane.h. */
#include "model/room/build/working_plane.h"

#include "model/room/section.h"

enum pp_status pp_build_working_plane(struct pp_resolver *r, struct pp_error *err)
{
    struct pp_world *world = r->world;
    double z = r->room->working_plane_m;
    world->working_plane_m = z;
    if (!r->watertight || !isfinite(z))
        return PP_OK;

    double low = INFINITY;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++)
            low = fmin(low, world->surfaces[i].outline.vertices[k].z);
    if (!(z >= low) || !(z < world->height_m)) {
        int line = r->room->working_plane_line;
        pp_mistakes_add(
            r->mistakes, line ? line : r->room->line,
            "working-plane: its height is %g m%s; expected it from the room's "
            "floor at %g m up to below its top at %g m",
            z, line ? "" : ", since none is given", low, world->height_m);
        return PP_OK;
    }

    return pp_section_cut(&world->plane, world, r->corners, z, err);
}
