/* surface_pattern.h - a pattern on a surface: a formula (expression.h) of the place, as
 * a factor of the diffuse reflectance, or as the height of bumps in metres. Its
 * quantities x, y and z are coordinates in the room (plain numbers of metres).
 */
#ifndef PP_MODEL_EXPRESSION_SURFACE_PATTERN_H
#define PP_MODEL_EXPRESSION_SURFACE_PATTERN_H

#include "model/expression/expression_value.h"
#include "model/geometry/vec.h"

struct pp_surface_pattern {
    char text[PP_EXPRESSION_MOST + 1];
    struct pp_expression expression;
};

/* Parses the formula; false, with a mistake, if it is not valid. */
bool pp_surface_pattern_parse(struct pp_surface_pattern *pattern, const char *text,
                              struct pp_expression_mistake *mistake);

/* Value at a point of the room; fault: as in pp_expression_value, may be NULL. */
double pp_surface_pattern_at(const struct pp_surface_pattern *pattern,
                             struct pp_vec3 point, struct pp_expression_fault *fault);

/* Slope at a point of a surface with that unit normal: the part in the surface of the
 * gradient of a height. Along each axis the gradient is the smaller one of those to both
 * sides, over 0.01 mm, so that the jump of a step does not count. fault: as above. */
struct pp_vec3 pp_surface_pattern_slope(const struct pp_surface_pattern *height,
                                        struct pp_vec3 point, struct pp_vec3 normal,
                                        struct pp_expression_fault *fault);

#endif
