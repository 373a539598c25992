/* opening_table.h - the radiance of the surfaces outside one opening, by place and
 * direction.
 *
 * The opening is divided into patches, smaller ones if surfaces outside are near. For
 * each patch and each direction (bins of equal projected solid angle), the table
 * contains the mean radiance of the surfaces met, if they are at least twice the size
 * of a patch away. It does not contain sky, open ground and skylines.
 */
#ifndef PP_SIMULATE_TRANSPORT_OPENING_TABLE_H
#define PP_SIMULATE_TRANSPORT_OPENING_TABLE_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/light/rgb.h"
#include "simulate/sampling/sample_polygon.h"
#include "simulate/scene/light_scene.h"

enum {
    PP_OPENING_TABLE_SIDE =
        12, /* bins of directions along either axis of the opening */
    PP_OPENING_TABLE_BINS = PP_OPENING_TABLE_SIDE * PP_OPENING_TABLE_SIDE,
};

struct pp_opening_table {
    int columns, rows;       /* patches along the opening's axes */
    double far_m;            /* surfaces nearer than this are not in the table */
    struct pp_rgb *radiance; /* by patch and bin; NULL: no surface outside */
};

/* Makes an empty table for an opening whose nearest surface outside is at near_m
 * (INFINITY: none). */
enum pp_status pp_opening_table_init(struct pp_opening_table *table,
                                     const struct pp_target *target, double near_m,
                                     struct pp_error *err);
void pp_opening_table_clear(struct pp_opening_table *table);

/* A point of a patch, and a direction of a bin, each from two numbers in (0, 1).
 * pp_opening_table_direction returns false if the numbers give no direction (a corner
 * of the square of bins, outside the unit circle). */
struct pp_vec3 pp_opening_table_point(const struct pp_opening_table *table,
                                      const struct pp_target *target, int patch,
                                      double u, double v);
bool pp_opening_table_direction(const struct pp_target *target, int bin, double u,
                                double v, struct pp_vec3 *to);

/* True if a table has the radiance of what a ray has met: ground, or a surface. It has
 * none of panes outside, since their light changes with every direction. */
bool pp_opening_table_takes(const struct pp_light_scene *scene, enum pp_meeting meeting,
                            const struct pp_light_hit *hit);

/* The radiance of the surface that is met outside, at that distance along `to`, from a
 * point of the opening; false if the table has no value. */
bool pp_opening_table_radiance(const struct pp_opening_table *table,
                               const struct pp_target *target, struct pp_vec3 point,
                               struct pp_vec3 to, double distance_m,
                               struct pp_rgb *radiance);

#endif
