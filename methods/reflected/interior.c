/* interior.c - sums of area and of area times reflectance over the inside surfaces of a
 * room, cut at a height. */
#include "methods/reflected/interior.h"

#include "methods/reflected/well.h"
#include "model/geometry/min_max.h"

/* Twice the area of the triangle o a b; positive if the triangle runs counter-clockwise
 * as seen from the side of the polygon's normal. */
static double twice_area(const struct pp_polygon *polygon, struct pp_vec3 o,
                         struct pp_vec3 a, struct pp_vec3 b)
{
    return pp_vec_dot(polygon->normal,
                      pp_vec_cross(pp_vec_sub(a, o), pp_vec_sub(b, o)));
}

/* Point where the edge from a to b crosses the horizontal plane at z; z lies between a
 * and b. */
static struct pp_vec3 level_crossing_point(struct pp_vec3 a, struct pp_vec3 b, double z)
{
    return pp_vec_along(a, (z - a.z) / (b.z - a.z), pp_vec_sub(b, a));
}

static int next(const struct pp_polygon *polygon, int i)
{
    return i + 1 < polygon->count ? i + 1 : 0;
}

/* The polygon's area is the sum of the triangles that its edges form with a fixed point
 * o. With o on the cut, triangles of edges along the cut have no area, so that the sum
 * needs only the parts of the polygon's own edges below z. */
double pp_interior_area_below(const struct pp_polygon *polygon, double z)
{
    const struct pp_vec3 *vertices = polygon->vertices;
    double lowest = vertices[0].z, highest = lowest;
    for (int i = 1; i < polygon->count; i++) {
        lowest = pp_min(vertices[i].z, lowest);
        highest = pp_max(vertices[i].z, highest);
    }
    if (lowest >= z)
        return 0.0;
    if (highest < z)
        return polygon->area_m2;

    struct pp_vec3 o = vertices[0];
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 a = vertices[i], b = vertices[next(polygon, i)];
        if ((a.z < z) != (b.z < z))
            o = level_crossing_point(a, b, z);
    }
    double sum = 0.0;
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 a = vertices[i], b = vertices[next(polygon, i)];
        if (a.z >= z && b.z >= z)
            continue;
        if ((a.z < z) != (b.z < z)) {
            struct pp_vec3 cut = level_crossing_point(a, b, z);
            if (a.z < z)
                b = cut;
            else
                a = cut;
        }
        sum += twice_area(polygon, o, a, b);
    }
    return fmin(fmax(sum / 2.0, 0.0), polygon->area_m2);
}

static double area_below(const struct pp_polygon *polygon, double z)
{
    if (z == INFINITY)
        return polygon->area_m2;
    bool level = fabs(polygon->normal.z) > 1.0 - 1e-12;
    if (level && fabs(polygon->vertices[0].z - z) < 1e-9)
        return polygon->normal.z > 0.0 ? polygon->area_m2 : 0.0;
    return pp_interior_area_below(polygon, z);
}

/* Sums of area and of area times reflectance, for an area-weighted mean. */
struct sums {
    double area_m2, reflecting_m2;
};

static void add_reflecting_area(struct sums *sums, double area_m2, double reflectance)
{
    sums->area_m2 += area_m2;
    sums->reflecting_m2 += area_m2 * reflectance;
}

static struct pp_interior mean(struct sums sums)
{
    if (!(sums.area_m2 > 0.0))
        return (struct pp_interior){0.0, 0.0};
    return (struct pp_interior){sums.area_m2, sums.reflecting_m2 / sums.area_m2};
}

/* Adds `share` times a polygon, of which below_m2 are below z, to both parts. */
static void add_area_parts(struct sums *lower, struct sums *upper,
                           const struct pp_polygon *outline, double below_m2,
                           double share, double reflectance)
{
    add_reflecting_area(lower, share * below_m2, reflectance);
    add_reflecting_area(upper, share * (outline->area_m2 - below_m2), reflectance);
}

/* Adds the surfaces that cover faces of a role (PP_ROLE_COUNT: of any role), in place
 * of the covered areas. Leaves out covers on face `left_out` (-1: none is left out). */
static void add_covers(struct sums *lower, struct sums *upper,
                       const struct pp_world *world, double z, enum pp_role role,
                       int left_out)
{
    for (int i = world->face_count; i < world->surface_count; i++) {
        const struct pp_surface *cover = &world->surfaces[i];
        if (cover->role != PP_COVER || cover->owner == left_out)
            continue;
        const struct pp_surface *face = &world->surfaces[cover->owner];
        if (role != PP_ROLE_COUNT && face->role != role)
            continue;
        double below_m2 = area_below(&cover->outline, z);
        add_area_parts(lower, upper, &cover->outline, below_m2, 1.0, cover->front);
        add_area_parts(lower, upper, &cover->outline, below_m2, -1.0, face->front);
    }
}

