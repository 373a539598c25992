/* scene_description.h - a scene as plain lists: shapes, materials, patterns of light.
 *
 * An import (formats/radiance) fills the lists; simulate/scene/light_scene.h is made
 * from them. Lengths are in metres (or in the unit of the receivers), radiances in any
 * unit, which the results then have.
 *
 * Lists are grown by the functions below, which check each shape as it comes.
 */
#ifndef PP_MODEL_LIGHT_SCENE_DESCRIPTION_H
#define PP_MODEL_LIGHT_SCENE_DESCRIPTION_H

#include "model/base/error.h"
#include "model/light/material.h"
#include "model/light/sky.h"
#include "model/geometry/vec.h"

enum pp_shape_kind {
    PP_SHAPE_POLYGON, /* plane, by crossings: a hole is joined by a bridge (region.h) */
    PP_SHAPE_SPHERE,
    PP_SHAPE_CONE,    /* open at both ends; a cylinder where both radii are equal */
    PP_SHAPE_RING,    /* a disc, or a disc with a round hole */
    PP_SHAPE_DISTANT, /* a cone of directions, infinitely far away */
};

/* The front is the side that a polygon's corners run counter-clockwise seen from, the
 * outside of spheres and cones, the side a ring's axis points to. */
struct pp_shape {
    enum pp_shape_kind kind;
    int material;
    int back_material; /* of the other side; -1: the same, but giving off light only
                        * where the material does from both sides */
    int tag;           /* the caller's own: it comes back with every hit */
    bool inward;       /* sphere, cone: their front is inside (bubble, cup, tube) */
    union {
        struct {
            int first, count; /* of the description's vertices */
        } polygon;
        struct {
            struct pp_vec3 centre;
            double radius_m;
        } sphere;
        struct {
            struct pp_vec3 ends[2];
            double radii_m[2]; /* at either end, not both 0 */
        } cone;
        struct {
            struct pp_vec3 centre, axis; /* axis: unit */
            double radii_m[2];           /* inner (may be 0), outer */
        } ring;
        struct {
            struct pp_vec3 direction; /* to its middle, unit */
            double half_angle_rad;    /* 0 < .. <= pi */
        } distant;
    } is;
};

/* Factors of a distant source's radiance by direction. */
enum pp_pattern_kind {
    PP_PATTERN_SKY,    /* factor times pp_sky_luminance; the factor is the sky's Eh */
    PP_PATTERN_GENSKY, /* the formulae that Radiance's skies are written with [WS98] */
};

enum pp_gensky_kind {
    PP_GENSKY_CLEAR = 1,
    PP_GENSKY_OVERCAST = 2,
    PP_GENSKY_UNIFORM = 3,
    PP_GENSKY_INTERMEDIATE = 4,
};

/* An endless obstruction so far away that it hides the directions u with
 * 0 < u.z < slope (u . outward) from every point. */
struct pp_pattern_skyline {
    struct pp_vec3 outward; /* horizontal, unit: towards it */
    double slope;           /* tangent of its angle */
    double radiance;
};

enum { PP_PATTERN_SKYLINES_MOST = 16 };

struct pp_pattern {
    enum pp_pattern_kind kind;
    double factor;     /* of PP_PATTERN_SKY */
    struct pp_sky sky; /* of PP_PATTERN_SKY */
    int skyline_count; /* of PP_PATTERN_SKY; where several hide a direction, the first
                        * in the list is seen */
    struct pp_pattern_skyline skylines[PP_PATTERN_SKYLINES_MOST];

    enum pp_gensky_kind type; /* the rest of PP_PATTERN_GENSKY */
    double zenith, ground;    /* radiances of zenith and ground */
    double norm;              /* divisor of clear and intermediate skies */
    struct pp_vec3 sun;       /* towards it, unit */
};

/* The factor in direction u (unit). A gensky pattern has sky and ground in one, run
 * into each other about the horizon as its formula does. */
double pp_scene_description_pattern_value(const struct pp_pattern *pattern,
                                          struct pp_vec3 u);

struct pp_scene_description {
    struct pp_shape *shapes;
    int shape_count, shape_space;
    struct pp_vec3 *vertices; /* of all polygons */
    int vertex_count, vertex_space;
    struct pp_material *materials;
    int material_count, material_space;
    struct pp_pattern *patterns;
    int pattern_count, pattern_space;
};

void pp_scene_description_init(struct pp_scene_description *scene);
void pp_scene_description_clear(struct pp_scene_description *scene);

/* Adds a copy to its list; *index is its place there (index may be NULL). Materials are
 * checked by pp_material_check. */
enum pp_status pp_scene_description_add_material(struct pp_scene_description *scene,
                                                 const struct pp_material *material,
                                                 int *index, struct pp_error *err);
enum pp_status pp_scene_description_add_pattern(struct pp_scene_description *scene,
                                                const struct pp_pattern *pattern,
                                                int *index, struct pp_error *err);

/* A polygon of count corners; repeated corners and a repeated first one are left out.
 * One without an area, or farther out of its plane than a thousandth of its size, is
 * PP_BAD_INPUT. */
enum pp_status pp_scene_description_add_polygon(struct pp_scene_description *scene,
                                                const struct pp_vec3 *corners,
                                                int count, int material, int *index,
                                                struct pp_error *err);

/* Any other shape; directions are made unit, ends and radii are checked. */
enum pp_status pp_scene_description_add_shape(struct pp_scene_description *scene,
                                              const struct pp_shape *shape, int *index,
                                              struct pp_error *err);

#endif
