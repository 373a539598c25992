/* room_read.c - see room_read.h. */
#include "model/room_read.h"

#include <stdlib.h>
#include <string.h>

#include "model/glazing_table.h"
#include "model/nearest.h"
#include "model/room_schema.h"

enum { GLASSES_MOST = 64 };

struct reader {
    struct pp_mistakes *mistakes;
    int bad_elements;
    bool out_of_memory;
    void *moved; /* RESERVE's */

    /* The table's glazings, once met (panes > 0): each takes an integral. */
    struct pp_glass glasses[GLASSES_MOST];
};

/* Nothing more to be gained by reading on? */
static bool gives_up(const struct reader *r)
{
    return r->out_of_memory || r->bad_elements > PP_MISTAKES_MOST;
}

/* The list with room for one more behind its `count`, moved if need be; NULL when
 * memory is out. */
static void *grown(struct reader *r, void *list, int count, size_t size)
{
    if (count > 0 && (count & (count - 1)) != 0)
        return list;
    void *moved = realloc(list, size * (count > 0 ? 2 * (size_t)count : 1));
    if (!moved)
        r->out_of_memory = true;
    return moved;
}

/* Makes sure that the list can take one more; false when memory is out. */
#define RESERVE(r, list, count)                                                        \
    ((r)->moved = grown(r, list, count, sizeof *(list)),                               \
     (r)->moved ? ((list) = (r)->moved, true) : false)

static char *copy_text(struct reader *r, const char *text)
{
    char *copy = text ? strdup(text) : NULL;
    if (text && !copy)
        r->out_of_memory = true;
    return copy;
}

/* Attributes into form, and the children's names and numbers checked. False where
 * there is a mistake, or where the file breaks off within the element: then there is
 * nothing more to be said of it. */
static bool read_form(struct reader *r, void *form, const struct pp_element_rule *rule,
                      const struct pp_xml_element *element)
{
    if (gives_up(r))
        return false;
    bool good = pp_form_fill(form, rule, element, r->mistakes);
    good = pp_children_check(rule, element, r->mistakes) && good;
    r->bad_elements += !good;
    return good && element->ended;
}

static void clear_vertices(struct pp_vertices *vertices)
{
    free(vertices->list);
    free(vertices->lines);
    *vertices = (struct pp_vertices){0};
}

static bool read_vertices(struct reader *r, struct pp_vertices *vertices,
                          const struct pp_element_rule *rule,
                          const struct pp_xml_element *parent)
{
    bool good = true;
    for (const struct pp_xml_element *c = parent->child; c && !gives_up(r);
         c = c->next) {
        struct pp_vertex_form form = {0};
        if (!pp_is(c, rule))
            continue;
        if (!read_form(r, &form, rule, c)) {
            good = false;
            continue;
        }
        int count = vertices->count;
        if (!RESERVE(r, vertices->lines, count) || !RESERVE(r, vertices->list, count))
            return false;
        vertices->lines[count] = c->line;
        vertices->list[count] = pp_vec(form.x, form.y, form.z);
        vertices->count++;
    }
    return good && !gives_up(r);
}

static void read_site(struct reader *r, struct pp_site_part *site,
                      const struct pp_xml_element *e)
{
    struct pp_site_form form;
    if (!read_form(r, &form, &pp_rule_site, e))
        return;
    *site =
        (struct pp_site_part){.latitude_rad = form.latitude_rad,
                              .longitude_rad = form.longitude_rad,
                              .surroundings = (enum pp_surroundings)form.surroundings,
                              .ground_reflectance = form.ground_reflectance,
                              .ground_level_m = form.ground_level_m,
                              .line = e->line};
}

static void read_sky(struct reader *r, struct pp_sky_part *sky,
                     const struct pp_xml_element *e)
{
    struct pp_sky_form form;
    if (!read_form(r, &form, &pp_rule_sky, e))
        return;
    int iso = form.type > 1 ? form.type - 1 : 0;
    bool altitude = !isnan(form.sun_altitude_rad),
         bearing = !isnan(form.sun_bearing_rad);
    if (iso > 0 && pp_sky_iso_has_sun(iso) && !(altitude && bearing)) {
        pp_mistake(r->mistakes, e->line,
                   "sky: %s needs to know where the sun stands; %s missing",
                   pp_sky_words[form.type],
                   altitude  ? "sun-bearing is"
                   : bearing ? "sun-altitude is"
                             : "sun-altitude and sun-bearing are");
        return;
    }
    *sky = (struct pp_sky_part){.kind = form.type == 0   ? PP_SKY_OVERCAST
                                        : form.type == 1 ? PP_SKY_UNIFORM
                                                         : PP_SKY_ISO,
                                .iso = iso,
                                .sun_altitude_rad = form.sun_altitude_rad,
                                .sun_bearing_rad = form.sun_bearing_rad,
                                .line = e->line};
}

