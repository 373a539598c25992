/* read_outside.c - see read_outside.h. */
#include "model/room/read/read_outside.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/polygon.h"
#include "model/mesh/mesh_file.h"
#include "model/room/read/block_shape.h"
#include "model/room/read/element_form.h"
#include "model/room/read/read_outline.h"

void pp_read_outside_skyline(struct pp_reader *r, struct pp_room *room,
                             const struct pp_xml_element *e)
{
    struct pp_skyline_form form;
    if (pp_reader_fill_form(r, &form, &pp_rule_skyline, e)
        && PP_READER_RESERVE(r, room->skylines, room->skyline_count))
        room->skylines[room->skyline_count++] =
            (struct pp_skyline_part){pp_reader_copy_text(r, form.wall),
                                     form.angle_rad,
                                     form.distance_m,
                                     form.finish.reflectance,
                                     (enum pp_site_state)form.state,
                                     e->line};
}

void pp_read_outside_garden(struct pp_reader *r, struct pp_room *room,
                            const struct pp_xml_element *e)
{
    struct pp_garden_form form;
    struct pp_garden_part part = {.line = e->line};
    bool good = pp_reader_fill_form(r, &form, &pp_rule_garden, e);
    good = pp_reader_add_vertices(r, &part.vertices, &pp_rule_plan_vertex, e) && good;
    if (!good || !PP_READER_RESERVE(r, room->gardens, room->garden_count)) {
        pp_room_parts_clear_vertices(&part.vertices);
        return;
    }
    part.name = pp_reader_copy_text(r, form.name);
    part.state = (enum pp_site_state)form.state;
    room->gardens[room->garden_count++] = part;
}

static void read_tree(struct pp_reader *r, struct pp_room *room,
                      const struct pp_xml_element *e)
{
    struct pp_tree_form form;
    if (!pp_reader_fill_form(r, &form, &pp_rule_tree, e))
        return;
    if (!(form.height_m - form.crown_base_m >= PP_ROOM_LENGTH_LEAST_M)) {
        pp_mistakes_add(r->mistakes, e->line,
                        "tree: its crown-base is %g m above the ground and its height "
                        "%g m; expected a crown-base below the height",
                        form.crown_base_m, form.height_m);
        return;
    }
    if (PP_READER_RESERVE(r, room->trees, room->tree_count))
        room->trees[room->tree_count++] = (struct pp_tree_part){
            .tree = {.foot = pp_vec(form.x, form.y, 0.0),
                     .height_m = form.height_m,
                     .crown_base_m = form.crown_base_m,
                     .crown_width_m = form.crown_width_m,
                     .transmittance = form.transmittance,
                     .winter_transmittance = isnan(form.winter_transmittance)
                                                 ? form.transmittance
                                                 : form.winter_transmittance,
                     .line = e->line},
            .state = (enum pp_site_state)form.state};
}

void pp_read_outside_trees(struct pp_reader *r, struct pp_room *room,
                           const struct pp_xml_element *site)
{
    for (const struct pp_xml_element *e = site->child; e; e = e->next)
        if (pp_element_form_matches(e, &pp_rule_tree))
            read_tree(r, room, e);
}

void pp_read_outside_facade(struct pp_reader *r, struct pp_room *room,
                            const struct pp_xml_element *e)
{
    struct pp_facade_form form;
    if (pp_reader_fill_form(r, &form, &pp_rule_facade, e)
        && PP_READER_RESERVE(r, room->facades, room->facade_count))
        room->facades[room->facade_count++] =
            (struct pp_facade_part){.wall = pp_reader_copy_text(r, form.wall),
                                    .left_m = form.left_m,
                                    .right_m = form.right_m,
                                    .up_m = form.up_m,
                                    .down_m = form.down_m,
                                    .depth_m = form.depth_m,
                                    .reflectance = form.finish.reflectance,
                                    .finish = form.finish.finish,
                                    .line = e->line};
}

