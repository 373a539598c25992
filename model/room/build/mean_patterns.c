/* mean_patterns.c - means of patterns over the visible part of surfaces.
 *
 * The points are a Fibonacci lattice over the bounding rectangle of the surface: point
 * i of F(n), with k = i + 1/2, is at k / F(n) along one side, and at the fractional
 * part of k F(n-1) / F(n) along the other. With F(25) points, the mean of a chequer is
 * correct to 0.0005, whatever its period, if its squares are not smaller than a
 * hundredth of the surface.
 */
#include "model/room/build/mean_patterns.h"

#include <math.h>

#include "model/light/rough/bump_facets.h"
#include "model/light/rough/rough_finishes.h"
#include "model/room/face_frame.h"

/* Points of a surface, a Fibonacci number, and the number before it. All surfaces with a
 * pattern have about POINTS_MOST points together, if each has at least POINTS_LEAST. */
struct lattice {
    int points, turns;
};
enum { POINTS_MOST = 3000000, POINTS_LEAST = 89 };

static struct lattice lattice_for(int surfaces)
{
    struct lattice lattice = {75025, 46368}; /* Fibonacci numbers 25 and 24 */
    while (lattice.points > POINTS_LEAST && lattice.points > POINTS_MOST / surfaces)
        lattice = (struct lattice){lattice.turns, lattice.points - lattice.turns};
    return lattice;
}

/* Sums over the points of a surface. */
struct pattern_points {
    double mean;        /* updated point by point: a constant remains exact */
    double reflectance; /* with bumps: mean reflectance for diffuse light */
    int count;
    double low, high; /* least and greatest value, at low_at and high_at */
    struct pp_vec3 low_at, high_at;
    const char *fault;     /* why the formula has no value at fault_at; NULL: it has */
    const char *attribute; /* of the formula: "pattern" or "bump" */
    struct pp_vec3 fault_at;
};

/* Notes the first fault; fault: NULL: none. */
static void note_fault(struct pattern_points *points, const char *attribute,
                       const char *fault, struct pp_vec3 at)
{
    if (!fault || points->fault)
        return;
    points->fault = fault;
    points->attribute = attribute;
    points->fault_at = at;
}

/* Adds the reflectance of facets at the next point. */
static void add_bump(struct pattern_points *points,
                     const struct pp_rough_finish *material, double reflectance,
                     struct pp_vec3 at, struct pp_vec3 normal)
{
    struct pp_expression_fault fault;
    double steepness =
        pp_vec_length(pp_surface_pattern_slope(&material->height, at, normal, &fault));
    note_fault(points, "bump", fault.what, at);
    note_fault(points, "bump", isfinite(steepness) ? NULL : "has no slope", at);
    points->reflectance +=
        (pp_bump_facets_reflectance(steepness, reflectance) - points->reflectance)
        / (points->count + 1);
}

static void add_pattern_point(struct pattern_points *points,
                              const struct pp_rough_finish *material, struct pp_vec3 at,
                              struct pp_vec3 normal)
{
    struct pp_expression_fault fault;
    double value = pp_surface_pattern_at(&material->pattern, at, &fault);
    note_fault(points, "pattern", fault.what, at);
    if (material->has_bumps)
        add_bump(points, material,
                 pp_rgb_luminance(material->surface.optics.diffuse) * value, at,
                 normal);
    points->mean += (value - points->mean) / ++points->count;
    if (value < points->low) {
        points->low = value;
        points->low_at = at;
    }
    if (value > points->high) {
        points->high = value;
        points->high_at = at;
    }
}

/* True if an opening, a door or a dado covers the point of the surface. */
static bool is_covered(const struct pp_world *world, int face, struct pp_vec3 point)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == face
            && pp_polygon_side(&world->openings[i].inner, point, 0.0) != PP_OUTSIDE)
            return true;
    for (int i = 0; i < world->surface_count; i++)
        if (world->surfaces[i].role == PP_COVER && world->surfaces[i].owner == face
            && pp_polygon_side(&world->surfaces[i].outline, point, 0.0) != PP_OUTSIDE)
            return true;
    return false;
}

