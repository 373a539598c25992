/* scene_description.h - a scene as plain lists: shapes, materials, patterns of light.
 *
 * An import (formats/radiance) fills the lists; simulate/scene/light_scene.h is built
 * from them. Lengths are in metres (or in the unit of the receivers); radiances in any
 * unit, which is then the unit of results.
 *
 * The functions below grow the lists and check each shape.
 */
#ifndef PP_MODEL_LIGHT_SCENE_DESCRIPTION_H
#define PP_MODEL_LIGHT_SCENE_DESCRIPTION_H

#include "model/base/error.h"
#include "model/light/bsdf/measured_pane.h"
#include "model/light/material.h"
#include "model/light/sky.h"
#include "model/geometry/vec.h"

enum pp_shape_kind {
    PP_SHAPE_POLYGON, /* plane, even-odd rule; holes are joined by bridges
                       * (clipper.h) */
    PP_SHAPE_SPHERE,
    PP_SHAPE_CONE,    /* open at both ends; a cylinder if both radii are equal */
    PP_SHAPE_RING,    /* a disc, or a disc with a round hole */
    PP_SHAPE_DISTANT, /* a cone of directions at infinite distance */
};

/* The front is the side from which a polygon's corners are counter-clockwise, the
 * outside of spheres and cones, or the side to which a ring's axis points. */
struct pp_shape {
    enum pp_shape_kind kind;
    int material;
    int back_material; /* -1: same as the front, but emitting only if the material
                        * emits from both sides */
    int tag;           /* for the caller; returned with every hit */
    bool inward;       /* sphere, cone: the front is inside (bubble, cup, tube) */
    union {
        struct {
            int first, count; /* range of the description's vertices */
        } polygon;
        struct {
            struct pp_vec3 centre;
            double radius_m;
        } sphere;
        struct {
            struct pp_vec3 ends[2];
            double radii_m[2]; /* at the two ends, not both 0 */
        } cone;
        struct {
            struct pp_vec3 centre, axis; /* axis: unit */
            double radii_m[2];           /* inner (may be 0), outer */
        } ring;
        struct {
            struct pp_vec3 direction; /* unit, to its centre */
            double half_angle_rad;    /* 0 < .. <= pi */
        } distant;
    } is;
};

/* Factor on a distant source's radiance, by direction. */
enum pp_pattern_kind {
    PP_PATTERN_SKY,    /* factor times pp_sky_luminance; the factor is the sky's Eh */
    PP_PATTERN_GENSKY, /* formulae of Radiance's skies [WS98] */
};

enum pp_gensky_kind {
    PP_GENSKY_CLEAR = 1,
    PP_GENSKY_OVERCAST = 2,
    PP_GENSKY_UNIFORM = 3,
    PP_GENSKY_INTERMEDIATE = 4,
    PP_GENSKY_PEREZ = 5, /* of gendaylit */
};

/* A distant, infinitely long obstruction: from every point it hides the directions u
 * with 0 < u.z < slope (u . outward). */
struct pp_pattern_skyline {
    struct pp_vec3 outward; /* horizontal, unit, towards the obstruction */
    double slope;           /* tangent of its angle */
    double radiance;
};

enum { PP_PATTERN_SKYLINES_MOST = 16 };

struct pp_pattern {
    enum pp_pattern_kind kind;
    double factor;     /* PP_PATTERN_SKY only */
    struct pp_sky sky; /* PP_PATTERN_SKY only */
    int skyline_count; /* PP_PATTERN_SKY; if several hide a direction the first in
                        * the list is visible */
    struct pp_pattern_skyline skylines[PP_PATTERN_SKYLINES_MOST];

    enum pp_gensky_kind type; /* from here on: PP_PATTERN_GENSKY only */
    double zenith, ground;    /* radiances of zenith and ground */
    double norm;              /* divisor for clear and intermediate skies */
    double perez[5];          /* a to e of Perez's skies (model/light/perez_sky.h) */
    struct pp_vec3 sun;       /* unit, towards the sun */
};

/* Factor in unit direction u. A gensky pattern includes sky and ground, which fade into
 * each other around the horizon as in its formula. */
double pp_scene_description_pattern_value(const struct pp_pattern *pattern,
                                          struct pp_vec3 u);

struct pp_scene_description {
    struct pp_shape *shapes;
    int shape_count, shape_space;
    struct pp_vec3 *vertices; /* vertices of all polygons */
    int vertex_count, vertex_space;
    struct pp_material *materials;
    int material_count, material_space;
    struct pp_pattern *patterns;
    int pattern_count, pattern_space;
    struct pp_measured_pane **panes; /* panes of materials that scatter */
    int pane_count, pane_space;
};

void pp_scene_description_init(struct pp_scene_description *scene);
void pp_scene_description_clear(struct pp_scene_description *scene);

/* Adds a copy to the list; *index (may be NULL) is its position. Materials are checked
 * by pp_material_check. */
enum pp_status pp_scene_description_add_material(struct pp_scene_description *scene,
                                                 const struct pp_material *material,
                                                 int *index, struct pp_error *err);
enum pp_status pp_scene_description_add_pattern(struct pp_scene_description *scene,
                                                const struct pp_pattern *pattern,
                                                int *index, struct pp_error *err);

/* Adds a pane to the list. The list takes over the caller's reference to the pane, even
 * after a failure. */
enum pp_status pp_scene_description_add_pane(struct pp_scene_description *scene,
                                             struct pp_measured_pane *pane,
                                             struct pp_error *err);

/* Adds a polygon of count corners; repeated corners are left out. PP_BAD_INPUT for a
 * polygon without area, or uneven by more than a thousandth of its size. */
enum pp_status pp_scene_description_add_polygon(struct pp_scene_description *scene,
                                                const struct pp_vec3 *corners,
                                                int count, int material, int *index,
                                                struct pp_error *err);

/* Adds any other shape. Directions are normalised; PP_BAD_INPUT for invalid ends and
 * radii. */
enum pp_status pp_scene_description_add_shape(struct pp_scene_description *scene,
                                              const struct pp_shape *shape, int *index,
                                              struct pp_error *err);

#endif
