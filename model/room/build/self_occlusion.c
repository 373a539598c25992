/* self_occlusion.c - holds the corners of openings against the planes of faces, and those of faces
 * against the planes of glass. */
#include "model/room/build/self_occlusion.h"

static void find_self_occlusion(struct pp_opening *opening,
                                const struct pp_world *world)
{
    opening->faces_open_in = opening->faces_open_out = true;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        opening->faces_open_in &= pp_polygon_is_before(&opening->inner, face);
        opening->faces_open_out &= pp_polygon_is_before(face, &opening->outer);
    }
}

enum pp_status pp_build_self_occlusion(struct pp_resolver *r, struct pp_error *err)
{
    (void)err;
    struct pp_world *world = r->world;
    for (int i = 0; i < world->opening_count; i++)
        find_self_occlusion(&world->openings[i], world);
    world->is_empty = true;
    for (int i = 0; i < world->surface_count; i++)
        world->is_empty &=
            !(world->surfaces[i].inside && world->surfaces[i].role == PP_FREE_SURFACE);
    return PP_OK;
}
