/* diagram_windows.c - groups the windows of a room by orientation and glass, and begins
 * their entries on a sheet. */
#include "methods/diagram_windows.h"

#include <stdlib.h>

enum pp_status pp_diagram_windows_check(const struct pp_method *method,
                                        const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        const struct pp_receiver *receiver,
                                        struct pp_error *err)
{
    const char *why = pp_method_refuses_room(method, world, light, receiver);
    if (why)
        return pp_fail(err, PP_BAD_INPUT, "%s: %s", method->name, why);
    for (int i = 0; i < world->opening_count; i++) {
        why = pp_method_refuses_opening(method, world, light, &world->openings[i],
                                        receiver);
        if (why)
            return pp_fail(err, PP_BAD_INPUT, "%s: %s %s %s", method->name,
                           pp_world_kind(world, world->openings[i].line),
                           world->openings[i].label, why);
    }
    return PP_OK;
}

static bool share_diagram(const struct pp_opening *a, const struct pp_opening *b)
{
    struct pp_vec3 off = pp_vec_sub(a->inner.normal, b->inner.normal);
    return pp_vec_dot(off, off) < 1e-12 && (a->glass.panes > 0) == (b->glass.panes > 0);
}

int pp_diagram_windows_first_alike(const struct pp_world *world, int index)
{
    int first = 0;
    while (first < index
           && !share_diagram(&world->openings[first], &world->openings[index]))
        first++;
    return first;
}

int pp_diagram_windows_count_alike(const struct pp_world *world, int first)
{
    int count = 0;
    for (int i = first; i < world->opening_count; i++)
        count += pp_diagram_windows_first_alike(world, i) == first;
    return count;
}

int pp_diagram_windows_diagram_count(const struct pp_world *world)
{
    int count = 0;
    for (int i = 0; i < world->opening_count; i++)
        count += pp_diagram_windows_first_alike(world, i) == i;
    return count;
}

struct pp_board_face pp_diagram_windows_face(const struct pp_world *world,
                                             const struct pp_opening *opening)
{
    const struct pp_surface *face = &world->surfaces[opening->face];
    return (struct pp_board_face){face->name, face->role == PP_CEILING};
}

enum pp_status pp_diagram_windows_begin(struct pp_board_window *window,
                                        struct pp_window_drawing *drawing,
                                        const struct pp_method *method,
                                        const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        const struct pp_opening *opening,
                                        struct pp_vec3 point, struct pp_error *err)
{
    window->label = opening->label;
    window->allowance = pp_allowance_of(method, world, opening);
    enum pp_status status =
        pp_window_drawing_init(drawing, world, light, opening, point, err);
    if (status != PP_OK)
        return status;
    window->distance_m = drawing->distance_m;
    window->pieces = calloc((size_t)drawing->count + 1, sizeof *window->pieces);
    if (window->pieces)
        return PP_OK;
    pp_window_drawing_clear(drawing);
    return pp_fail_memory(err);
}
