/* sights.c - holds the corners of openings against the planes of faces, and those of faces
 * against the planes of glass. */
#include "model/room/build/sights.h"

static const double tolerance_m = 1e-9;

static double depth_m(struct pp_vec3 point, struct pp_vec3 origin,
                      struct pp_vec3 normal)
{
    return pp_vec_dot(pp_vec_sub(point, origin), normal);
}

/* Is the whole polygon before the plane through origin, or in it? */
static bool is_before(const struct pp_polygon *polygon, struct pp_vec3 origin,
                      struct pp_vec3 normal)
{
    for (int i = 0; i < polygon->count; i++)
        if (depth_m(polygon->vertices[i], origin, normal) < -tolerance_m)
            return false;
    return true;
}

static bool is_in(const struct pp_polygon *polygon, struct pp_vec3 origin,
                  struct pp_vec3 normal)
{
    return is_before(polygon, origin, normal)
           && is_before(polygon, origin, pp_vec_scale(normal, -1.0));
}

static void find_sights(struct pp_opening *opening, const struct pp_world *world)
{
    struct pp_vec3 glass = opening->outer.vertices[0], in = opening->inner.normal;
    opening->faces_open_in = opening->faces_open_out = true;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        opening->faces_open_in &=
            is_before(&opening->inner, face->vertices[0], face->normal);
        opening->faces_open_out &=
            i == opening->face
            || (is_before(face, glass, in) && !is_in(face, glass, in));
    }
}

enum pp_status pp_build_sights(struct pp_resolver *r, struct pp_error *err)
{
    (void)err;
    struct pp_world *world = r->world;
    for (int i = 0; i < world->opening_count; i++)
        find_sights(&world->openings[i], world);
    world->is_empty = true;
    for (int i = 0; i < world->surface_count; i++)
        world->is_empty &=
            !(world->surfaces[i].inside && world->surfaces[i].role == PP_FREE_SURFACE);
    return PP_OK;
}
