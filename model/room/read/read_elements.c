/* read_elements.c - see read_elements.h. */
#include "model/room/read/read_elements.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/room/read/element_form.h"
#include "model/room/read/read_fitting.h"
#include "model/room/read/read_material.h"
#include "model/room/read/read_opening.h"
#include "model/room/read/read_outline.h"
#include "model/room/read/read_outside.h"
#include "model/room/read/read_shape.h"
#include "model/room/read/read_sky.h"
#include "model/room/read/reader.h"
#include "model/room/sky_words.h"

const struct pp_xml_format pp_read_elements_format = {
    .file = "room file",
    .roots = "a <room> or a <building>",
    .bytes_most = PP_READ_ELEMENTS_BYTES_MOST,
    .depth_most = 8,
    .elements_most = 200000,
    .attributes_only = true,
};

/* First and last month of trees without leaves in the north, by default; in the south
 * they are half a year later. */
enum { BARE_FROM = 11, BARE_TO = 4 };

static int half_a_year_after(int month)
{
    return (month + 5) % 12 + 1;
}

static void read_site(struct pp_reader *r, struct pp_room *room,
                      const struct pp_xml_element *e)
{
    struct pp_site_form form;
    if (!pp_reader_fill_form(r, &form, &pp_rule_site, e))
        return;
    if (form.country
        && (strlen(form.country) != 2
            || strspn(form.country, "ABCDEFGHIJKLMNOPQRSTUVWXYZ") != 2)) {
        pp_mistakes_add(
            r->mistakes, e->line,
            "site: country is \"%.40s\"; expected two capital letters, such as \"GB\"",
            form.country);
        return;
    }
    if (form.country && strcmp(form.country, "UK") == 0) {
        pp_mistakes_add(r->mistakes, e->line,
                        "site: country is \"UK\", which is not an ISO 3166 code; did "
                        "you mean \"GB\"?");
        return;
    }
    bool is_south = form.latitude_rad < 0.0;
    enum pp_work by_place = form.surroundings == PP_INDUSTRIAL ? PP_DIRTY : PP_CLEAN;
    room->site_is_own = true;
    room->site = (struct pp_site_part){
        .latitude_rad = form.latitude_rad,
        .longitude_rad = form.longitude_rad,
        .surroundings = (enum pp_surroundings)form.surroundings,
        .work = form.work < 0 ? by_place : (enum pp_work)form.work,
        .ground_reflectance = form.ground.reflectance,
        .ground_level_m = form.ground_level_m,
        .ground_is_open = form.ground_is_open != 0,
        .dirt = (enum pp_dirt)form.dirt,
        .bare_from = form.bare_from > 0 ? form.bare_from
                     : is_south         ? half_a_year_after(BARE_FROM)
                                        : BARE_FROM,
        .bare_to = form.bare_to > 0 ? form.bare_to
                   : is_south       ? half_a_year_after(BARE_TO)
                                    : BARE_TO,
        .line = e->line};
    pp_read_outside_trees(r, room, e);
    snprintf(room->site.country, sizeof room->site.country, "%s",
             form.country ? form.country : "");
}

/* Reads <project>, which belongs to the root and holds for the whole file. */
static void read_project(struct pp_reader *r, struct pp_building *building,
                         const struct pp_xml_element *root)
{
    for (const struct pp_xml_element *e = root->child; e; e = e->next) {
        struct pp_project_form form;
        if (pp_element_form_matches(e, &pp_rule_project)
            && pp_reader_fill_form(r, &form, &pp_rule_project, e))
            for (int i = 0; i < PP_PROJECT_FACTS; i++) {
                const char **place = pp_project_place(&building->project, i);
                free((char *)*place);
                *place = pp_reader_copy_text(r, form.facts[i]);
            }
    }
}

