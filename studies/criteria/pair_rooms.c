/* pair_rooms.c - compares two rooms face by face and opening by opening. */
#include "studies/criteria/pair_rooms.h"

#include <math.h>
#include <stdlib.h>

/* Distance below which two corners count as the same; chosen, not measured. */
static const double same_m = 0.01;

/* True if b has the corners of a in the same order, whichever corner b begins with. */
static bool same_outline(const struct pp_polygon *a, const struct pp_polygon *b)
{
    if (a->count != b->count)
        return false;
    for (int shift = 0; shift < a->count; shift++) {
        int k = 0;
        while (k < a->count
               && pp_vec_length(
                      pp_vec_sub(a->vertices[k], b->vertices[(k + shift) % b->count]))
                      < same_m)
            k++;
        if (k == a->count)
            return true;
    }
    return false;
}

static enum pp_status check_faces(const struct pp_world *world,
                                  const struct pp_world *before, struct pp_error *err)
{
    if (world->face_count != before->face_count)
        return pp_fail(err, PP_BAD_INPUT,
                       "the room compared has %d faces, but this room has %d; "
                       "expected the same room with different surroundings",
                       before->face_count, world->face_count);
    for (int i = 0; i < world->face_count; i++) {
        bool found = false;
        for (int k = 0; k < before->face_count && !found; k++)
            found =
                same_outline(&world->surfaces[i].outline, &before->surfaces[k].outline);
        const char *name = world->surfaces[i].name;
        if (!found)
            return pp_fail(err, PP_BAD_INPUT,
                           "the room compared has a different shape: the %.60s has no "
                           "counterpart; "
                           "expected the same room with different surroundings",
                           name                                    ? name
                           : world->surfaces[i].role == PP_FLOOR   ? "floor"
                           : world->surfaces[i].role == PP_CEILING ? "ceiling"
                                                                   : "wall");
    }
    if (fabs(world->working_plane_m - before->working_plane_m) > same_m)
        return pp_fail(err, PP_BAD_INPUT,
                       "the working plane of the room compared is at %g m, that of "
                       "this room at %g m; expected the same room with different "
                       "surroundings",
                       before->working_plane_m, world->working_plane_m);
    return PP_OK;
}

static enum pp_status pair_openings(int *pairs, const struct pp_world *world,
                                    const struct pp_world *before, struct pp_error *err)
{
    if (world->opening_count != before->opening_count)
        return pp_fail(err, PP_BAD_INPUT,
                       "the room compared has %d opening%s, but this room has %d; "
                       "expected the same room with different surroundings",
                       before->opening_count, before->opening_count == 1 ? "" : "s",
                       world->opening_count);
    for (int i = 0; i < world->opening_count; i++) {
        pairs[i] = -1;
        for (int k = 0; k < before->opening_count && pairs[i] < 0; k++)
            if (same_outline(&world->openings[i].outer, &before->openings[k].outer)
                && same_outline(&world->openings[i].inner, &before->openings[k].inner))
                pairs[i] = k;
        if (pairs[i] < 0)
            return pp_fail(
                err, PP_BAD_INPUT,
                "the room compared has no opening in the place of the opening on line "
                "%d; "
                "expected the same room with different surroundings",
                world->openings[i].line);
    }
    return PP_OK;
}

enum pp_status pp_pair_rooms(int **pairs, const struct pp_world *world,
                             const struct pp_world *before, struct pp_error *err)
{
    *pairs = NULL;
    enum pp_status status = check_faces(world, before, err);
    if (status != PP_OK)
        return status;
    int *list = malloc(((size_t)world->opening_count + 1) * sizeof *list);
    if (!list)
        return pp_fail_memory(err);
    status = pair_openings(list, world, before, err);
    if (status == PP_OK)
        *pairs = list;
    else
        free(list);
    return status;
}
