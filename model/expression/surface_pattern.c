/* surface_pattern.c - see surface_pattern.h. */
#include "model/expression/surface_pattern.h"

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
