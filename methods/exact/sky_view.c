/* sky_view.c - cuts views by a grid of equal angles, and tests whether the sun in a
 * given direction is visible. */
#include "methods/exact/sky_view.h"

#include <math.h>
#include <stdlib.h>

#include "methods/exact/half_space_clip.h"
#include "methods/exact/solid_angle.h"
#include "model/room/surface_materials.h"

/* One of the functions of methods/view/visible.h. */
typedef enum pp_status see_through(struct pp_visible *visible,
                                   const struct pp_world *world,
                                   const struct pp_opening *opening, struct pp_vec3 eye,
                                   struct pp_error *err);

static enum pp_status find_views(struct pp_sky_view *view, const struct pp_world *world,
                                 const struct pp_receiver *receiver, see_through *see,
                                 struct pp_error *err)
{
    *view = (struct pp_sky_view){.world = world, .normal = receiver->normal};
    view->visible = calloc((size_t)world->opening_count + 1, sizeof *view->visible);
    if (!view->visible)
        return pp_fail_memory(err);
    for (int i = 0; i < world->opening_count; i++) {
        if (world->openings[i].glass.diffusing)
            continue;
        enum pp_status status =
            see(&view->visible[i], world, &world->openings[i], receiver->position, err);
        if (status != PP_OK) {
            view->visible[i] = (struct pp_visible){.patch_count = 0};
            pp_sky_view_clear(view);
            return status;
        }
    }
    return PP_OK;
}

enum pp_status pp_sky_view_init(struct pp_sky_view *view, const struct pp_world *world,
                                const struct pp_receiver *receiver,
                                struct pp_error *err)
{
    return find_views(view, world, receiver, pp_visible_through, err);
}

enum pp_status pp_sky_view_init_for_sun(struct pp_sky_view *view,
                                        const struct pp_world *world,
                                        const struct pp_receiver *receiver,
                                        struct pp_error *err)
{
    return find_views(view, world, receiver, pp_visible_sky, err);
}

void pp_sky_view_clear(struct pp_sky_view *view)
{
    for (int i = 0; view->visible && i < view->world->opening_count; i++)
        pp_visible_clear(&view->visible[i]);
    free(view->visible);
    view->visible = NULL;
}

/* ---- pieces ---- */

enum { CORNERS_MOST = 48, RING_MOST = 256 };

/* The part of a ring in a cell, and the sum of the directions of its corners. */
struct cell_ring {
    int count;
    struct pp_vec3 corners[CORNERS_MOST], sum;
};

static void take_corner(void *data, struct pp_vec3 corner)
{
    struct cell_ring *ring = data;
    if (ring->count == CORNERS_MOST)
        return;
    ring->corners[ring->count++] = corner;
    ring->sum = pp_vec_add(ring->sum, pp_vec_unit(corner));
}

/* A patch of a view that shows sky and ground, and the side of the horizon to add. */
struct piece_task {
    const struct pp_sky_view *view;
    const struct pp_visible *visible;
    const struct pp_visible_patch *patch;
    int opening;
    bool ground;
    pp_sky_view_sink *sink;
    void *data;
};

/* The half-space of directions that lie beyond x (or y) = tan angle in the view,
 * towards larger values for side 1, smaller ones for side -1. */
static struct pp_vec3 beyond(const struct pp_projection *view, bool upright,
                             double angle, double side)
{
    double c = side * cos(angle), s = -side * sin(angle);
    return pp_projection_to_room(view, upright ? pp_vec(0.0, c, s) : pp_vec(c, 0.0, s));
}