/* What is wrong with the way a plan's outline is given, or NULL. */
static const char *plan_fault(const struct pp_plan_form *form, int vertices)
{
    bool width = !isnan(form->width_m), depth = !isnan(form->depth_m);
    if (vertices > 0 && (width || depth))
        return "width or depth and vertices are both given; expected width and depth, "
               "or three or more vertices";
    if (vertices > 0)
        return vertices < 3 ? "fewer than three vertices; expected three or more"
                            : NULL;
    if (width && depth)
        return NULL;
    return width   ? "depth is missing; a rectangle needs width and depth"
           : depth ? "width is missing; a rectangle needs width and depth"
                   : "no outline is given; expected width and depth, or three or more "
                     "vertices";
}

static void read_plan(struct reader *r, struct pp_room *room,
                      const struct pp_xml_element *e)
{
    struct pp_plan_form form;
    struct pp_plan_part plan = {.line = e->line};
    bool good = read_form(r, &form, &pp_rule_plan, e);
    good = read_vertices(r, &plan.vertices, &pp_rule_plan_vertex, e) && good;
    if (good) {
        const char *fault = plan_fault(&form, plan.vertices.count);
        if (fault)
            pp_mistake(r->mistakes, e->line, "plan: %s", fault);
        good = !fault;
    }
    if (!good || room->plan.line) {
        clear_vertices(&plan.vertices);
        return;
    }
    plan.rectangle = plan.vertices.count == 0;
    plan.width_m = form.width_m;
    plan.depth_m = form.depth_m;
    plan.height_m = form.height_m;
    room->plan = plan;
}

static void clear_faces(struct pp_plan_part *plan)
{
    for (int i = 0; i < plan->face_count; i++) {
        free(plan->faces[i].name);
        clear_vertices(&plan->faces[i].vertices);
    }
    free(plan->faces);
}

static bool read_face(struct reader *r, struct pp_plan_part *plan,
                      const struct pp_xml_element *e)
{
    struct pp_face_form form;
    bool good = read_form(r, &form, &pp_rule_face, e);
    struct pp_face_part face = {.line = e->line};
    good = read_vertices(r, &face.vertices, &pp_rule_vertex, e) && good;
    if (good) {
        face.role = form.role == 0 ? PP_FLOOR : form.role == 1 ? PP_WALL : PP_CEILING;
        face.reflectance = form.reflectance;
        face.name = copy_text(r, form.name);
    }
    if (good && RESERVE(r, plan->faces, plan->face_count)) {
        plan->faces[plan->face_count++] = face;
        return true;
    }
    free(face.name);
    clear_vertices(&face.vertices);
    return false;
}

static void read_envelope(struct reader *r, struct pp_room *room,
                          const struct pp_xml_element *e)
{
    struct pp_plan_part plan = {.envelope = true,
                                .width_m = NAN,
                                .depth_m = NAN,
                                .height_m = NAN,
                                .line = e->line};
    bool good = read_form(r, NULL, &pp_rule_envelope, e);
    for (const struct pp_xml_element *c = e->child; c && !gives_up(r); c = c->next)
        if (pp_is(c, &pp_rule_face))
            good = read_face(r, &plan, c) && good;
    if (!good || room->plan.line)
        clear_faces(&plan);
    else
        room->plan = plan;
}

static void read_finishes(struct reader *r, struct pp_room *room,
                          const struct pp_xml_element *e)
{
    struct pp_finishes_form form;
    if (!read_form(r, &form, &pp_rule_finishes, e))
        return;
    room->floor = form.floor;
    room->walls = form.walls;
    room->ceiling = form.ceiling;
}

static void read_finish(struct reader *r, struct pp_room *room,
                        const struct pp_xml_element *e)
{
    struct pp_finish_form form;
    if (!read_form(r, &form, &pp_rule_finish, e))
        return;
    if (RESERVE(r, room->finishes, room->finish_count))
        room->finishes[room->finish_count++] =
            (struct pp_finish_part){copy_text(r, form.wall), form.reflectance, e->line};
}

