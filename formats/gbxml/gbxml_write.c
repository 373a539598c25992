/* gbxml_write.c - writes one element per line and records the line of each item. */
#include "formats/gbxml/gbxml_write.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"

/* ---- lines ---- */

static void put_gbxml(struct pp_gbxml_writing *w, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void put_gbxml(struct pp_gbxml_writing *w, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vfprintf(w->out, format, arguments);
    va_end(arguments);
}

static void end_line(struct pp_gbxml_writing *w)
{
    fputc('\n', w->out);
    w->line++;
}

/* Writes an attribute from text of the gbXML file. XML's special characters are
 * escaped, white space and control characters are reduced to single spaces, and text is
 * cut off at 100 characters. */
static void put_words(struct pp_gbxml_writing *w, const char *name, const char *words)
{
    put_gbxml(w, " %s=\"", name);
    for (int i = 0, written = 0; words[i] && written < 100; i++) {
        unsigned char c = (unsigned char)words[i];
        if (c < 0x20 || c == 0x7f)
            c = ' ';
        if (c == ' ' && (!words[i + 1] || isspace((unsigned char)words[i + 1])))
            continue;
        written++;
        if (c == '&')
            put_gbxml(w, "&amp;");
        else if (c == '<')
            put_gbxml(w, "&lt;");
        else if (c == '"')
            put_gbxml(w, "&quot;");
        else
            fputc(c, w->out);
        /* Never cuts a UTF-8 sequence. */
        while (((unsigned char)words[i + 1] & 0xc0) == 0x80)
            fputc(words[++i], w->out);
    }
    put_gbxml(w, "\"");
}

/* Writes a length in metres, rounded to 0.01 mm, without trailing zeros. */
static void put_length(struct pp_gbxml_writing *w, const char *name, double value_m)
{
    char text[40];
    snprintf(text, sizeof text, "%.5f", value_m);
    char *end = text + strlen(text);
    while (end[-1] == '0')
        *--end = '\0';
    if (end[-1] == '.')
        *--end = '\0';
    put_gbxml(w, " %s=\"%s\"", name, strcmp(text, "-0") == 0 ? "0" : text);
}

static void put_corner(struct pp_gbxml_writing *w, struct pp_vec3 at)
{
    put_gbxml(w, "<vertex");
    put_length(w, "x", at.x);
    put_length(w, "y", at.y);
    put_length(w, "z", at.z);
    put_gbxml(w, "/>");
}

static enum pp_status note_item(struct pp_gbxml_writing *w,
                                struct pp_gbxml_written item, struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&w->items, w->item_count, sizeof *w->items, err);
    item.last = w->line - 1;
    if (status == PP_OK)
        w->items[w->item_count++] = item;
    return status;
}

/* ---- openings ---- */

static void put_glazing(struct pp_gbxml_writing *w,
                        const struct pp_gbxml_opening *opening)
{
    if (opening->is_air)
        put_gbxml(w, " glazing=\"none\"");
    else if (isnan(opening->transmittance))
        put_gbxml(w, " glazing=\"clear-double\"");
    else
        put_gbxml(w, " transmittance=\"%.4g\"", opening->transmittance);
    if (opening->name)
        put_words(w, "name", opening->name);
}

/* Extent in a wall of a box, seen from outside: left to right and upwards. */
struct wall_extent {
    int wall; /* index into south, east, north, west */
    double left, right, low, high, area;
};

static const char *const walls[] = {"south", "east", "north", "west"};

/* Index of the box wall that contains the face; -1: none. */
static int wall_of(const struct pp_gbxml_room *room, int face)
{
    struct pp_vec3 normal = pp_gbxml_shell_normal(&room->shell, face);
    double c = cos(room->rotate_rad), s = sin(room->rotate_rad);
    double x = c * normal.x + s * normal.y, y = c * normal.y - s * normal.x;
    if (room->faces[face].role != PP_GBXML_WALL)
        return -1;
    return fabs(y) > fabs(x) ? (y > 0.0 ? 0 : 2) : (x < 0.0 ? 1 : 3);
}