static void read_finishes(struct pp_reader *r, struct pp_room *room,
                          const struct pp_xml_element *e)
{
    struct pp_finishes_form form;
    if (!pp_reader_fill_form(r, &form, &pp_rule_finishes, e))
        return;
    room->floor = form.floor.reflectance;
    room->walls = form.walls.reflectance;
    room->ceiling = form.ceiling.reflectance;
    room->floor_finish = form.floor.finish;
    room->walls_finish = form.walls.finish;
    room->ceiling_finish = form.ceiling.finish;
    room->decorations = form.decorations;
}

static void read_finish(struct pp_reader *r, struct pp_room *room,
                        const struct pp_xml_element *e)
{
    struct pp_finish_form form;
    if (!pp_reader_fill_form(r, &form, &pp_rule_finish, e))
        return;
    if (PP_READER_RESERVE(r, room->finishes, room->finish_count))
        room->finishes[room->finish_count++] = (struct pp_finish_part){
            pp_reader_copy_text(r, form.wall), form.finish.reflectance,
            form.finish.finish, e->line};
}

static void read_wall(struct pp_reader *r, struct pp_room *room,
                      const struct pp_xml_element *e)
{
    struct pp_wall_form form;
    if (pp_reader_fill_form(r, &form, &pp_rule_wall, e)
        && PP_READER_RESERVE(r, room->wall_kinds, room->wall_kind_count))
        room->wall_kinds[room->wall_kind_count++] = (struct pp_wall_part){
            pp_reader_copy_text(r, form.name), form.kind != 0, e->line};
}

static void read_working_plane(struct pp_reader *r, struct pp_room *room,
                               const struct pp_xml_element *e)
{
    struct pp_plane_form form;
    if (!pp_reader_fill_form(r, &form, &pp_rule_working_plane, e))
        return;
    room->working_plane_m = form.height_m;
    room->working_plane_line = e->line;
}

/* Reads the normal; (0, 0, 1) if none is given. Reports an incomplete or zero normal
 * and returns false. */
static bool normal_of(struct pp_reader *r, struct pp_vec3 *normal,
                      const struct pp_receiver_form *form,
                      const struct pp_xml_element *e)
{
    int given = !isnan(form->nx) + !isnan(form->ny) + !isnan(form->nz);
    *normal = given ? pp_vec(form->nx, form->ny, form->nz) : pp_vec(0.0, 0.0, 1.0);
    if (given == 1 || given == 2) {
        pp_mistakes_add(r->mistakes, e->line,
                        "point: its normal is incomplete; expected nx, ny and nz");
        return false;
    }
    if (!(pp_vec_length(*normal) > 0.0)) {
        pp_mistakes_add(r->mistakes, e->line,
                        "point: its normal (nx, ny, nz) is 0; expected a direction");
        return false;
    }
    return true;
}

static void read_receiver(struct pp_reader *r, struct pp_room *room,
                          const struct pp_xml_element *e, enum pp_receiver_kind kind,
                          const struct pp_element_rule *rule)
{
    struct pp_receiver_form form = {.x = NAN,
                                    .y = NAN,
                                    .z = NAN,
                                    .nx = NAN,
                                    .ny = NAN,
                                    .nz = NAN,
                                    .spacing_m = NAN,
                                    .margin_m = NAN};
    struct pp_receiver_part part = {.kind = kind, .line = e->line};
    if (!pp_reader_fill_form(r, &form, rule, e)
        || !normal_of(r, &part.normal, &form, e))
        return;
    if (kind == PP_LINE && form.from[0] == form.to[0] && form.from[1] == form.to[1]) {
        pp_mistakes_add(r->mistakes, e->line, "line: from and to are the same point");
        return;
    }
    part.x = form.x;
    part.y = form.y;
    part.z = form.z;
    memcpy(part.from, form.from, sizeof part.from);
    memcpy(part.to, form.to, sizeof part.to);
    part.points = form.points;
    part.spacing_m = form.spacing_m;
    part.margin_m = form.margin_m;
    if (PP_READER_RESERVE(r, room->receivers, room->receiver_count))
        room->receivers[room->receiver_count++] = part;
}

