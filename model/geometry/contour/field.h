/* field.h - what the files of contour.h share: a field's insides.
 */
#ifndef PP_MODEL_GEOMETRY_CONTOUR_FIELD_H
#define PP_MODEL_GEOMETRY_CONTOUR_FIELD_H

#include <stddef.h>

#include "model/geometry/contour/contour.h"
#include "model/geometry/contour/mesh.h"

/* A piece of a curve across one triangle, from edge to edge, higher values on its
 * left. */
struct pp_crossing {
    int from, to;     /* edges */
    int first, count; /* points in between, in field.between */
    bool used;
};

struct pp_curve_end { /* where curves leave and enter, of one edge */
    int stamp;        /* of the level that the rest is about */
    double xy[2];
    int leaving, arriving; /* the crossing that begins, that ends here; -1: none */
};

struct pp_field {
    struct pp_mesh mesh;
    struct pp_region region; /* a copy */
    pp_field_function function;
    void *context;
    double tolerance, coarse;
    double *values; /* at the mesh's nodes */
    int value_count, value_room;
    long evaluations;

    /* Of the level in work. */
    double level;
    int stamp;
    struct pp_curve_end *ends; /* by edge */
    int end_room;
    struct pp_crossing *crossings;
    int crossing_count, crossing_room;
    double (*between)[2];
    int between_count, between_room;
};

/* Room for one more than count in a list that grows by doubling. */
enum pp_status pp_field_reserve(void **list, int *room, int count, size_t size,
                                struct pp_error *err);

enum pp_status pp_field_evaluate(struct pp_field *field, const double xy[2],
                                 double *value, struct pp_error *err);

/* Evaluates at the nodes that are new. */
enum pp_status pp_field_fill(struct pp_field *field, struct pp_error *err);

/* Follows field.level across one triangle, if it crosses it, and notes the crossing. */
enum pp_status pp_level_crossing_follow(struct pp_field *field, int triangle,
                                        struct pp_error *err);

/* All curves of the level, open ones first, the least of them too. */
enum pp_status pp_contour_trace(struct pp_field *field, double level,
                                struct pp_curve_list *curves, struct pp_error *err);

#endif
