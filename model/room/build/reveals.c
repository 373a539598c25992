/* reveals.c - see reveals.h. */
#include "model/room/build/reveals.h"

#include "model/room/position.h"

/* Larger depths are reported as probable typing errors. */
static const double reveal_most_m = 10.0;

/* Adds the surfaces of the reveal, one per edge of the opening's outline, facing
 * inwards. */
static enum pp_status add_reveals(struct pp_resolver *r, int index,
                                  struct pp_error *err)
{
    const struct pp_opening *opening = &r->world->openings[index];
    const struct pp_surface *wall = &r->world->surfaces[opening->face];
    struct pp_surface side = {.role = PP_REVEAL,
                              .inside = true,
                              .front = wall->front,
                              .back = wall->back,
                              .finish = wall->finish,
                              .owner = index,
                              .line = opening->line};
    int count = opening->inner.count;
    for (int i = 0; i < count; i++) {
        int next = (i + 1) % count;
        struct pp_vec3 quad[4] = {
            opening->inner.vertices[i], opening->inner.vertices[next],
            opening->outer.vertices[next], opening->outer.vertices[i]};
        if (pp_resolve_add_face(r, side, quad, 4, err) != PP_OK)
            return PP_SYSTEM;
    }
    return PP_OK;
}

/* Reports a reveal that is too deep, or that would put the glass in another part of the
 * room. */
static void check_reveal(struct pp_resolver *r, const struct pp_opening *opening)
{
    if (opening->reveal_m > reveal_most_m)
        pp_mistakes_add(r->mistakes, opening->line,
                        "reveal: is %g m deep; expected at most %g m",
                        opening->reveal_m, reveal_most_m);
    if (!r->watertight)
        return;
    for (int i = 0; i <= opening->outer.count; i++) {
        struct pp_vec3 point = i < opening->outer.count
                                   ? opening->outer.vertices[i]
                                   : pp_polygon_middle(&opening->outer);
        if (!pp_position_in_room(r->world, point))
            continue;
        pp_mistakes_add(r->mistakes, opening->line,
                        "reveal: is %g m deep, which puts the glass inside another "
                        "part of the room, at (%g, %g, %g); expected the glass outside",
                        opening->reveal_m, point.x, point.y, point.z);
        return;
    }
}

enum pp_status pp_build_reveals(struct pp_resolver *r, struct pp_error *err)
{
    for (int i = 0; i < r->world->opening_count; i++) {
        const struct pp_opening *opening = &r->world->openings[i];
        if (!(opening->reveal_m > 0.0))
            continue;
        check_reveal(r, opening);
        if (add_reveals(r, i, err) != PP_OK)
            return PP_SYSTEM;
    }
    return PP_OK;
}
