/* surface_pattern.c - see surface_pattern.h. */
#include "model/expression/surface_pattern.h"

#include <math.h>
#include <stdio.h>

bool pp_surface_pattern_parse(struct pp_surface_pattern *pattern, const char *text,
                              struct pp_expression_mistake *mistake)
{
    static const struct pp_expression_name names[] = {
        {"x", {.number = true}}, {"y", {.number = true}}, {"z", {.number = true}}};
    if (!pp_expression_parse(&pattern->expression, text, 0, names, 3, mistake))
        return false;
    snprintf(pattern->text, sizeof pattern->text, "%s", text);
    return true;
}

double pp_surface_pattern_at(const struct pp_surface_pattern *pattern,
                             struct pp_vec3 point, struct pp_expression_fault *fault)
{
    const double values[] = {point.x, point.y, point.z};
    return pp_expression_value(&pattern->expression, values, fault);
}

/* Length of a step for slopes, m. */
static const double STEP_M = 1e-5;

struct pp_vec3 pp_surface_pattern_slope(const struct pp_surface_pattern *height,
                                        struct pp_vec3 point, struct pp_vec3 normal,
                                        struct pp_expression_fault *fault)
{
    const struct pp_vec3 axes[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    double here = pp_surface_pattern_at(height, point, fault);
    struct pp_vec3 gradient = {0.0, 0.0, 0.0};
    for (int i = 0; i < 3; i++) {
        struct pp_vec3 next = pp_vec_along(point, STEP_M, axes[i]),
                       last = pp_vec_along(point, -STEP_M, axes[i]);
        double up = pp_surface_pattern_at(height, next, NULL) - here,
               down = here - pp_surface_pattern_at(height, last, NULL);
        /* Not a number outside the range of the formula: the other side counts. */
        double rise = fabs(up) <= fabs(down) || isnan(down) ? up : down;
        gradient = pp_vec_along(gradient, rise / STEP_M, axes[i]);
    }
    return pp_vec_along(gradient, -pp_vec_dot(gradient, normal), normal);
}
