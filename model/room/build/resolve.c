/* resolve.c - see resolve.h. */
#include "model/room/build/resolve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"
#include "model/geometry/tolerance.h"

static const double corner_pairs_most = 3e8;

bool pp_resolve_is_comparable(const struct pp_room *room)
{
    double faces = 6.0 * room->plan.vertices.count + 24.0, openings = 0.0,
           surfaces = 0.0;
    openings += 4.0 * room->cover_count;
    for (int i = 0; i < room->plan.face_count; i++)
        faces += room->plan.faces[i].vertices.count;
    for (int i = 0; i < room->opening_count; i++)
        openings += 4.0 + room->openings[i].vertices.count;
    for (int i = 0; i < room->surface_count; i++)
        surfaces += 4.0 * room->surfaces[i].vertices.count;
    double others = openings + surfaces + 8.0 * room->block_count + room->finish_count
                    + room->skyline_count + 8.0 * room->facade_count;
    return faces * (faces + others) + openings * openings <= corner_pairs_most;
}

int pp_resolve_wall_index(struct pp_resolver *r, const char *name, const char *what,
                          int line)
{
    if (!name)
        return -1;
    for (int i = 0; i < r->wall_count; i++)
        if (strcmp(r->walls[i], name) == 0)
            return i;
    /* A room without a plan has been reported already, and thousands of unknown names
     * are not worth reporting. */
    if (r->wall_count == 0 || r->unknown_walls++ > PP_MISTAKES_MOST)
        return -1;

    char typed[64], names[256], question[256] = "";
    const char *const *walls = (const char *const *)r->walls;
    pp_text_append_nearest(question, sizeof question, name, walls, r->wall_count);
    pp_mistakes_add(r->mistakes, line, "%s: there is no wall \"%s\"; expected %s%s",
                    what, pp_text_excerpt(typed, sizeof typed, name),
                    pp_text_list_names(names, sizeof names, walls, r->wall_count),
                    question);
    return -1;
}

int pp_resolve_wall(struct pp_resolver *r, const char *name, const char *what, int line)
{
    int index = pp_resolve_wall_index(r, name, what, line);
    return index < 0 ? -1 : r->wall_faces[index];
}

int pp_resolve_window_face(struct pp_resolver *r, const char *name, int line)
{
    const struct pp_world *world = r->world;
    for (int i = 0; name && i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        if (face->role == PP_CEILING && face->name && strcmp(face->name, name) == 0
            && hypot(face->outline.normal.x, face->outline.normal.y) > PP_SAME_M)
            return i;
    }
    return pp_resolve_wall(r, name, "window", line);
}

enum pp_status pp_resolve_add_surface(struct pp_resolver *r, struct pp_surface *surface,
                                      struct pp_error *err)
{
    struct pp_world *world = r->world;
    char *name = surface->name ? strdup(surface->name) : NULL;
    bool named = !surface->name == !name;
    surface->name = name;
    if (!named
        || pp_array_reserve(&world->surfaces, &r->surface_space,
                            world->surface_count + 1, sizeof *world->surfaces, NULL)
               != PP_OK) {
        free(name);
        pp_polygon_clear(&surface->outline);
        return pp_fail_memory(err);
    }
    world->surfaces[world->surface_count++] = *surface;
    return PP_OK;
}

enum pp_status pp_resolve_add_face(struct pp_resolver *r, struct pp_surface surface,
                                   const struct pp_vec3 *vertices, int count,
                                   struct pp_error *err)
{
    if (pp_polygon_of(&surface.outline, vertices, count, err) != PP_OK)
        return PP_SYSTEM;
    return pp_resolve_add_surface(r, &surface, err);
}
