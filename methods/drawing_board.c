/* drawing_board.c - see drawing_board.h. */
#include "methods/drawing_board.h"

enum pp_status pp_drawing_board_check(const struct pp_method *method,
                                      const struct pp_world *world,
                                      const struct pp_receiver *receiver,
                                      struct pp_error *err)
{
    const char *why = method->refuses_room(world, receiver);
    if (why)
        return pp_fail(err, PP_BAD_INPUT, "%s: %s", method->name, why);
    for (int i = 0; i < world->opening_count; i++) {
        why = method->refuses(world, &world->openings[i], receiver);
        if (why)
            return pp_fail(err, PP_BAD_INPUT, "%s: the opening on line %d %s",
                           method->name, world->openings[i].line, why);
    }
    return PP_OK;
}

static bool alike(const struct pp_opening *a, const struct pp_opening *b)
{
    struct pp_vec3 off = pp_vec_sub(a->inner.normal, b->inner.normal);
    return pp_vec_dot(off, off) < 1e-12 && (a->glass.panes > 0) == (b->glass.panes > 0);
}

int pp_drawing_board_first_alike(const struct pp_world *world, int index)
{
    int first = 0;
    while (first < index && !alike(&world->openings[first], &world->openings[index]))
        first++;
    return first;
}

int pp_drawing_board_count_alike(const struct pp_world *world, int first)
{
    int count = 0;
    for (int i = first; i < world->opening_count; i++)
        count += pp_drawing_board_first_alike(world, i) == first;
    return count;
}

int pp_drawing_board_diagram_count(const struct pp_world *world)
{
    int count = 0;
    for (int i = 0; i < world->opening_count; i++)
        count += pp_drawing_board_first_alike(world, i) == i;
    return count;
}