static struct wall_extent find_wall_extent(const struct pp_gbxml_room *room,
                                           const struct pp_gbxml_room_opening *opening)
{
    struct wall_extent e = {
        wall_of(room, opening->face), INFINITY, -INFINITY, INFINITY, -INFINITY, 0.0};
    double u0 = 0.0, v0 = 0.0, u1 = 0.0, v1 = 0.0;
    for (int i = 0; i <= opening->count; i++) {
        struct pp_vec3 at =
            pp_gbxml_room_own(room, opening->corners[i % opening->count]);
        double along = e.wall == 0   ? at.x
                       : e.wall == 1 ? at.y
                       : e.wall == 2 ? room->width_m - at.x
                                     : room->depth_m - at.y;
        u1 = along, v1 = at.z;
        if (i > 0)
            e.area += 0.5 * (u0 * v1 - u1 * v0);
        u0 = u1, v0 = v1;
        e.left = fmin(e.left, along), e.right = fmax(e.right, along);
        e.low = fmin(e.low, at.z), e.high = fmax(e.high, at.z);
    }
    return e;
}

static enum pp_status write_opening(struct pp_gbxml_writing *w,
                                    const struct pp_gbxml_room *room,
                                    const struct pp_gbxml_room_opening *opening,
                                    struct pp_error *err)
{
    struct pp_gbxml_written item = {w->line,
                                    0,
                                    opening->opening->line,
                                    "opening",
                                    opening->opening->name,
                                    &opening->opening->left_out};
    struct wall_extent e = find_wall_extent(room, opening);
    double area = (e.right - e.left) * (e.high - e.low);
    if (room->is_box && e.wall >= 0 && fabs(fabs(e.area) - area) < 1e-3 * area) {
        put_gbxml(w, "    <window wall=\"%s\"", walls[e.wall]);
        put_length(w, "left", fmax(e.left, 0.0));
        put_length(w, "sill", fmax(e.low, 0.0));
        put_length(w, "width", e.right - fmax(e.left, 0.0));
        put_length(w, "height", e.high - fmax(e.low, 0.0));
        put_glazing(w, opening->opening);
        put_gbxml(w, "/>");
        end_line(w);
        return note_item(w, item, err);
    }
    put_gbxml(w, "    <opening");
    put_glazing(w, opening->opening);
    put_gbxml(w, ">");
    for (int i = 0; i < opening->count; i++)
        put_corner(w, pp_gbxml_room_own(room, opening->corners[i]));
    put_gbxml(w, "</opening>");
    end_line(w);
    return note_item(w, item, err);
}

/* ---- rooms ---- */

static const char *const roles[] = {[PP_GBXML_FLOOR] = "floor",
                                    [PP_GBXML_WALL] = "wall",
                                    [PP_GBXML_CEILING] = "ceiling"};

static void put_reflectance(struct pp_gbxml_writing *w, const char *name, double value)
{
    if (isfinite(value))
        put_gbxml(w, " %s=\"%.4g\"", name, value);
}

static void write_box(struct pp_gbxml_writing *w, const struct pp_gbxml_room *room)
{
    static const char *const names[] = {"floor", "walls", "ceiling"};
    double reflectances[3] = {NAN, NAN, NAN};
    put_gbxml(w, "    <plan");
    put_length(w, "width", room->width_m);
    put_length(w, "depth", room->depth_m);
    put_length(w, "height", room->height_m);
    put_gbxml(w, "/>");
    end_line(w);
    for (int i = 0; i < room->shell.face_count; i++)
        if (isfinite(room->faces[i].reflectance))
            reflectances[room->faces[i].role] = room->faces[i].reflectance;
    if (isnan(reflectances[0]) && isnan(reflectances[1]) && isnan(reflectances[2]))
        return;
    put_gbxml(w, "    <finishes");
    for (int k = 0; k < 3; k++)
        put_reflectance(w, names[k], reflectances[k]);
    put_gbxml(w, "/>");
    end_line(w);
}