static void add_piece(const struct piece_task *task, const double x[2],
                      const double y[2])
{
    const struct pp_projection *view = &task->visible->view;
    struct pp_vec3 limits[PP_HALF_SPACES_MOST];
    int limit_count = 0;
    limits[limit_count++] = beyond(view, false, x[0], 1.0);
    limits[limit_count++] = beyond(view, false, x[1], -1.0);
    limits[limit_count++] = beyond(view, true, y[0], 1.0);
    limits[limit_count++] = beyond(view, true, y[1], -1.0);
    limits[limit_count++] = task->view->normal;
    limits[limit_count++] = pp_vec(0.0, 0.0, task->ground ? -1.0 : 1.0);
    for (int i = 0; i < task->patch->half_space_count; i++)
        limits[limit_count++] = task->patch->half_spaces[i];

    struct pp_moments moments = {0};
    struct pp_sky_piece piece = {.opening = task->opening, .ground = task->ground};
    for (int r = 0; r < task->patch->region.count; r++) {
        const struct pp_ring *ring = &task->patch->region.rings[r];
        struct pp_vec3 corners[RING_MOST];
        struct cell_ring cut = {.count = 0};
        int count = ring->count < RING_MOST ? ring->count : RING_MOST;
        for (int i = 0; i < count; i++)
            corners[i] = pp_projection_to_room(
                view, pp_vec(ring->xy[i][0], ring->xy[i][1], view->distance_m));
        pp_half_space_clip(corners, count, limits, limit_count, take_corner, &cut);
        if (cut.count < 3)
            continue;
        pp_solid_angle_add_moments(&moments, cut.corners, cut.count, task->view->normal,
                                   NULL, 0);
        piece.u = pp_vec_add(piece.u, cut.sum);
    }
    if (!(moments.cosine > 0.0))
        return;
    piece.u = pp_vec_unit(piece.u);
    piece.coefficient =
        moments.cosine
        * pp_surface_materials_pane_from(&task->view->world->openings[task->opening],
                                         piece.u, pp_vec_dot(piece.u, view->toward));
    task->sink(task->data, &piece);
}

static void add_patch_pieces(const struct piece_task *task, double size_rad)
{
    double D = task->visible->view.distance_m;
    struct pp_bounds2 bounds = pp_region_bounds(&task->patch->region);
    double low[2], step[2];
    int count[2];
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = atan(bounds.low[axis] / D);
        double extent = atan(bounds.high[axis] / D) - low[axis];
        count[axis] = (int)fmax(1.0, ceil(extent / size_rad));
        step[axis] = extent / count[axis];
    }
    for (int j = 0; j < count[1]; j++)
        for (int i = 0; i < count[0]; i++) {
            const double x[2] = {low[0] + step[0] * i, low[0] + step[0] * (i + 1)};
            const double y[2] = {low[1] + step[1] * j, low[1] + step[1] * (j + 1)};
            add_piece(task, x, y);
        }
}

enum pp_status pp_sky_view_pieces(const struct pp_sky_view *view, double size_rad,
                                  pp_sky_view_sink *sink, void *data,
                                  struct pp_error *err)
{
    for (int i = 0; i < view->world->opening_count; i++) {
        const struct pp_visible *visible = &view->visible[i];
        for (int k = 0; k < visible->patch_count; k++) {
            const struct pp_visible_patch *patch = &visible->patches[k];
            for (int r = 0; r < patch->region.count; r++)
                if (patch->region.rings[r].count > RING_MOST)
                    return pp_fail(err, PP_BAD_INPUT,
                                   "the outline of the sky seen through an opening has "
                                   "%d corners; expected at most %d",
                                   patch->region.rings[r].count, RING_MOST);
            if (patch->hidden)
                continue;
            struct piece_task task = {view, visible, patch, i, false, sink, data};
            add_patch_pieces(&task, size_rad);
            task.ground = true;
            if (view->world->ground_is_open && view->normal.z < 1.0)
                add_patch_pieces(&task, size_rad);
        }
    }
    return PP_OK;
}

/* ---- the sun ---- */

static bool shows(const struct pp_visible_patch *patch,
                  const struct pp_projection *view, struct pp_vec3 own,
                  struct pp_vec3 u)
{
    if (patch->hidden)
        return false;
    for (int i = 0; i < patch->half_space_count; i++)
        if (!(pp_vec_dot(patch->half_spaces[i], u) > 0.0))
            return false;
    double scale = view->distance_m / own.z;
    return pp_region_contains(&patch->region, own.x * scale, own.y * scale);
}

double pp_sky_view_sun(const struct pp_sky_view *view, struct pp_vec3 u, int *opening)
{
    double cosine = pp_vec_dot(view->normal, u);
    if (!(cosine > 0.0) || !(u.z > 0.0))
        return 0.0;
    for (int i = 0; i < view->world->opening_count; i++) {
        const struct pp_visible *visible = &view->visible[i];
        if (visible->patch_count == 0)
            continue;
        struct pp_vec3 own = pp_projection_direction(&visible->view, u);
        if (!(own.z > 0.0))
            continue;
        for (int k = 0; k < visible->patch_count; k++)
            if (shows(&visible->patches[k], &visible->view, own, u)) {
                if (opening)
                    *opening = i;
                return cosine
                       * pp_surface_materials_pane_sun(&view->world->openings[i], u,
                                                       own.z);
            }
    }
    return 0.0;
}