static struct pp_glass named_glass(struct reader *r, const char *name)
{
    const struct pp_glazing *glazing = pp_glazing_find(name);
    if (!glazing)
        return pp_glass_none(); /* the form has let through no other name */
    size_t index = (size_t)(glazing - pp_glazing_at(0));
    if (index >= GLASSES_MOST)
        return pp_glazing_glass(glazing);
    if (r->glasses[index].panes == 0)
        r->glasses[index] = pp_glazing_glass(glazing);
    return r->glasses[index];
}

/* The glass that the attributes describe; false where they contradict each other. */
static bool glass_of(struct reader *r, struct pp_glass *glass,
                     const struct pp_opening_form *form, const struct pp_xml_element *e)
{
    bool by_number = !isnan(form->transmittance);
    if (by_number && form->glazing) {
        pp_mistake(r->mistakes, e->line,
                   "%s: glazing and transmittance are both given; expected one of them",
                   e->name);
        return false;
    }
    if (by_number) {
        *glass = form->diffusing == 1 ? pp_glass_diffusing(form->transmittance)
                                      : pp_glass_scaled(named_glass(r, "clear-single"),
                                                        form->transmittance);
        return true;
    }
    const char *name = form->glazing ? form->glazing : "clear-single";
    *glass = named_glass(r, name);
    if (form->diffusing < 0 || form->diffusing == (int)glass->diffusing)
        return true;
    pp_mistake(r->mistakes, e->line,
               "%s: diffusing is \"%s\", but the glazing \"%s\" is %s; expected a "
               "transmittance, or a glazing that is",
               e->name, form->diffusing ? "yes" : "no", name,
               glass->diffusing ? "diffusing" : "not");
    return false;
}

static void read_opening(struct reader *r, struct pp_room *room,
                         const struct pp_xml_element *e, enum pp_opening_kind kind,
                         const struct pp_element_rule *rule)
{
    /* The fields that the other kinds have stay at "not given". */
    struct pp_opening_form form = {.left_m = NAN,
                                   .sill_m = NAN,
                                   .width_m = NAN,
                                   .height_m = NAN,
                                   .x = NAN,
                                   .y = NAN,
                                   .depth_m = NAN};
    struct pp_opening_part part = {.kind = kind, .line = e->line};
    bool good = read_form(r, &form, rule, e);
    if (kind == PP_OPENING)
        good = read_vertices(r, &part.vertices, &pp_rule_vertex, e) && good;
    good = good && glass_of(r, &part.glazing.glass, &form, e);
    if (!good || !RESERVE(r, room->openings, room->opening_count)) {
        clear_vertices(&part.vertices);
        return;
    }
    part.glazing.frame_factor = form.frame_factor;
    part.glazing.maintenance = form.maintenance;
    part.glazing.reveal_m = form.reveal_m;
    part.left_m = form.left_m;
    part.sill_m = form.sill_m;
    part.width_m = form.width_m;
    part.height_m = form.height_m;
    part.x = form.x;
    part.y = form.y;
    part.depth_m = form.depth_m;
    part.wall = copy_text(r, form.wall);
    room->openings[room->opening_count++] = part;
}

static void read_skyline(struct reader *r, struct pp_room *room,
                         const struct pp_xml_element *e)
{
    struct pp_skyline_form form;
    if (read_form(r, &form, &pp_rule_skyline, e)
        && RESERVE(r, room->skylines, room->skyline_count))
        room->skylines[room->skyline_count++] =
            (struct pp_skyline_part){copy_text(r, form.wall), form.angle_rad,
                                     form.distance_m, form.reflectance, e->line};
}

static void read_block(struct reader *r, struct pp_room *room,
                       const struct pp_xml_element *e)
{
    struct pp_block_form form;
    if (read_form(r, &form, &pp_rule_block, e)
        && RESERVE(r, room->blocks, room->block_count))
        room->blocks[room->block_count++] =
            (struct pp_block){.corner = pp_vec(form.x, form.y, form.base),
                              .width_m = form.width_m,
                              .depth_m = form.depth_m,
                              .height_m = form.height_m,
                              .rotate_rad = form.rotate_rad,
                              .reflectance = form.reflectance,
                              .line = e->line};
}

static void read_surface(struct reader *r, struct pp_room *room,
                         const struct pp_xml_element *e)
{
    struct pp_loose_form form;
    struct pp_surface_part part = {.line = e->line};
    bool good = read_form(r, &form, &pp_rule_surface, e);
    good = read_vertices(r, &part.vertices, &pp_rule_vertex, e) && good;
    if (!good || !RESERVE(r, room->surfaces, room->surface_count)) {
        clear_vertices(&part.vertices);
        return;
    }
    part.reflectance = form.reflectance;
    part.exitance = form.exitance;
    room->surfaces[room->surface_count++] = part;
}

