/* field.h - a function sampled over a plane figure, at the nodes of a mesh that covers
 * it.
 *
 * The mesh keeps to the figure's edges. The function is evaluated inside the figure and
 * on its edge, nowhere else, and never twice at a place. Triangles are at most 1/24 of
 * the figure's diagonal long, and along the figure's edge a quarter of that; contour.h
 * halves those near a level.
 */
#ifndef PP_MODEL_GEOMETRY_CONTOUR_FIELD_H
#define PP_MODEL_GEOMETRY_CONTOUR_FIELD_H

#include <stddef.h>

#include "model/base/error.h"
#include "model/geometry/contour/known_values.h"
#include "model/geometry/contour/mesh.h"
#include "model/geometry/region.h"

/* Sets *value at (x, y); must be finite. An error stops the tracing and is returned. */
typedef enum pp_status (*pp_field_function)(void *context, double x, double y,
                                            double *value, struct pp_error *err);

/* A part of a curve across one triangle, from edge to edge, higher values on its
 * left. */
struct pp_crossing {
    int from, to;     /* edges */
    int first, count; /* points in between, in field.between */
    bool used;
};

/* Crossing of a curve of the level with one edge of the mesh. */
struct pp_curve_end {
    int stamp; /* of the level that the rest is about */
    double xy[2];
    int leaving, arriving; /* the crossing that begins, that ends here; -1: none */
};

/* Fields are for the files of contour/ only. */
struct pp_field {
    struct pp_mesh mesh;
    struct pp_region region; /* a copy */
    pp_field_function function;
    void *context;
    double tolerance, coarse;
    double *values; /* at the mesh's nodes */
    int value_count, value_room;
    struct pp_known_values known; /* wherever it was evaluated */
    long evaluations;

    /* Level of the curves being traced. */
    double level;
    int stamp;
    struct pp_curve_end *ends; /* by edge */
    int end_count, end_room;
    struct pp_crossing *crossings;
    int crossing_count, crossing_room;
    double (*between)[2];
    int between_count, between_room;
};

/* Evaluates at the nodes of the first triangles. Lengths are in the figure's unit;
 * tolerance > 0. region is copied as far as needed; context is not owned and must live
 * as long as the field. The empty figure is refused. */
enum pp_status pp_field_create(struct pp_field **field, const struct pp_region *region,
                               pp_field_function function, void *context,
                               double tolerance, struct pp_error *err);
void pp_field_destroy(struct pp_field *field); /* NULL is allowed */

/* Lowest and highest value at any node so far, and where. */
void pp_field_range(const struct pp_field *field, double *lowest, double lowest_xy[2],
                    double *highest, double highest_xy[2]);

/* The share of the figure's area where the function is below the level, by the mean of
 * each triangle's corners: for a choice of levels, not for results. */
double pp_field_share_below(const struct pp_field *field, double level);

/* Number of evaluations of the function. */
long pp_field_evaluations(const struct pp_field *field);

/* Value at a place. Evaluated values are kept: a level whose curves were traced is
 * traced again for its outlines, after other levels have halved triangles elsewhere. */
enum pp_status pp_field_evaluate(struct pp_field *field, const double xy[2],
                                 double *value, struct pp_error *err);

/* Evaluates at the nodes that are new. */
enum pp_status pp_field_fill(struct pp_field *field, struct pp_error *err);

#endif