/* Reads the triangles of a mesh file; NULL after a mistake. */
static struct pp_shared_mesh *read_mesh_file(struct pp_reader *r, const char *file,
                                             int line)
{
    if (!r->folder) {
        pp_mistakes_add(r->mistakes, line,
                        "mesh: the room was not read from a file, so its mesh file "
                        "cannot be located; expected a room read from a file");
        return NULL;
    }
    struct pp_shared_mesh *shared = calloc(1, sizeof *shared);
    char *path = pp_reader_path(r, file);
    struct pp_error fault = {0};
    enum pp_status status =
        shared && path ? pp_mesh_file_read(&shared->mesh, path, &fault) : PP_SYSTEM;
    free(path);
    if (status == PP_OK) {
        shared->holders = 1;
        return shared;
    }
    if (shared)
        pp_mesh_triangles_clear(&shared->mesh);
    free(shared);
    if (fault.message[0])
        pp_mistakes_add(r->mistakes, line, "mesh: %s", fault.message);
    else
        r->out_of_memory = true;
    return NULL;
}

void pp_read_outside_mesh(struct pp_reader *r, struct pp_room *room,
                          const struct pp_xml_element *e)
{
    struct pp_mesh_form form;
    if (!pp_reader_fill_form(r, &form, &pp_rule_mesh, e))
        return;
    struct pp_shared_mesh *file = read_mesh_file(r, form.file, e->line);
    if (!file || !PP_READER_RESERVE(r, room->meshes, room->mesh_count)) {
        r->bad_elements++;
        return;
    }
    double unit_m = file->mesh.unit_m > 0.0 ? file->mesh.unit_m : 1.0;
    room->meshes[room->mesh_count++] =
        (struct pp_mesh_part){.file = file,
                              .path = pp_reader_copy_text(r, form.file),
                              .name = pp_reader_copy_text(r, form.name),
                              .corner = pp_vec(form.x, form.y, form.z),
                              .scale = isnan(form.scale) ? unit_m : form.scale,
                              .rotate_rad = form.rotate_rad,
                              .y_is_up = form.up == 1,
                              .reflectance = form.finish.reflectance,
                              .finish = form.finish.finish,
                              .state = (enum pp_site_state)form.state,
                              .line = e->line};
}

/* Adds a polygon of a block; corners are in the block's own axes. */
static void add_block_face(struct pp_reader *r, struct pp_room *room,
                           const struct pp_block_form *form, int line,
                           const struct pp_vec3 *corners, int count)
{
    struct pp_surface_part part = {.reflectance = form->finish.reflectance,
                                   .finish = form->finish.finish,
                                   .state = (enum pp_site_state)form->state,
                                   .is_of_block = true,
                                   .is_on_ground = isnan(form->base),
                                   .line = line};
    double c = cos(form->rotate_rad), s = sin(form->rotate_rad);
    double base = isnan(form->base) ? 0.0 : form->base;
    for (int i = 0; i < count; i++) {
        if (!PP_READER_RESERVE(r, part.vertices.lines, i)
            || !PP_READER_RESERVE(r, part.vertices.list, i))
            break;
        part.vertices.lines[i] = line;
        part.vertices.list[i] =
            pp_vec(form->x + c * corners[i].x - s * corners[i].y,
                   form->y + s * corners[i].x + c * corners[i].y, base + corners[i].z);
        part.vertices.count++;
    }
    part.name = pp_reader_copy_text(r, form->name);
    if (part.vertices.count == count
        && PP_READER_RESERVE(r, room->surfaces, room->surface_count))
        room->surfaces[room->surface_count++] = part;
    else
        pp_room_parts_clear_surface(&part);
}

static void read_box(struct pp_reader *r, struct pp_room *room,
                     const struct pp_xml_element *e)
{
    struct pp_block_form form;
    if (!pp_reader_fill_form(r, &form, &pp_rule_block, e))
        return;
    bool is_flat = form.roof == PP_ROOF_FLAT, has_pitch = !isnan(form.pitch_rad);
    if (is_flat == has_pitch) {
        pp_mistakes_add(r->mistakes, e->line,
                        is_flat ? "block: has a pitch, but its roof is flat; expected "
                                  "a \"mono\", \"gable\" or \"hip\" roof"
                                : "block: pitch is missing; expected a number of "
                                  "degrees above 0, up to 85");
        return;
    }
    if (!PP_READER_RESERVE(r, room->blocks, room->block_count))
        return;
    room->blocks[room->block_count++] =
        (struct pp_block){.corner = pp_vec(form.x, form.y, form.base),
                          .width_m = form.width_m,
                          .depth_m = form.depth_m,
                          .height_m = form.height_m,
                          .rotate_rad = form.rotate_rad,
                          .reflectance = form.finish.reflectance,
                          .finish = form.finish.finish,
                          .name = pp_reader_copy_text(r, form.name),
                          .state = (enum pp_site_state)form.state,
                          .line = e->line};
    struct pp_block_shape_face faces[PP_BLOCK_SHAPE_ROOF_MOST];
    int count = pp_block_shape_roof(faces, form.width_m, form.depth_m, form.height_m,
                                    (enum pp_roof)form.roof, form.pitch_rad,
                                    (enum pp_ridge)form.ridge);
    for (int i = 0; i < count; i++)
        add_block_face(r, room, &form, e->line, faces[i].corners, faces[i].count);
}

