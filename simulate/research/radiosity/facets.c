/* facets.c - makes the facets of a world's surfaces and panes, with their materials,
 * planes and triangles. */
#include "simulate/research/radiosity/facets.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/room/face_less_openings.h"
#include "model/room/surface_materials.h"
#include "simulate/research/radiosity/facet_pieces.h"

double pp_facet_straight(const struct pp_facet *facet, double cosine)
{
    return pp_surface_materials_pane_straight(facet->opening, cosine);
}

double pp_facet_mirrored(const struct pp_facet *facet, double cosine)
{
    return pp_surface_materials_pane_mirrored(facet->opening, cosine);
}

/* ---- one facet ---- */

static void set_plane(struct pp_facet *facet, const struct pp_polygon *outline)
{
    facet->outline = outline;
    facet->origin = outline->vertices[0];
    facet->normal = outline->normal;
    pp_polygon_plane_axes(facet->normal, &facet->a, &facet->b);
}

static void set_side(struct pp_facet *facet, int side, bool indoors,
                     const struct pp_material *material)
{
    facet->side[side] =
        (struct pp_facet_side){.indoors = indoors,
                               .reflectance = material->diffuse.g,
                               .exitance = PP_PI * material->radiance.g};
}

/* A cover (a door or dado) is moved into its wall's plane; the world places it in front
 * of the wall. Both cover and wall belong to the envelope; outdoors both have the
 * wall's finish. */
static void set_surface(struct pp_facet *facet, const struct pp_world *world, int index)
{
    const struct pp_surface *surface = &world->surfaces[index];
    bool cover = surface->role == PP_COVER;
    set_plane(facet,
              cover ? &world->surfaces[surface->owner].outline : &surface->outline);
    facet->outline = &surface->outline;
    facet->envelope = index < world->face_count || surface->role == PP_REVEAL || cover;
    for (int side = 0; side < 2; side++) {
        int own = cover && side == 1 ? surface->owner : index;
        struct pp_material material = pp_surface_materials_matt(world, own, side == 0);
        set_side(facet, side, surface->inside && !(facet->envelope && side == 1),
                 &material);
    }
}

/* True if all surfaces are on the room's side of the pane's plane. */
static bool looks_out(const struct pp_facet *pane, const struct pp_world *world)
{
    for (int i = 0; i < world->surface_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++)
            if (pp_facet_height(pane, world->surfaces[i].outline.vertices[k]) < -1e-6)
                return false;
    return true;
}

static void set_pane(struct pp_facet *facet, const struct pp_world *world, int index)
{
    const struct pp_opening *opening = &world->openings[index];
    set_plane(facet, &opening->outer);
    facet->opening = opening;
    facet->envelope = true;
    facet->clear = !opening->glass.diffusing;
    facet->looks_out = looks_out(facet, world);
    for (int side = 0; side < 2; side++) {
        struct pp_material material =
            pp_surface_materials_pane(world, index, side == 0);
        set_side(facet, side, side == 0, &material);
        facet->through = material.through_diffuse.g;
    }
}

/* ---- triangles for rays ---- */

struct triangles {
    struct pp_ray_triangle *list;
    int count, room;
};

static enum pp_status fan(struct triangles *triangles, const struct pp_vec3 *corners,
                          int count, int owner, struct pp_error *err)
{
    enum pp_status status =
        pp_array_reserve(&triangles->list, &triangles->room, triangles->count + count,
                         sizeof *triangles->list, err);
    for (int i = 2; status == PP_OK && i < count; i++)
        triangles->list[triangles->count++] =
            (struct pp_ray_triangle){{corners[0], corners[i - 1], corners[i]}, owner};
    return status;
}

/* Adds the triangles of a surface outdoors; a surface that is not convex is
 * triangulated. */
static enum pp_status fan_surface(struct triangles *triangles,
                                  const struct pp_surface *surface, int owner,
                                  struct pp_error *err)
{
    const struct pp_vec3 *v = surface->outline.vertices;
    enum pp_status status = PP_OK;
    if (!surface->triangles)
        return fan(triangles, v, surface->outline.count, owner, err);
    for (int i = 0; status == PP_OK && i < surface->triangle_count; i++) {
        const int *k = surface->triangles[i];
        const struct pp_vec3 corners[3] = {v[k[0]], v[k[1]], v[k[2]]};
        status = fan(triangles, corners, 3, owner, err);
    }
    return status;
}