static void write_envelope(struct pp_gbxml_writing *w, const struct pp_gbxml_room *room)
{
    put_gbxml(w, "    <envelope>");
    end_line(w);
    for (int i = 0; i < room->shell.face_count; i++) {
        const struct pp_gbxml_room_face *face = &room->faces[i];
        put_gbxml(w, "      <face role=\"%s\" name=\"%s\"", roles[face->role],
                  face->name);
        put_reflectance(w, "reflectance", face->reflectance);
        put_gbxml(w, ">");
        for (int k = 0; k < room->shell.faces[i].count; k++)
            put_corner(w,
                       pp_gbxml_room_own(
                           room, room->shell.corners[room->shell.faces[i].corners[k]]));
        put_gbxml(w, "</face>");
        end_line(w);
    }
    put_gbxml(w, "    </envelope>");
    end_line(w);
}

/* Writes working plane and grid, unless they have their default values. */
static void write_plane(struct pp_gbxml_writing *w, const struct pp_gbxml_room *room)
{
    if (isfinite(room->plane_m)) {
        put_gbxml(w, "    <working-plane");
        put_length(w, "height", room->plane_m);
        put_gbxml(w, "/>");
        end_line(w);
    }
    if (isfinite(room->spacing_m)) {
        put_gbxml(w, "    <grid spacing=\"%g\" margin=\"0.5\"/>", room->spacing_m);
        end_line(w);
    }
}

/* Writes the walls that have another space behind their whole area. */
static void write_inner_walls(struct pp_gbxml_writing *w,
                              const struct pp_gbxml_room *room)
{
    bool inner[4] = {false}, outer[4] = {false};
    for (int i = 0; i < room->shell.face_count; i++) {
        const struct pp_gbxml_room_face *face = &room->faces[i];
        int wall = room->is_box ? wall_of(room, i) : -1;
        if (wall >= 0)
            (face->inner ? inner : outer)[wall] = true;
        if (room->is_box || face->role != PP_GBXML_WALL || !face->inner)
            continue;
        put_gbxml(w, "    <wall name=\"%s\" kind=\"inner\"/>", face->name);
        end_line(w);
    }
    for (int k = 0; k < 4; k++)
        if (inner[k] && !outer[k]) {
            put_gbxml(w, "    <wall name=\"%s\" kind=\"inner\"/>", walls[k]);
            end_line(w);
        }
}

/* Use of a space, found by keywords in gbXML's space types; NULL if the type contains
 * none of them. */
static const char *use_of(const char *type)
{
    static const char *const uses[][2] = {{"Bedroom", "bedroom"},
                                          {"Dormitory", "bedroom"},
                                          {"LivingQuarters", "living-room"},
                                          {"LivingRoom", "living-room"},
                                          {"Dining", "dining-room"},
                                          {"Kitchen", "kitchen"},
                                          {"FoodPreparation", "kitchen"},
                                          {"Classroom", "classroom"},
                                          {"Lecture", "classroom"},
                                          {"Conference", "meeting-room"},
                                          {"Meeting", "meeting-room"},
                                          {"Patient", "ward"},
                                          {"Workshop", "workshop"},
                                          {"Sales", "shop"},
                                          {"Retail", "shop"},
                                          {"Restroom", "bathroom"},
                                          {"Corridor", "circulation"},
                                          {"Lobby", "circulation"},
                                          {"Stair", "circulation"},
                                          {"Atrium", "circulation"},
                                          {"Storage", "store"},
                                          {"Office", "office"}};
    for (int i = 0; type && i < (int)(sizeof uses / sizeof *uses); i++)
        if (strstr(type, uses[i][0]))
            return uses[i][1];
    return NULL;
}

