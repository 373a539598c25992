/* depth_rule.c - the rule of thumb that daylight reaches two and a half times as far
 * into a room as its windows stand above the working plane:
 *
 *   d <= 2.5 h
 *
 *   d  depth: from the window wall to what is farthest from it (m)
 *   h  height of the highest window head above the working plane (m)
 *
 * A rule of practice, not of a standard. There are many of its kind, most with a depth
 * of 1.5 to 2 times the head's height; [REI05] (of which a review only was seen) found
 * by simulation 1 to 2 with blinds and up to 2.5 without. 2.5 over the working plane is
 * our choice among them. It knows nothing of glass, width, reflectances or obstructions,
 * and is for rooms with windows in one upright wall; other rooms are not judged.
 */
#include <math.h>

#include "studies/criteria/criteria.h"
#include "model/geometry/tolerance.h"

#define DEPTHS_MOST 2.5

static const char title_of_ratio[] = "d/h";

/* The only wall with windows; NULL, and *why, where there is none such. */
static const struct pp_surface *window_wall(const struct pp_world *world,
                                            const char **why)
{
    *why = world->opening_count == 0 ? "the room has no openings" : NULL;
    for (int i = 0; i < world->opening_count && !*why; i++) {
        const struct pp_surface *face = &world->surfaces[world->openings[i].face];
        if (face->role != PP_WALL || fabs(face->outline.normal.z) > sin(PP_LEVEL_RAD))
            *why = "the room is not lit by upright walls alone";
        else if (world->openings[i].face != world->openings[0].face)
            *why = "the room has windows in more than one wall";
    }
    return *why ? NULL : &world->surfaces[world->openings[0].face];
}

/* How far the envelope reaches behind the wall's plane. */
static double depth_behind(const struct pp_world *world, const struct pp_polygon *wall)
{
    double depth = 0.0;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++) {
            struct pp_vec3 corner = world->surfaces[i].outline.vertices[k];
            depth = fmax(
                depth, pp_vec_dot(pp_vec_sub(corner, wall->vertices[0]), wall->normal));
        }
    return depth;
}

static enum pp_status evaluate(const struct pp_inquiry *inquiry,
                               struct pp_finding_list *findings, struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    const char *why;
    const struct pp_surface *wall = window_wall(world, &why);
    double head_z = -INFINITY;
    for (int i = 0; i < world->opening_count; i++)
        for (int k = 0; k < world->openings[i].inner.count; k++)
            head_z = fmax(head_z, world->openings[i].inner.vertices[k].z);
    double h = head_z - world->working_plane_m;
    if (wall && !(h > 0.0))
        why = "no window reaches above the working plane";
    if (why) {
        struct pp_finding finding = pp_finding_not_judged(why, title_of_ratio);
        return pp_finding_list_add(findings, &finding, err);
    }
    double d = depth_behind(world, &wall->outline);
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_RATIO, d / h, DEPTHS_MOST, true, title_of_ratio);
    pp_finding_note(&finding,
                    "a rule of thumb: d %.2f m, h %.2f m; at most %.2f m deep", d, h,
                    DEPTHS_MOST * h);
    return pp_finding_list_add(findings, &finding, err);
}

const struct pp_criterion pp_criterion_depth_rule = {
    .name = "depth-rule",
    .title = "Depth by rule of thumb",
    .source = "REI05",
    .summary = "depth is 2.5 times the window head above the working plane at most",
    .evaluate = evaluate,
};