static enum pp_status add_rays(struct pp_facets *facets, struct pp_error *err)
{
    struct triangles triangles = {NULL, 0, 0};
    enum pp_status status = PP_OK;
    for (int i = 0; status == PP_OK && i < facets->count; i++) {
        const struct pp_facet *facet = &facets->list[i];
        if (!facet->side[0].indoors) {
            status = fan_surface(&triangles, &facets->world->surfaces[i], i, err);
            continue;
        }
        for (int k = 0; status == PP_OK && k < facet->piece_count; k++) {
            const struct pp_piece *piece = &facets->pieces[facet->first_piece + k];
            status = fan(&triangles, &facets->corners[piece->first_corner],
                         piece->count, i, err);
        }
    }
    if (status == PP_OK)
        status =
            pp_ray_tree_create(&facets->rays, triangles.list, triangles.count, err);
    free(triangles.list);
    return status;
}

/* ---- all facets ---- */

static void measure_facets(struct pp_facets *facets)
{
    const struct pp_world *world = facets->world;
    struct pp_bounds3 all = pp_bounds3_empty();
    facets->room = pp_bounds3_empty();
    for (int i = 0; i < facets->corner_count; i++)
        pp_bounds3_add(&facets->room, facets->corners[i]);
    for (int i = 0; i < world->surface_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++)
            pp_bounds3_add(&all, world->surfaces[i].outline.vertices[k]);
    if (facets->corner_count == 0)
        facets->room = all;
    if (world->surface_count == 0)
        facets->room = all = (struct pp_bounds3){.low = {0.0, 0.0, 0.0}};
    struct pp_vec3 middle = pp_bounds3_middle(&facets->room);
    facets->reach_m =
        pp_vec_length(pp_vec(fmax(all.high.x - middle.x, middle.x - all.low.x),
                             fmax(all.high.y - middle.y, middle.y - all.low.y),
                             fmax(all.high.z - middle.z, middle.z - all.low.z)));
}

static enum pp_status fill_facets(struct pp_facets *facets, struct pp_error *err)
{
    const struct pp_world *world = facets->world;
    struct pp_clipper *clipper = NULL;
    enum pp_status status = pp_clipper_create(&clipper, err);
    for (int i = 0; status == PP_OK && i < facets->count; i++) {
        struct pp_facet *facet = &facets->list[i];
        int opening = i - world->surface_count;
        if (opening < 0)
            set_surface(facet, world, i);
        else
            set_pane(facet, world, opening);
        if (facet->side[0].indoors)
            status = pp_facet_pieces_add(facets, i, clipper, err);
    }
    pp_clipper_destroy(clipper);
    measure_facets(facets);
    return status == PP_OK ? add_rays(facets, err) : status;
}

enum pp_status pp_facets_create(struct pp_facets **result, const struct pp_world *world,
                                struct pp_error *err)
{
    *result = NULL;
    struct pp_facets *facets = calloc(1, sizeof *facets);
    if (!facets)
        return pp_fail_memory(err);
    facets->world = world;
    facets->count = world->surface_count + world->opening_count;
    facets->list = calloc((size_t)facets->count + 1, sizeof *facets->list);
    enum pp_status status =
        facets->list ? fill_facets(facets, err) : pp_fail_memory(err);
    if (status != PP_OK) {
        pp_facets_destroy(facets);
        return status;
    }
    *result = facets;
    return PP_OK;
}

void pp_facets_destroy(struct pp_facets *facets)
{
    if (!facets)
        return;
    for (int i = 0; facets->list && i < facets->count; i++)
        pp_region_clear(&facets->list[i].region);
    pp_ray_tree_destroy(facets->rays);
    free(facets->list);
    free(facets->pieces);
    free(facets->corners);
    free(facets);
}

double pp_facets_element_m(const struct pp_facets *facets)
{
    struct pp_vec3 extent = pp_vec_sub(facets->room.high, facets->room.low);
    double least = fmin(extent.x, fmin(extent.y, extent.z)), area = 0.0;
    for (int i = 0; i < facets->piece_count; i++) {
        const struct pp_piece *piece = &facets->pieces[i];
        struct pp_vec3 sum =
            pp_polygon_area_vector(&facets->corners[piece->first_corner], piece->count);
        area += pp_vec_length(sum);
    }
    return fmax(0.7 * least, fmax(sqrt(area / 1000.0), 0.01));
}