static void read_view(struct pp_reader *r, struct pp_room *room,
                      const struct pp_xml_element *e)
{
    struct pp_view_form form = {0};
    if (!pp_reader_fill_form(r, &form, &pp_rule_view, e)
        || !PP_READER_RESERVE(r, room->views, room->view_count))
        return;
    room->views[room->view_count++] =
        (struct pp_view_part){.name = pp_reader_copy_text(r, form.name),
                              .x = form.x,
                              .y = form.y,
                              .z = form.z,
                              .bearing_rad = form.bearing_rad,
                              .line = e->line};
}

/* Adds a door or a dado. */
static void add_cover(struct pp_reader *r, struct pp_room *room,
                      enum pp_cover_kind kind, const struct pp_element_rule *rule,
                      const struct pp_xml_element *e)
{
    struct pp_cover_form form = {0};
    if (!pp_reader_fill_form(r, &form, rule, e)
        || !PP_READER_RESERVE(r, room->covers, room->cover_count))
        return;
    room->covers[room->cover_count++] =
        (struct pp_cover_part){.kind = kind,
                               .name = pp_reader_copy_text(r, form.name),
                               .wall = pp_reader_copy_text(r, form.wall),
                               .left_m = form.left_m,
                               .width_m = form.width_m,
                               .height_m = form.height_m,
                               .reflectance = form.finish.reflectance,
                               .finish = form.finish.finish,
                               .line = e->line};
}

static void read_door(struct pp_reader *r, struct pp_room *room,
                      const struct pp_xml_element *e)
{
    add_cover(r, room, PP_DOOR, &pp_rule_door, e);
}

static void read_dado(struct pp_reader *r, struct pp_room *room,
                      const struct pp_xml_element *e)
{
    add_cover(r, room, PP_DADO, &pp_rule_dado, e);
}

/* Reads a child of a room by its rule. */
static void read_child(struct pp_reader *r, struct pp_room *room,
                       const struct pp_xml_element *e)
{
    static const struct {
        const struct pp_element_rule *rule;
        void (*read)(struct pp_reader *, struct pp_room *,
                     const struct pp_xml_element *);
    } plain[] = {
        {&pp_rule_plan, pp_read_shape_plan},
        {&pp_rule_envelope, pp_read_shape_envelope},
        {&pp_rule_finishes, read_finishes},
        {&pp_rule_finish, read_finish},
        {&pp_rule_wall, read_wall},
        {&pp_rule_skyline, pp_read_outside_skyline},
        {&pp_rule_facade, pp_read_outside_facade},
        {&pp_rule_block, pp_read_outside_block},
        {&pp_rule_surface, pp_read_outside_surface},
        {&pp_rule_mesh, pp_read_outside_mesh},
        {&pp_rule_outline, pp_read_outline},
        {&pp_rule_garden, pp_read_outside_garden},
        {&pp_rule_furniture, pp_read_fitting_furniture},
        {&pp_rule_column, pp_read_fitting_column},
        {&pp_rule_partition, pp_read_fitting_partition},
        {&pp_rule_door, read_door},
        {&pp_rule_dado, read_dado},
        {&pp_rule_view, read_view},
        {&pp_rule_working_plane, read_working_plane},
    };
    for (size_t i = 0; i < sizeof plain / sizeof *plain; i++)
        if (pp_element_form_matches(e, plain[i].rule))
            plain[i].read(r, room, e);
    if (pp_element_form_matches(e, &pp_rule_site))
        read_site(r, room, e);
    else if (pp_element_form_matches(e, &pp_rule_sky))
        pp_read_sky(r, &room->sky, e);
    else if (pp_element_form_matches(e, &pp_rule_window))
        pp_read_opening(r, room, e, PP_WINDOW, &pp_rule_window);
    else if (pp_element_form_matches(e, &pp_rule_rooflight))
        pp_read_opening(r, room, e, PP_ROOFLIGHT, &pp_rule_rooflight);
    else if (pp_element_form_matches(e, &pp_rule_opening))
        pp_read_opening(r, room, e, PP_OPENING, &pp_rule_opening);
    else if (pp_element_form_matches(e, &pp_rule_point))
        read_receiver(r, room, e, PP_POINT, &pp_rule_point);
    else if (pp_element_form_matches(e, &pp_rule_line))
        read_receiver(r, room, e, PP_LINE, &pp_rule_line);
    else if (pp_element_form_matches(e, &pp_rule_grid))
        read_receiver(r, room, e, PP_GRID, &pp_rule_grid);
}