static enum pp_status write_room(struct pp_gbxml_writing *w,
                                 struct pp_gbxml_space *space,
                                 const struct pp_gbxml_room *room, struct pp_error *err)
{
    struct pp_gbxml_written item = {w->line, 0,         space->line,
                                    "space", space->id, &space->left_out};
    const char *use = use_of(space->type);
    put_gbxml(w, "  <room");
    put_words(w, "name", space->name ? space->name : space->id);
    put_words(w, "ref", space->id);
    if (use)
        put_gbxml(w, " use=\"%s\"", use);
    put_length(w, "x", room->origin.x);
    put_length(w, "y", room->origin.y);
    put_length(w, "z", room->origin.z);
    if (room->rotate_rad != 0.0)
        put_gbxml(w, " rotate=\"%.8g\"", room->rotate_rad / PP_RAD);
    put_gbxml(w, ">");
    end_line(w);
    if (room->is_box)
        write_box(w, room);
    else
        write_envelope(w, room);
    write_inner_walls(w, room);
    write_plane(w, room);
    enum pp_status status = PP_OK;
    for (int i = 0; i < room->opening_count && status == PP_OK; i++)
        status = write_opening(w, room, &room->openings[i], err);
    put_gbxml(w, "  </room>");
    end_line(w);
    return status == PP_OK ? note_item(w, item, err) : status;
}

/* ---- outside ---- */

static enum pp_status write_surface(struct pp_gbxml_writing *w,
                                    struct pp_gbxml_surface *surface,
                                    struct pp_error *err)
{
    struct pp_gbxml_written item = {
        w->line, 0, surface->line, "surface", surface->type, &surface->left_out};
    put_gbxml(w, "  <surface>");
    for (int i = 0; i < surface->outline.count; i++)
        put_corner(w, surface->outline.corners[i]);
    put_gbxml(w, "</surface>");
    end_line(w);
    return note_item(w, item, err);
}

/* True if the surface bounds a space that has become a room. */
static bool has_room(const struct pp_gbxml_model *model,
                     struct pp_gbxml_room *const *rooms,
                     const struct pp_gbxml_surface *surface)
{
    for (int i = 0; i < model->space_count; i++)
        if (rooms[i] && pp_gbxml_model_bounds(surface, &model->spaces[i]))
            return true;
    return false;
}

/* True if the surface is exposed to the outside and belongs to no room. */
static bool stands_outside(const struct pp_gbxml_model *model,
                           struct pp_gbxml_room *const *rooms,
                           const struct pp_gbxml_surface *surface)
{
    static const char *const buried[] = {"Underground", "Slab", "Column", "Air"};
    if (surface->left_out)
        return false;
    if (strcmp(surface->type, "Shade") == 0)
        return true;
    for (int i = 0; i < 4; i++)
        if (strstr(surface->type, buried[i]))
            return false;
    return pp_gbxml_model_is_outer(surface) && !has_room(model, rooms, surface);
}

static void write_gbxml_head(struct pp_gbxml_writing *w,
                             const struct pp_gbxml_model *model)
{
    put_gbxml(w, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
    end_line(w);
    put_gbxml(w, "<building version=\"1\"");
    if (model->name && *model->name)
        put_words(w, "name", model->name);
    if (model->north_deg != 0.0)
        put_gbxml(w, " north=\"%.8g\"", model->north_deg);
    put_gbxml(w, ">");
    end_line(w);
    if (isfinite(model->latitude) && isfinite(model->longitude)) {
        put_gbxml(w, "  <site latitude=\"%.8g\" longitude=\"%.8g\"/>", model->latitude,
                  model->longitude);
        end_line(w);
    }
}

enum pp_status pp_gbxml_write(struct pp_gbxml_writing *w, struct pp_gbxml_model *model,
                              struct pp_gbxml_room *const *rooms, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    w->line = 1;
    w->item_count = 0;
    write_gbxml_head(w, model);
    for (int i = 0; i < model->surface_count && status == PP_OK; i++)
        if (stands_outside(model, rooms, &model->surfaces[i]))
            status = write_surface(w, &model->surfaces[i], err);
    for (int i = 0; i < model->space_count && status == PP_OK; i++)
        if (rooms[i])
            status = write_room(w, &model->spaces[i], rooms[i], err);
    put_gbxml(w, "</building>");
    end_line(w);
    return status;
}
