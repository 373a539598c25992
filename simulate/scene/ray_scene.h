/* ray_scene.h - a world as the tracer's rays meet it: grey, diffuse surfaces and glass.
 *
 * Every surface and every pane of glass becomes a facet: a plane with its optics, and
 * triangles for the ray kernels. Faces are cut by their openings. Coordinates are
 * shifted so that the room's centre is the origin, before they become single precision;
 * planes stay in double, and hit points are put back on these.
 */
#ifndef PP_SIMULATE_SCENE_RAY_SCENE_H
#define PP_SIMULATE_SCENE_RAY_SCENE_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/room/world.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/rays.h"
#include "simulate/sampling/sample_polygon.h"

enum pp_facet_side { PP_FRONT, PP_BACK };

/* A plane figure with its optics; each opening's glass is one. */
struct pp_facet {
    struct pp_vec3 normal, a, b; /* right-handed frame (a, b, normal) */
    double offset_m;             /* normal . x of its points */
    double reflectance[2];       /* by side; of an opening, its frame's */
    double exitance;             /* of either side */
    int opening;                 /* whose glass it is, or -1 */
    bool envelope; /* envelope or reveal: its back is not seen from inside the room */
};

/* An opening, with facts that save rays. */
struct pp_pane {
    struct pp_target target;
    const struct pp_opening *opening; /* not owned */
    int facet;
    bool seen_by_all;  /* no surface can stand between it and a point in the room */
    bool unobstructed; /* a ray that leaves by it meets no surface any more */
};

struct pp_ray_scene {
    struct pp_vec3 centre; /* of the room, in the world's coordinates */
    double size_m;         /* greatest coordinate of the room from there */

    struct pp_facet *facets; /* the world's surfaces, then its openings' glass */
    int facet_count;
    struct pp_pane *panes;
    int pane_count;
    bool has_room; /* else every point is outside */

    struct pp_vec3 (*triangles)[3];
    int *facet_of_triangle;
    int triangle_count;
    struct pp_rays *rays;

    struct pp_vec3 (*plane)[3]; /* the working plane's triangles */
    int plane_count;
    double plane_area_m2;

    double most_exitance; /* the greatest of any surface's own */
    double decorations; /* allowance on what is reflected inside, no matter of paths */
    bool reflects;      /* does any surface that the room sees? */

    struct pp_environment environment;
    struct pp_brightness brightness; /* a guess of that outside the openings */
};

/* world must live as long as the scene. */
enum pp_status pp_ray_scene_create(struct pp_ray_scene **scene,
                                   const struct pp_world *world, struct pp_error *err);
void pp_ray_scene_destroy(struct pp_ray_scene *scene); /* NULL is allowed */

/* A point of the working plane, uniform by area for two numbers in (0, 1). */
struct pp_vec3 pp_ray_scene_plane_point(const struct pp_ray_scene *scene, double u,
                                        double v);

/* The opening that u in [0, 1) falls to, in proportion to what each may bring to that
 * side of a surface, and its probability; -1: none can bring anything. */
int pp_ray_scene_choose_pane(const struct pp_ray_scene *scene, struct pp_vec3 point,
                             struct pp_vec3 normal, double u, double *probability);

/* A ray's first meeting. */
struct pp_contact {
    int facet; /* -1: none */
    enum pp_facet_side side;
    struct pp_vec3 point; /* on the facet's plane */
    double distance_m;
};

/* From p, a point of a plane with unit normal n on the side that the ray leaves to,
 * along u (unit). */
struct pp_contact pp_ray_scene_first(const struct pp_ray_scene *scene, struct pp_vec3 p,
                                     struct pp_vec3 n, struct pp_vec3 u);

#endif
