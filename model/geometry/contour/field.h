/* field.h - a function sampled over a plane region, at the nodes of a triangle mesh.
 *
 * The mesh follows the region's edges. The function is evaluated only in the region and
 * on its edge, and never twice at one point. Triangles are at most 1/24 of the region's
 * diagonal long, and a quarter of that along the region's edge; contour.h halves the
 * triangles near a level.
 */
#ifndef PP_MODEL_GEOMETRY_CONTOUR_FIELD_H
#define PP_MODEL_GEOMETRY_CONTOUR_FIELD_H

#include <stddef.h>

#include "model/base/error.h"
#include "model/geometry/contour/known_values.h"
#include "model/geometry/contour/mesh.h"
#include "model/geometry/region.h"

/* Sets *value, which must be finite, to the function at (x, y). An error stops the
 * tracing of curves, which returns it. */
typedef enum pp_status (*pp_field_function)(void *context, double x, double y,
                                            double *value, struct pp_error *err);

/* Part of a curve across one triangle, from edge to edge, with higher values on its
 * left. */
struct pp_crossing {
    int from, to;     /* indices of edges of the mesh */
    int first, count; /* points in between, in field.between */
    bool used;
};

/* Crossing of the level with one edge of the mesh. */
struct pp_curve_end {
    int stamp; /* the other members are valid for the level with this stamp */
    double xy[2];
    int leaving, arriving; /* crossings that begin and end here; -1: none */
};

/* The members are used only by the files of contour/. */
struct pp_field {
    struct pp_mesh mesh;
    struct pp_region region; /* copy of the caller's region */
    pp_field_function function;
    void *context;
    double tolerance, coarse;
    double *values; /* value at each node of the mesh */
    int value_count, value_room;
    struct pp_known_values known; /* all values evaluated so far */
    long evaluations;

    /* Level that is being traced. */
    double level;
    int stamp;
    struct pp_curve_end *ends; /* by edge of the mesh */
    int end_count, end_room;
    struct pp_crossing *crossings;
    int crossing_count, crossing_room;
    double (*between)[2];
    int between_count, between_room;
};

/* Creates the mesh and evaluates the function at its nodes. tolerance: greatest error
 * of the position of curves, above 0, in the unit of the region. The region is copied;
 * context is not owned and must outlive the field. PP_BAD_INPUT for an empty region or
 * a tolerance that is not above 0. */
enum pp_status pp_field_create(struct pp_field **field, const struct pp_region *region,
                               pp_field_function function, void *context,
                               double tolerance, struct pp_error *err);
void pp_field_destroy(struct pp_field *field); /* NULL is allowed */

/* Lowest and highest value at any node so far, and their positions. */
void pp_field_range(const struct pp_field *field, double *lowest, double lowest_xy[2],
                    double *highest, double highest_xy[2]);

/* Fraction of the region's area with values below the level, from the mean of each
 * triangle's corner values. Accurate enough only to choose levels. */
double pp_field_share_below(const struct pp_field *field, double level);

/* Number of evaluations of the function. */
long pp_field_evaluations(const struct pp_field *field);

/* Value at a point. Every value is stored and reused. A level may be traced twice, once
 * for its curves and once for its outlines, and meets the same points again. */
enum pp_status pp_field_evaluate(struct pp_field *field, const double xy[2],
                                 double *value, struct pp_error *err);

/* Evaluates the function at nodes added to the mesh since the last call. */
enum pp_status pp_field_fill(struct pp_field *field, struct pp_error *err);

#endif