/* Site of a room or building without an element <site>. */
static const struct pp_site_part plain_site = {.latitude_rad = NAN,
                                               .longitude_rad = NAN,
                                               .ground_reflectance = 0.2,
                                               .bare_from = BARE_FROM,
                                               .bare_to = BARE_TO};

/* Sets the room's name, placement and bearing, and the defaults of its elements. */
static void begin_room(struct pp_reader *r, struct pp_room *room,
                       const struct pp_room_form *form)
{
    room->name = pp_reader_copy_text(r, form->name);
    room->ref = pp_reader_copy_text(r, form->ref);
    room->address = pp_reader_copy_text(r, form->address);
    room->use = (enum pp_room_use)form->use;
    room->state = (enum pp_site_state)form->state;
    room->north_rad = form->north_rad;
    room->placement = (struct pp_placement){
        .given = !isnan(form->x) || !isnan(form->y) || !isnan(form->z)
                 || !isnan(form->rotate_rad),
        .x = isnan(form->x) ? 0.0 : form->x,
        .y = isnan(form->y) ? 0.0 : form->y,
        .z = isnan(form->z) ? 0.0 : form->z,
        .rotate_rad = isnan(form->rotate_rad) ? 0.0 : form->rotate_rad};
    room->floor = 0.2;
    room->walls = 0.5;
    room->ceiling = 0.7;
    room->decorations = 1.0;
    room->working_plane_m = 0.85;
}

/* Sets the path of the coarse model that the room is nested in, if there is one.
 * building.c reads the file. */
static void read_within(struct pp_reader *r, struct pp_room *room,
                        const struct pp_room_form *form, int line)
{
    if (form->window && !form->within)
        pp_mistakes_add(r->mistakes, line,
                        "room: window is given without within; expected both");
    if (!form->within)
        return;
    if (!r->folder) {
        pp_mistakes_add(r->mistakes, line,
                        "room: the room was not read from a file, so the file of "
                        "within cannot be located; expected a room read from a file");
        return;
    }
    room->within.path = pp_reader_path(r, form->within);
    room->within.window = pp_reader_copy_text(r, form->window);
    room->within.line = line;
}

static void read_room(struct pp_reader *r, struct pp_room *room,
                      const struct pp_xml_element *e, bool root)
{
    struct pp_room_form form = {
        .north_rad = NAN, .x = NAN, .y = NAN, .z = NAN, .rotate_rad = NAN};
    bool good =
        pp_reader_fill_form(r, &form, root ? &pp_rule_room : &pp_rule_building_room, e);
    if (root && form.version < 0 && e->ended && !pp_reader_should_stop(r))
        pp_mistakes_add(r->mistakes, e->line,
                        "room: version is missing; expected \"1\"");
    if (root && form.units == 1)
        r->per_metre = 1000.0;
    room->line = e->line;
    if (!good)
        form.north_rad = form.x = form.y = form.z = form.rotate_rad = NAN;
    begin_room(r, room, &form);
    if (good)
        read_within(r, room, &form, e->line);
    for (const struct pp_xml_element *c = e->child; c && !pp_reader_should_stop(r);
         c = c->next)
        read_child(r, room, c);
    pp_read_shape_check(r, e);
}

/* Reports skylines of a building that have a distance. A building's skyline has the
 * same angle for all rooms on all floors, so it cannot have a distance. */
static void check_common_skylines(struct pp_reader *r, const struct pp_room *common)
{
    for (int i = 0; i < common->skyline_count; i++)
        if (isfinite(common->skylines[i].distance_m))
            pp_mistakes_add(
                r->mistakes, common->skylines[i].line,
                "skyline: has a distance, but a skyline of a building has the same "
                "angle for all rooms; expected no distance, or a <block> instead");
}