static void read_working_plane(struct reader *r, struct pp_room *room,
                               const struct pp_xml_element *e)
{
    struct pp_plane_form form;
    if (!read_form(r, &form, &pp_rule_working_plane, e))
        return;
    room->working_plane_m = form.height_m;
    room->working_plane_line = e->line;
}

/* Fills in the normal, (0, 0, 1) if none is given; false where it is given in part or
 * is none. */
static bool normal_of(struct reader *r, struct pp_vec3 *normal,
                      const struct pp_receiver_form *form,
                      const struct pp_xml_element *e)
{
    int given = !isnan(form->nx) + !isnan(form->ny) + !isnan(form->nz);
    *normal = given ? pp_vec(form->nx, form->ny, form->nz) : pp_vec(0.0, 0.0, 1.0);
    if (given == 1 || given == 2) {
        pp_mistake(r->mistakes, e->line,
                   "point: only a part of the normal is given; expected nx, ny and nz");
        return false;
    }
    if (!(pp_length(*normal) > 0.0)) {
        pp_mistake(r->mistakes, e->line,
                   "point: its normal nx, ny, nz is 0; expected a direction");
        return false;
    }
    return true;
}

static void read_receiver(struct reader *r, struct pp_room *room,
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
    if (!read_form(r, &form, rule, e) || !normal_of(r, &part.normal, &form, e))
        return;
    if (kind == PP_LINE && form.from[0] == form.to[0] && form.from[1] == form.to[1]) {
        pp_mistake(r->mistakes, e->line, "line: from and to are the same place");
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
    if (RESERVE(r, room->receivers, room->receiver_count))
        room->receivers[room->receiver_count++] = part;
}

/* One child of a room, which its rule names. */
static void read_child(struct reader *r, struct pp_room *room,
                       const struct pp_xml_element *e)
{
    static const struct {
        const struct pp_element_rule *rule;
        void (*read)(struct reader *, struct pp_room *, const struct pp_xml_element *);
    } plain[] = {
        {&pp_rule_plan, read_plan},
        {&pp_rule_envelope, read_envelope},
        {&pp_rule_finishes, read_finishes},
        {&pp_rule_finish, read_finish},
        {&pp_rule_skyline, read_skyline},
        {&pp_rule_block, read_block},
        {&pp_rule_surface, read_surface},
        {&pp_rule_working_plane, read_working_plane},
    };
    for (size_t i = 0; i < sizeof plain / sizeof *plain; i++)
        if (pp_is(e, plain[i].rule))
            plain[i].read(r, room, e);
    if (pp_is(e, &pp_rule_site))
        read_site(r, &room->site, e);
    else if (pp_is(e, &pp_rule_sky))
        read_sky(r, &room->sky, e);
    else if (pp_is(e, &pp_rule_window))
        read_opening(r, room, e, PP_WINDOW, &pp_rule_window);
    else if (pp_is(e, &pp_rule_rooflight))
        read_opening(r, room, e, PP_ROOFLIGHT, &pp_rule_rooflight);
    else if (pp_is(e, &pp_rule_opening))
        read_opening(r, room, e, PP_OPENING, &pp_rule_opening);
    else if (pp_is(e, &pp_rule_point))
        read_receiver(r, room, e, PP_POINT, &pp_rule_point);
    else if (pp_is(e, &pp_rule_line))
        read_receiver(r, room, e, PP_LINE, &pp_rule_line);
    else if (pp_is(e, &pp_rule_grid))
        read_receiver(r, room, e, PP_GRID, &pp_rule_grid);
}

/* Plan and envelope: one of the two. */
static void check_outline(struct reader *r, const struct pp_xml_element *e)
{
    const struct pp_xml_element *outline = NULL;
    for (const struct pp_xml_element *c = e->child; c; c = c->next) {
        if (!pp_is(c, &pp_rule_plan) && !pp_is(c, &pp_rule_envelope))
            continue;
        if (outline && strcmp(outline->name, c->name) != 0) {
            pp_mistake(r->mistakes, c->line,
                       "room: <%s> beside the <%s> of line %d; expected one of them",
                       c->name, outline->name, outline->line);
            return;
        }
        outline = outline ? outline : c;
    }
    static const char *const shapes[] = {"plan", "envelope", NULL};
    for (const struct pp_xml_element *c = e->child; c && !outline; c = c->next)
        if (pp_nearest(c->name, shapes, -1))
            outline = c; /* misspelt: it has been said */
    if (!outline && e->ended)
        pp_mistake(r->mistakes, e->line,
                   "room: it has no shape; expected a <plan> or an <envelope>");
}

static const struct pp_site_part plain_site = {
    .latitude_rad = NAN, .longitude_rad = NAN, .ground_reflectance = 0.2};
static const struct pp_sky_part plain_sky = {
    .kind = PP_SKY_OVERCAST, .sun_altitude_rad = NAN, .sun_bearing_rad = NAN};

static void read_room(struct reader *r, struct pp_room *room,
                      const struct pp_xml_element *e, bool root)
{
    struct pp_room_form form;
    bool good = read_form(r, &form, &pp_rule_room, e);
    if (root && form.version < 0 && e->ended && !gives_up(r))
        pp_mistake(r->mistakes, e->line, "room: version is missing; expected \"1\"");
    room->line = e->line;
    room->north_rad = good ? form.north_rad : 0.0;
    room->name = copy_text(r, form.name);
    room->floor = 0.2;
    room->walls = 0.5;
    room->ceiling = 0.7;
    room->working_plane_m = 0.85;
    for (const struct pp_xml_element *c = e->child; c && !gives_up(r); c = c->next)
        read_child(r, room, c);
    check_outline(r, e);
    for (int i = 0; i < room->block_count; i++)
        if (isnan(room->blocks[i].corner.z))
            room->blocks[i].corner.z = room->site.ground_level_m;
}

static void read_building(struct reader *r, struct pp_building *building,
                          const struct pp_xml_element *e)
{
    struct pp_building_form form;
    struct pp_site_part site = plain_site;
    struct pp_sky_part sky = plain_sky;
    read_form(r, &form, &pp_rule_building, e);
    building->name = copy_text(r, form.name);
    /* What stands for all rooms may come behind them. */
    for (const struct pp_xml_element *c = e->child; c && !gives_up(r); c = c->next)
        if (pp_is(c, &pp_rule_site))
            read_site(r, &site, c);
        else if (pp_is(c, &pp_rule_sky))
            read_sky(r, &sky, c);
    for (const struct pp_xml_element *c = e->child; c && !gives_up(r); c = c->next) {
        if (!pp_is(c, &pp_rule_room)
            || !RESERVE(r, building->rooms, building->room_count))
            continue;
        struct pp_room *room = &building->rooms[building->room_count++];
        *room = (struct pp_room){.site = site, .sky = sky};
        read_room(r, room, c, false);
    }
}

enum pp_status pp_building_fill(struct pp_building *building, const struct pp_xml *xml,
                                struct pp_mistakes *mistakes, struct pp_error *err)
{
    struct reader r = {.mistakes = mistakes};
    const struct pp_xml_element *root = xml->root;
    if (!root)
        return PP_OK;
    if (pp_is(root, &pp_rule_building)) {
        read_building(&r, building, root);
    } else if (pp_is(root, &pp_rule_room)) {
        if (RESERVE(&r, building->rooms, building->room_count)) {
            building->rooms[0] = (struct pp_room){.site = plain_site, .sky = plain_sky};
            building->room_count = 1;
            read_room(&r, building->rooms, root, true);
        }
    } else if (xml->whole) {
        char shown[160];
        pp_mistake(mistakes, root->line,
                   "the file holds a <%s>; expected a <room> or a <building>",
                   pp_excerpt(shown, sizeof shown, root->name));
    }
    return r.out_of_memory ? pp_fail_memory(err) : PP_OK;
}

void pp_room_clear(struct pp_room *room)
{
    free(room->name);
    clear_vertices(&room->plan.vertices);
    clear_faces(&room->plan);
    for (int i = 0; i < room->finish_count; i++)
        free(room->finishes[i].wall);
    for (int i = 0; i < room->opening_count; i++) {
        free(room->openings[i].wall);
        clear_vertices(&room->openings[i].vertices);
    }
    for (int i = 0; i < room->skyline_count; i++)
        free(room->skylines[i].wall);
    for (int i = 0; i < room->surface_count; i++)
        clear_vertices(&room->surfaces[i].vertices);
    free(room->finishes);
    free(room->openings);
    free(room->skylines);
    free(room->blocks);
    free(room->surfaces);
    free(room->receivers);
    *room = (struct pp_room){0};
}