static struct pp_interior_parts split(const struct pp_world *world, double z,
                                      int left_out, bool with_openings)
{
    struct sums lower = {0}, upper = {0};
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = world->surfaces + i;
        bool of_face_left_out = surface->role == PP_REVEAL
                                    ? world->openings[surface->owner].face == left_out
                                    : i == left_out;
        bool of_well =
            surface->role == PP_REVEAL && pp_well_is(world->openings + surface->owner);
        if (!surface->inside || surface->role == PP_COVER || of_face_left_out
            || of_well)
            continue;
        double below_m2 = area_below(&surface->outline, z);
        add_area_parts(&lower, &upper, &surface->outline, below_m2, 1.0,
                       surface->front);
        if (surface->role == PP_FREE_SURFACE && !surface->is_of_fitting)
            add_area_parts(&lower, &upper, &surface->outline, below_m2, 1.0,
                           surface->back);
    }
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = world->openings + i;
        if (opening->face == left_out)
            continue;
        double below_m2 = area_below(&opening->inner, z);
        add_area_parts(&lower, &upper, &opening->inner, below_m2, -1.0,
                       world->surfaces[opening->face].front);
        if (with_openings)
            add_area_parts(&lower, &upper, &opening->inner, below_m2, 1.0,
                           PP_OPENING_REFLECTANCE);
    }
    add_covers(&lower, &upper, world, z, PP_ROLE_COUNT, left_out);
    return (struct pp_interior_parts){mean(lower), mean(upper)};
}

struct pp_interior pp_interior_all(const struct pp_world *world)
{
    return split(world, INFINITY, -1, true).lower;
}

void pp_interior_put(struct pp_worksheet *sheet, const struct pp_interior *all)
{
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, all->area_m2, "A",
                     "area of all interior surfaces, openings included");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, all->reflectance, "R",
                     "mean reflectance of these surfaces (openings: 0.1)");
}

struct pp_interior pp_interior_role(const struct pp_world *world, enum pp_role role)
{
    struct sums sums = {0};
    for (int i = 0; i < world->face_count; i++)
        if (world->surfaces[i].role == role)
            add_reflecting_area(&sums, world->surfaces[i].outline.area_m2,
                                world->surfaces[i].front);
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_surface *face = world->surfaces + world->openings[i].face;
        if (face->role == role)
            add_reflecting_area(&sums, -world->openings[i].inner.area_m2, face->front);
    }
    add_covers(&sums, &sums, world, INFINITY, role, -1);
    return mean(sums);
}

struct pp_interior pp_interior_role_above(const struct pp_world *world,
                                          enum pp_role role, double z)
{
    struct sums lower = {0}, upper = {0};
    for (int i = 0; i < world->face_count; i++)
        if (world->surfaces[i].role == role)
            add_area_parts(&lower, &upper, &world->surfaces[i].outline,
                           area_below(&world->surfaces[i].outline, z), 1.0,
                           world->surfaces[i].front);
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = world->openings + i;
        const struct pp_surface *face = world->surfaces + opening->face;
        if (face->role != role)
            continue;
        double below_m2 = area_below(&opening->inner, z);
        add_area_parts(&lower, &upper, &opening->inner, below_m2, -1.0, face->front);
        add_area_parts(&lower, &upper, &opening->inner, below_m2, 1.0,
                       PP_OPENING_REFLECTANCE);
    }
    add_covers(&lower, &upper, world, z, role, -1);
    return mean(upper);
}

struct pp_interior_parts pp_interior_split(const struct pp_world *world, double z)
{
    return split(world, z, -1, false);
}

struct pp_interior_parts pp_interior_split_without(const struct pp_world *world,
                                                   double z, int left_out)
{
    return split(world, z, left_out, true);
}

/* True if a face lies entirely above z (`above`) or below z, and openings cover less
 * than half of the face. */
static bool is_on_one_side(const struct pp_world *world, int face, double z, bool above)
{
    const struct pp_polygon *outline = &world->surfaces[face].outline;
    double openings_m2 = 0.0;
    for (int i = 0; i < outline->count; i++)
        if (above ? outline->vertices[i].z <= z : outline->vertices[i].z >= z)
            return false;
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == face)
            openings_m2 += world->openings[i].inner.area_m2;
    return openings_m2 < 0.5 * outline->area_m2;
}

bool pp_interior_is_split(const struct pp_world *world, double z)
{
    /* Most rooms have a floor and a ceiling, which need no sums over all surfaces. */
    bool has_lower = false, has_upper = false;
    for (int i = 0; i < world->face_count && !(has_lower && has_upper); i++) {
        has_lower = has_lower || is_on_one_side(world, i, z, false);
        has_upper = has_upper || is_on_one_side(world, i, z, true);
    }
    if (has_lower && has_upper)
        return true;
    struct pp_interior_parts parts = pp_interior_split(world, z);
    return parts.upper.area_m2 > 0.0 && parts.lower.area_m2 > 0.0;
}

double pp_interior_section_m2(const struct pp_world *world, double z)
{
    double sum_m2 = 0.0;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        sum_m2 += area_below(face, z) * face->normal.z;
    }
    return sum_m2;
}
