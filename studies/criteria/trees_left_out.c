/* trees_left_out.c - see trees_left_out.h. */
#include "studies/criteria/trees_left_out.h"

#include <math.h>

enum { RIM_POINTS = 72 };

/* Altitude of the highest point on the upper edge of a crown that is in front of the
 * opening; 0 if none is, or if the crown is below the horizon. */
static double crown_altitude(const struct pp_opening *opening,
                             const struct pp_tree *tree)
{
    struct pp_vec3 from = pp_polygon_middle(&opening->outer);
    double highest = 0.0;
    for (int i = 0; i < RIM_POINTS; i++) {
        double angle = 2.0 * PP_PI * i / RIM_POINTS, r = 0.5 * tree->crown_width_m;
        struct pp_vec3 at =
            pp_vec(tree->foot.x + r * cos(angle), tree->foot.y + r * sin(angle),
                   tree->foot.z + tree->height_m);
        struct pp_vec3 ray = pp_vec_sub(at, from);
        if (pp_vec_dot(ray, opening->outer.normal)
            < 0.0) /* the normal points inwards */
            highest = fmax(highest, atan2(ray.z, hypot(ray.x, ray.y)));
    }
    return highest;
}

bool pp_trees_left_out_find(struct pp_trees_left_out *trees,
                            const struct pp_assessment *assessment)
{
    const struct pp_world *world = assessment->room->world;
    *trees = (struct pp_trees_left_out){0};
    for (int i = 0; i < world->opening_count; i++)
        for (int k = 0; k < world->tree_count; k++) {
            double altitude = crown_altitude(&world->openings[i], &world->trees[k]);
            if (altitude > trees->altitude_rad) {
                trees->altitude_rad = altitude;
                trees->opening = &world->openings[i];
                trees->line = world->trees[k].line;
            }
        }
    for (int i = 0; i < assessment->answers.count && trees->opening; i++)
        if (assessment->answers.list[i].criterion->without_trees)
            trees->criteria[trees->count++] = assessment->answers.list[i].criterion;
    return trees->count > 0;
}
