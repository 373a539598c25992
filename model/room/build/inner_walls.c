/* inner_walls.c - see inner_walls.h. */
#include "model/room/build/inner_walls.h"

/* No thicker is a wall between two rooms; chosen, not measured. */
static const double thickest_m = 0.6;

static void find_said(struct pp_resolver *r)
{
    for (int i = 0; i < r->room->wall_kind_count; i++) {
        const struct pp_wall_part *part = &r->room->wall_kinds[i];
        int face = pp_resolve_wall(r, part->name, "wall", part->line);
        if (face < 0 || !part->is_inner)
            continue;
        r->world->surfaces[face].is_inner = true;
        for (int k = 0; k < r->world->opening_count; k++) {
            if (r->world->openings[k].face != face)
                continue;
            pp_mistakes_add(r->mistakes, part->line,
                            "wall: is said to be no outside wall, but has the opening "
                            "of line %d; expected none in it, or kind \"outer\"",
                            r->world->openings[k].line);
            break;
        }
    }
}

/* Is the other room's face turned to the wall, close behind its middle? */
static bool is_behind(const struct pp_polygon *wall, const struct pp_polygon *other)
{
    return pp_vec_dot(wall->normal, other->normal) < -0.5
           && pp_polygon_distance(other, pp_polygon_middle(wall)) <= thickest_m;
}

enum pp_status pp_build_inner_walls(struct pp_resolver *r, struct pp_error *err)
{
    struct pp_world *world = r->world;
    find_said(r);
    for (int i = 0; i < r->room->surface_count; i++) {
        const struct pp_surface_part *part = &r->room->surfaces[i];
        struct pp_polygon other;
        if (!part->is_room_outside)
            continue;
        if (pp_polygon_of(&other, part->vertices.list, part->vertices.count, err)
            != PP_OK)
            return PP_SYSTEM;
        for (int k = 0; k < world->face_count; k++) {
            struct pp_surface *wall = &world->surfaces[k];
            wall->is_inner |=
                wall->role == PP_WALL && is_behind(&wall->outline, &other);
        }
        pp_polygon_clear(&other);
    }
    return PP_OK;
}