static enum pp_status sample_pattern(struct pattern_points *points,
                                     const struct pp_world *world, int index,
                                     const struct pp_rough_finish *material,
                                     struct lattice lattice, struct pp_error *err)
{
    struct pp_face_frame frame;
    enum pp_status status = pp_face_frame_init(&frame, &world->surfaces[index], err);
    *points = (struct pattern_points){.low = INFINITY, .high = -INFINITY};
    bool face = index < world->face_count;
    int count = lattice.points;
    for (int i = 0; i < count && status == PP_OK; i++) {
        const struct pp_bounds2 *box = &frame.bounds;
        double u = (i + 0.5) / count,
               v = fmod((i + 0.5) * lattice.turns, count) / count,
               x = box->low[0] + u * (box->high[0] - box->low[0]),
               y = box->low[1] + v * (box->high[1] - box->low[1]);
        struct pp_vec3 at = pp_face_frame_point(&frame, x, y);
        if (pp_polygon_ring_side((const double(*)[2])frame.xy, frame.count, x, y, 0.0)
                != PP_OUTSIDE
            && !(face && is_covered(world, index, at)))
            add_pattern_point(points, material, at,
                              world->surfaces[index].outline.normal);
    }
    if (status == PP_OK)
        pp_face_frame_clear(&frame);
    return status;
}

/* Reports a value of a material at a point. */
static bool report_value(struct pp_mistakes *mistakes,
                         const struct pp_rough_finish *material, struct pp_vec3 at,
                         double reflectance)
{
    pp_mistakes_add(mistakes, material->line,
                    "material: the pattern of \"%.60s\" gives a reflectance of %.3g at "
                    "the point %.3f %.3f %.3f; expected 0 to 1 on all its surfaces",
                    material->finish.name, reflectance, at.x, at.y, at.z);
    return false;
}

/* True if all values are valid; otherwise reports one that is not. */
static bool check_pattern_points(struct pp_mistakes *mistakes,
                                 const struct pp_rough_finish *material,
                                 const struct pattern_points *points)
{
    struct pp_rgb base = material->surface.optics.diffuse;
    double most = fmax(base.r, fmax(base.g, base.b));
    /* Largest specular reflectance of the three channels; 0 for a matt surface. */
    double gloss =
        fmax(material->surface.reflectance[0],
             fmax(material->surface.reflectance[1], material->surface.reflectance[2]));
    if (points->fault) {
        pp_mistakes_add(mistakes, material->line,
                        "material: the %s of \"%.60s\" %s at the point "
                        "%.3f %.3f %.3f; expected a value on all its surfaces",
                        points->attribute, material->finish.name, points->fault,
                        points->fault_at.x, points->fault_at.y, points->fault_at.z);
        return false;
    }
    if (points->low < 0.0)
        return report_value(mistakes, material, points->low_at, points->low * most);
    if (points->high * most + gloss > 1.0 + 1e-9)
        return report_value(mistakes, material, points->high_at,
                            points->high * most + gloss);
    return true;
}

/* Sets the mean reflectance of a surface. */
static enum pp_status set_mean(struct pp_resolver *r, int index,
                               const struct pp_rough_finish *material,
                               struct lattice lattice, struct pp_error *err)
{
    struct pp_surface *surface = &r->world->surfaces[index];
    struct pattern_points points;
    enum pp_status status =
        sample_pattern(&points, r->world, index, material, lattice, err);
    if (status != PP_OK || points.count == 0
        || !check_pattern_points(r->mistakes, material, &points))
        return status;
    double whole = material->finish.reflectance,
           diffuse = pp_rgb_luminance(material->surface.optics.diffuse),
           mean = material->has_bumps ? points.reflectance
                  : material->is_matt ? whole * points.mean
                                      : whole - diffuse * (1.0 - points.mean);
    surface->pattern_mean = points.mean;
    if (surface->back == surface->front && index >= r->world->face_count)
        surface->back = mean;
    surface->front = mean;
    return PP_OK;
}

/* The material of a surface, if it has a pattern; NULL otherwise. A study that assumes
 * another reflectance has no pattern. */
static const struct pp_rough_finish *pattern_of(const struct pp_world *world, int index)
{
    const struct pp_surface *surface = &world->surfaces[index];
    const struct pp_rough_finish *material =
        pp_rough_finishes_patterned(world->materials, surface->finish);
    bool own = material && surface->front == material->finish.reflectance;
    return own ? material : NULL;
}

enum pp_status pp_build_mean_patterns(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_world *world = r->world;
    enum pp_status status = PP_OK;
    int surfaces = 0;
    for (int i = 0; i < world->surface_count; i++)
        surfaces += pattern_of(world, i) != NULL;
    for (int i = 0; i < world->surface_count && status == PP_OK; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        const struct pp_rough_finish *material = pattern_of(world, i);
        if (!material)
            continue;
        int before = r->mistakes->count;
        if (surface->inside)
            status = set_mean(r, i, material, lattice_for(surfaces), err);
        else
            pp_mistakes_add(r->mistakes, surface->line,
                            "surface: the material \"%.60s\" has a pattern or bumps; "
                            "expected one without them outside the room",
                            material->finish.name);
        if (r->mistakes->count > before)
            break;
    }
    return status;
}