static void read_building(struct pp_reader *r, struct pp_building *building,
                          const struct pp_xml_element *e)
{
    struct pp_building_form form = {.north_rad = NAN, .glass_reflectance = NAN};
    struct pp_room *common = &building->common;
    common->site = plain_site;
    common->sky = pp_sky_words_default();
    pp_reader_fill_form(r, &form, &pp_rule_building, e);
    if (form.units == 1)
        r->per_metre = 1000.0;
    building->name = pp_reader_copy_text(r, form.name);
    common->north_rad = form.north_rad;
    building->glass_reflectance = form.glass_reflectance;
    common->line = e->line;
    /* Elements common to all rooms may follow the rooms. */
    for (const struct pp_xml_element *c = e->child; c && !pp_reader_should_stop(r);
         c = c->next)
        if (!pp_element_form_matches(c, &pp_rule_building_room))
            read_child(r, common, c);
    check_common_skylines(r, common);
    int placed = 0;
    pp_read_outside_stand_on_ground(common);
    for (const struct pp_xml_element *c = e->child; c && !pp_reader_should_stop(r);
         c = c->next) {
        if (!pp_element_form_matches(c, &pp_rule_building_room)
            || !PP_READER_RESERVE(r, building->read, building->read_count))
            continue;
        struct pp_room *room = &building->read[building->read_count++];
        *room = (struct pp_room){.site = common->site,
                                 .sky = pp_sky_words_copy(&common->sky)};
        read_room(r, room, c, false);
        if (room->placement.given && ++placed == PP_ROOM_PLACED_MOST + 1)
            pp_mistakes_add(r->mistakes, room->line,
                            "room: the building has more than %d placed rooms; "
                            "expected at most %d, and blocks for the others",
                            PP_ROOM_PLACED_MOST, PP_ROOM_PLACED_MOST);
        if (room->placement.given && !isnan(room->north_rad))
            pp_mistakes_add(r->mistakes, room->line,
                            "room: has its own north, but is placed in the building; "
                            "expected north only in the building");
        if (room->placement.given && !room->site_is_own)
            room->site.ground_level_m -= room->placement.z;
        pp_read_outside_stand_on_ground(room);
    }
}

enum pp_status pp_read_elements(struct pp_building *building, const struct pp_xml *xml,
                                const char *folder, struct pp_mistakes *mistakes,
                                struct pp_error *err)
{
    struct pp_reader r = {.mistakes = mistakes, .per_metre = 1.0, .folder = folder};
    const struct pp_xml_element *root = xml->root;
    building->glass_reflectance = NAN;
    if (!root)
        return PP_OK;
    if (pp_element_form_matches(root, &pp_rule_building)
        || pp_element_form_matches(root, &pp_rule_room))
        pp_read_materials(&r, root);
    if (pp_element_form_matches(root, &pp_rule_building)) {
        read_building(&r, building, root);
        read_project(&r, building, root);
    } else if (pp_element_form_matches(root, &pp_rule_room)) {
        if (PP_READER_RESERVE(&r, building->read, building->read_count)) {
            building->read[0] =
                (struct pp_room){.site = plain_site, .sky = pp_sky_words_default()};
            building->read_count = 1;
            read_room(&r, building->read, root, true);
            read_project(&r, building, root);
            pp_read_outside_stand_on_ground(building->read);
        }
    } else if (xml->whole) {
        char shown[160];
        pp_mistakes_add(mistakes, root->line,
                        "the file contains a <%s>; expected a <room> or a <building>",
                        pp_text_excerpt(shown, sizeof shown, root->name));
    }
    building->common.materials = pp_rough_finishes_hold(r.materials);
    for (int i = 0; i < building->read_count; i++)
        building->read[i].materials = pp_rough_finishes_hold(r.materials);
    pp_rough_finishes_release(r.materials);
    return r.out_of_memory ? pp_fail_memory(err) : PP_OK;
}