/* Adds walls and a flat roof over the outline, which is counter-clockwise, and an
 * underside if the block has a base. */
static void raise_walls(struct pp_reader *r, struct pp_room *room,
                        const struct pp_block_form *form, int line,
                        struct pp_vertices *outline)
{
    int count = outline->count;
    struct pp_vec3 *ring = outline->list;
    for (int i = 0; i < count; i++) {
        struct pp_vec3 a = ring[i], b = ring[(i + 1) % count], up_a = a, up_b = b;
        up_a.z = up_b.z = form->height_m;
        add_block_face(r, room, form, line, (struct pp_vec3[]){a, b, up_b, up_a}, 4);
    }
    /* The underside of a block above the ground is visible. */
    if (!isnan(form->base))
        add_block_face(r, room, form, line, ring, count);
    for (int i = 0; i < count; i++)
        ring[i].z = form->height_m;
    add_block_face(r, room, form, line, ring, count);
}

static void read_footprint(struct pp_reader *r, struct pp_room *room,
                           const struct pp_xml_element *e)
{
    struct pp_block_form form = {.pitch_rad = NAN};
    struct pp_vertices outline = {0};
    bool good = pp_reader_fill_form(r, &form, &pp_rule_footprint, e);
    good = pp_reader_add_vertices(r, &outline, &pp_rule_plan_vertex, e) && good;
    if (good && !(pp_polygon_area_vector(outline.list, outline.count).z > 0.0)) {
        good = false;
        pp_mistakes_add(r->mistakes, e->line,
                        "block: its vertices are clockwise seen from above, or its "
                        "outline has no area; expected counter-clockwise vertices");
    }
    if (good)
        raise_walls(r, room, &form, e->line, &outline);
    pp_room_parts_clear_vertices(&outline);
}

void pp_read_outside_block(struct pp_reader *r, struct pp_room *room,
                           const struct pp_xml_element *e)
{
    for (const struct pp_xml_element *c = e->child; c; c = c->next)
        if (pp_element_form_matches(c, &pp_rule_plan_vertex)) {
            read_footprint(r, room, e);
            return;
        }
    read_box(r, room, e);
}

void pp_read_outside_stand_on_ground(struct pp_room *room)
{
    double ground = room->site.ground_level_m;
    for (int i = 0; i < room->block_count; i++)
        if (isnan(room->blocks[i].corner.z))
            room->blocks[i].corner.z = ground;
    for (int i = 0; i < room->surface_count; i++) {
        struct pp_surface_part *part = &room->surfaces[i];
        for (int k = 0; k < part->vertices.count && part->is_on_ground; k++)
            part->vertices.list[k].z += ground;
        part->is_on_ground = false;
    }
    for (int i = 0; i < room->mesh_count; i++)
        if (room->meshes[i].is_outline)
            pp_read_outline_stand(&room->meshes[i].file->mesh,
                                  ground - room->meshes[i].corner.z);
}

void pp_read_outside_surface(struct pp_reader *r, struct pp_room *room,
                             const struct pp_xml_element *e)
{
    struct pp_surface_form form;
    struct pp_surface_part part = {.line = e->line};
    bool good = pp_reader_fill_form(r, &form, &pp_rule_surface, e);
    good = pp_reader_add_vertices(r, &part.vertices, &pp_rule_vertex, e) && good;
    if (!good || !PP_READER_RESERVE(r, room->surfaces, room->surface_count)) {
        pp_room_parts_clear_vertices(&part.vertices);
        return;
    }
    part.reflectance = form.finish.reflectance;
    part.finish = form.finish.finish;
    part.exitance = form.exitance;
    part.name = pp_reader_copy_text(r, form.name);
    part.state = (enum pp_site_state)form.state;
    room->surfaces[room->surface_count++] = part;
}
