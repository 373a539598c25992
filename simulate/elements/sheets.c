/* sheets.c - materials, planes and triangles of a world's surfaces and panes. */
#include "simulate/elements/sheets.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "model/room/face_less_openings.h"
#include "model/room/surface_materials.h"
#include "simulate/elements/sheet_pieces.h"

double pp_sheet_straight(const struct pp_sheet *sheet, double cosine)
{
    const struct pp_opening *opening = sheet->opening;
    return pp_glass_transmittance(&opening->glass, cosine) * opening->frame_factor
           * opening->maintenance * opening->curtains;
}

double pp_sheet_mirrored(const struct pp_sheet *sheet, double cosine)
{
    return pp_glass_reflectance(&sheet->opening->glass, cosine)
           * sheet->opening->frame_factor;
}

/* ---- one sheet ---- */

static void set_plane(struct pp_sheet *sheet, const struct pp_polygon *outline)
{
    sheet->origin = outline->vertices[0];
    sheet->normal = outline->normal;
    pp_polygon_plane_axes(sheet->normal, &sheet->a, &sheet->b);
}

static void set_side(struct pp_sheet *sheet, int side, bool indoors,
                     const struct pp_material *material)
{
    sheet->side[side] =
        (struct pp_sheet_side){.indoors = indoors,
                               .reflectance = material->diffuse.g,
                               .exitance = PP_PI * material->radiance.g};
}

static void set_surface(struct pp_sheet *sheet, const struct pp_world *world, int index)
{
    const struct pp_surface *surface = &world->surfaces[index];
    set_plane(sheet, &surface->outline);
    sheet->envelope = index < world->face_count || surface->role == PP_REVEAL;
    for (int side = 0; side < 2; side++) {
        struct pp_material material =
            pp_surface_materials_matt(world, index, side == 0);
        set_side(sheet, side, surface->inside && !(sheet->envelope && side == 1),
                 &material);
    }
}

static void set_pane(struct pp_sheet *sheet, const struct pp_world *world, int index)
{
    const struct pp_opening *opening = &world->openings[index];
    set_plane(sheet, &opening->outer);
    sheet->opening = opening;
    sheet->envelope = true;
    sheet->clear = !opening->glass.diffusing;
    for (int side = 0; side < 2; side++) {
        struct pp_material material =
            pp_surface_materials_pane(world, index, side == 0);
        set_side(sheet, side, side == 0, &material);
        sheet->through = material.through_diffuse.g;
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

/* A surface outdoors, with the triangles that cover it where it is not convex. */
static enum pp_status cover(struct triangles *triangles,
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

static enum pp_status add_rays(struct pp_sheets *sheets, struct pp_error *err)
{
    struct triangles triangles = {NULL, 0, 0};
    enum pp_status status = PP_OK;
    for (int i = 0; status == PP_OK && i < sheets->count; i++) {
        const struct pp_sheet *sheet = &sheets->list[i];
        if (!sheet->side[0].indoors) {
            status = cover(&triangles, &sheets->world->surfaces[i], i, err);
            continue;
        }
        for (int k = 0; status == PP_OK && k < sheet->piece_count; k++) {
            const struct pp_piece *piece = &sheets->pieces[sheet->first_piece + k];
            status = fan(&triangles, &sheets->corners[piece->first_corner],
                         piece->count, i, err);
        }
    }
    if (status == PP_OK)
        status =
            pp_ray_tree_create(&sheets->rays, triangles.list, triangles.count, err);
    free(triangles.list);
    return status;
}

/* ---- all of them ---- */

static void measure(struct pp_sheets *sheets)
{
    const struct pp_world *world = sheets->world;
    struct pp_bounds3 all = pp_bounds3_empty();
    sheets->room = pp_bounds3_empty();
    for (int i = 0; i < sheets->corner_count; i++)
        pp_bounds3_add(&sheets->room, sheets->corners[i]);
    for (int i = 0; i < world->surface_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++)
            pp_bounds3_add(&all, world->surfaces[i].outline.vertices[k]);
    if (sheets->corner_count == 0)
        sheets->room = all;
    if (world->surface_count == 0)
        sheets->room = all = (struct pp_bounds3){.low = {0.0, 0.0, 0.0}};
    struct pp_vec3 middle =
        pp_vec_scale(pp_vec_add(sheets->room.low, sheets->room.high), 0.5);
    sheets->reach_m =
        pp_vec_length(pp_vec(fmax(all.high.x - middle.x, middle.x - all.low.x),
                             fmax(all.high.y - middle.y, middle.y - all.low.y),
                             fmax(all.high.z - middle.z, middle.z - all.low.z)));
}

static enum pp_status fill(struct pp_sheets *sheets, struct pp_error *err)
{
    const struct pp_world *world = sheets->world;
    struct pp_clipper *clipper = NULL;
    enum pp_status status = pp_clipper_create(&clipper, err);
    for (int i = 0; status == PP_OK && i < sheets->count; i++) {
        struct pp_sheet *sheet = &sheets->list[i];
        int opening = i - world->surface_count;
        if (opening < 0)
            set_surface(sheet, world, i);
        else
            set_pane(sheet, world, opening);
        if (sheet->side[0].indoors)
            status = pp_sheet_pieces_add(sheets, i, clipper, err);
    }
    pp_clipper_destroy(clipper);
    measure(sheets);
    return status == PP_OK ? add_rays(sheets, err) : status;
}

enum pp_status pp_sheets_create(struct pp_sheets **result, const struct pp_world *world,
                                struct pp_error *err)
{
    *result = NULL;
    struct pp_sheets *sheets = calloc(1, sizeof *sheets);
    if (!sheets)
        return pp_fail_memory(err);
    sheets->world = world;
    sheets->count = world->surface_count + world->opening_count;
    sheets->list = calloc((size_t)sheets->count + 1, sizeof *sheets->list);
    enum pp_status status = sheets->list ? fill(sheets, err) : pp_fail_memory(err);
    if (status != PP_OK) {
        pp_sheets_destroy(sheets);
        return status;
    }
    *result = sheets;
    return PP_OK;
}

void pp_sheets_destroy(struct pp_sheets *sheets)
{
    if (!sheets)
        return;
    for (int i = 0; sheets->list && i < sheets->count; i++)
        pp_region_clear(&sheets->list[i].region);
    pp_ray_tree_destroy(sheets->rays);
    free(sheets->list);
    free(sheets->pieces);
    free(sheets->corners);
    free(sheets);
}
