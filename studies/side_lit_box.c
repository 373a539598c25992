/* side_lit_box.c - see side_lit_box.h. */
#include "studies/side_lit_box.h"

#include <math.h>

#include "model/geometry/tolerance.h"

static bool is_level(const struct pp_polygon *polygon)
{
    return fabs(polygon->normal.z) > cos(PP_LEVEL_RAD);
}

/* Finds the window wall of a box-shaped room with windows in one wall. Returns NULL for
 * any other room, with the reason in *why. */
static const struct pp_surface *window_wall(const struct pp_world *world,
                                            const char **why)
{
    int floors = 0, ceilings = 0, rectangles = 0;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        floors += face->role == PP_FLOOR && is_level(&face->outline);
        ceilings += face->role == PP_CEILING && is_level(&face->outline);
        rectangles += face->outline.count == 4;
        for (int k = 0; k < face->outline.count; k++) {
            const struct pp_vec3 *v = face->outline.vertices;
            int n = face->outline.count;
            struct pp_vec3 a = pp_vec_sub(v[(k + 1) % n], v[k]);
            struct pp_vec3 b = pp_vec_sub(v[(k + 2) % n], v[(k + 1) % n]);
            rectangles -=
                fabs(pp_vec_dot(a, b)) > 1e-3 * pp_vec_length(a) * pp_vec_length(b);
        }
    }
    *why = world->face_count != 6 || floors != 1 || ceilings != 1 || rectangles != 6
               ? "the room is not a box"
           : world->opening_count == 0 ? "the room has no openings"
                                       : NULL;
    for (int i = 0; i < world->opening_count && !*why; i++) {
        if (world->surfaces[world->openings[i].face].role != PP_WALL)
            *why = "the room also has rooflights";
        else if (world->openings[i].face != world->openings[0].face)
            *why = "the room has windows in more than one wall";
    }
    return *why ? NULL : &world->surfaces[world->openings[0].face];
}

/* Extent of the room along a direction. *low is set to the lower end. */
static double room_extent_along(const struct pp_world *world, struct pp_vec3 along,
                                double *low)
{
    double high = -INFINITY;
    *low = INFINITY;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++) {
            double at = pp_vec_dot(world->surfaces[i].outline.vertices[k], along);
            *low = fmin(*low, at);
            high = fmax(high, at);
        }
    return high - *low;
}

bool pp_side_lit_box_of(struct pp_side_lit_box *box, const struct pp_world *world,
                        const char **why)
{
    const struct pp_surface *wall = window_wall(world, why);
    if (!wall)
        return false;
    struct pp_vec3 up = {0.0, 0.0, 1.0};
    double side;
    *box = (struct pp_side_lit_box){.into = wall->outline.normal, .head_z = -INFINITY};
    box->depth_m = room_extent_along(world, box->into, &box->front);
    box->width_m = room_extent_along(world, pp_vec_cross(up, box->into), &side);
    room_extent_along(world, up, &box->floor_z);
    for (int i = 0; i < world->opening_count; i++)
        for (int k = 0; k < world->openings[i].inner.count; k++)
            box->head_z = fmax(box->head_z, world->openings[i].inner.vertices[k].z);
    return true;
}
