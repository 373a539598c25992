/* atlas_design.c - converts coordinates of the sweep to the dimensions of a room, and
 * writes the room file. */
#include "studies/research/atlas/atlas_design.h"

#include <math.h>
#include <stdbool.h>

#include "studies/research/atlas/atlas_layout.h"
#include "studies/research/atlas/atlas_outside.h"

static const char *const wall_names[PP_ATLAS_WALLS] = {"south", "east", "north",
                                                       "west"};

void pp_atlas_design_init(struct pp_atlas_design *design, enum pp_atlas_sky sky)
{
    design->sky = sky;
    pp_sobol_init(&design->sobol);
    pp_sobol_sequence_init(&design->sequence, &design->sobol, UINT64_C(20260101));
}

/* ---- the room itself ---- */

static void choose_shape(struct pp_atlas_layout *room)
{
    const struct pp_atlas_ranges *ranges = room->ranges;
    double u[6];
    pp_atlas_draw(room, PP_ATLAS_SHAPE, u);
    double area = pp_scaled_ends(ranges->area_m2, u[0]),
           ratio = pp_scaled_ends(ranges->ratio, u[1]);
    room->width = sqrt(area * ratio);
    room->depth = sqrt(area / ratio);
    room->roof = (enum pp_atlas_roof)PP_ONE_OF(ranges->roofs, &u[3]);
    /* Large rooms are higher. */
    double higher = 0.005 * area;
    room->eaves =
        pp_scaled(ranges->height_m[0] + higher, ranges->height_m[1] + higher, u[2]);
    room->plane = u[5] < 0.8 ? 0.85 : 0.7;
    if (room->roof == PP_ATLAS_FLAT)
        return;
    room->slope = tan(pp_between(8.0, 45.0, u[4]) * M_PI / 180.0);
    room->eaves = pp_between(1.3, 2.6, u[2]);
    /* Limits the height of the ceiling to 6 m. */
    double run = room->roof == PP_ATLAS_RIDGE ? 0.5 * room->width : room->depth;
    room->slope = fmin(room->slope, (6.0 - room->eaves) / run);
}

static double high_end(const struct pp_atlas_layout *room)
{
    double run = room->roof == PP_ATLAS_RIDGE ? 0.5 * room->width : room->depth;
    return room->eaves + (room->roof == PP_ATLAS_FLAT ? 0.0 : run * room->slope);
}

static void face(struct pp_atlas_layout *room, const char *role, const char *name,
                 const double (*v)[3], int count)
{
    PP_SAY(room, "    <face role=\"%s\" name=\"%s\">", role, name);
    for (int i = 0; i < count; i++)
        PP_SAY(room, "<vertex x=\"%.3f\" y=\"%.3f\" z=\"%.3f\"/>", v[i][0], v[i][1],
               v[i][2]);
    PP_SAY(room, "</face>\n");
}

#define FACE(room, role, name, ...)                                                    \
    face(room, role, name, (const double[][3]){__VA_ARGS__},                           \
         sizeof(const double[][3]){__VA_ARGS__} / sizeof(double[3]))

/* Writes the faces of a room whose ceiling slopes upwards from the south wall to the
 * north wall. */
static void put_mono_pitch(struct pp_atlas_layout *room, double w, double d, double low,
                           double high)
{
    FACE(room, "floor", "floor", {0, 0, 0}, {w, 0, 0}, {w, d, 0}, {0, d, 0});
    FACE(room, "wall", "south", {0, 0, 0}, {0, 0, low}, {w, 0, low}, {w, 0, 0});
    FACE(room, "wall", "east", {w, 0, 0}, {w, 0, low}, {w, d, high}, {w, d, 0});
    FACE(room, "wall", "north", {0, d, 0}, {w, d, 0}, {w, d, high}, {0, d, high});
    FACE(room, "wall", "west", {0, 0, 0}, {0, d, 0}, {0, d, high}, {0, 0, low});
    FACE(room, "ceiling", "slope", {0, 0, low}, {0, d, high}, {w, d, high},
         {w, 0, low});
}

/* Writes the faces of a room whose ceiling has a ridge from south to north, over the
 * middle of the room. */
static void put_ridge(struct pp_atlas_layout *room, double w, double d, double low,
                      double high)
{
    double m = 0.5 * w;
    FACE(room, "floor", "floor", {0, 0, 0}, {w, 0, 0}, {w, d, 0}, {0, d, 0});
    FACE(room, "wall", "south", {0, 0, 0}, {0, 0, low}, {m, 0, high}, {w, 0, low},
         {w, 0, 0});
    FACE(room, "wall", "east", {w, 0, 0}, {w, 0, low}, {w, d, low}, {w, d, 0});
    FACE(room, "wall", "north", {0, d, 0}, {w, d, 0}, {w, d, low}, {m, d, high},
         {0, d, low});
    FACE(room, "wall", "west", {0, 0, 0}, {0, d, 0}, {0, d, low}, {0, 0, low});
    FACE(room, "ceiling", "slope", {0, 0, low}, {0, d, low}, {m, d, high},
         {m, 0, high});
    FACE(room, "ceiling", "slope-2", {m, 0, high}, {m, d, high}, {w, d, low},
         {w, 0, low});
}

/* Rounds lengths to the digits that are printed, so that adjoining faces of the room
 * file meet exactly. */
static void round_shape(struct pp_atlas_layout *room)
{
    room->width = 0.01 * round(100.0 * room->width);
    room->depth = 0.01 * round(100.0 * room->depth);
    room->eaves = 0.01 * round(100.0 * room->eaves);
    double run = room->roof == PP_ATLAS_RIDGE ? 0.5 * room->width : room->depth;
    if (room->roof != PP_ATLAS_FLAT)
        room->slope = 0.001 * round(1000.0 * room->slope * run) / run;
}

static void put_shape(struct pp_atlas_layout *room)
{
    choose_shape(room);
    round_shape(room);
    double high = high_end(room);
    for (int i = 0; i < PP_ATLAS_WALLS; i++)
        room->lowest[i] = room->eaves;
    if (room->roof == PP_ATLAS_FLAT) {
        PP_SAY(room, "  <plan width=\"%.2f\" depth=\"%.2f\" height=\"%.2f\"/>\n",
               room->width, room->depth, room->eaves);
        return;
    }
    PP_SAY(room, "  <envelope>\n");
    if (room->roof == PP_ATLAS_MONO_PITCH)
        put_mono_pitch(room, room->width, room->depth, room->eaves, high);
    else
        put_ridge(room, room->width, room->depth, room->eaves, high);
    PP_SAY(room, "  </envelope>\n");
    if (room->roof == PP_ATLAS_MONO_PITCH)
        room->lowest[PP_ATLAS_NORTH] = fmin(high, 3.5);
    else /* height at which a gable is half as wide as its wall */
        room->lowest[PP_ATLAS_SOUTH] = room->lowest[PP_ATLAS_NORTH] =
            0.5 * (room->eaves + high);
}

static void put_finishes(struct pp_atlas_layout *room)
{
    double u[6];
    pp_atlas_draw(room, PP_ATLAS_FINISHES, u);
    PP_SAY(room, "  <finishes floor=\"%.2f\" walls=\"%.2f\" ceiling=\"%.2f\"/>\n",
           pp_between_ends(room->ranges->floor, u[0]),
           pp_between_ends(room->ranges->walls, u[1]),
           pp_between_ends(room->ranges->ceiling, u[2]));
}

/* ---- openings ---- */

/* Frame or maintenance factor: 1 if u is below 0.15; otherwise a value in the room's
 * range. */
static double clean(const struct pp_atlas_layout *room, double u)
{
    return u < 0.15 ? 1.0 : pp_between_ends(room->ranges->clean, (u - 0.15) / 0.85);
}

/* Writes the attributes common to all openings of a room. */
static void put_pane(struct pp_atlas_layout *room, bool upright)
{
    static const char *const names[PP_ATLAS_PANES] = {
        [PP_ATLAS_CLEAR_SINGLE] = "clear-single",
        [PP_ATLAS_CLEAR_DOUBLE] = "clear-double",
        [PP_ATLAS_LOW_E_DOUBLE] = "low-e-double",
        [PP_ATLAS_LOW_E_TRIPLE] = "low-e-triple",
        [PP_ATLAS_SOLAR_CONTROL] = "solar-control-medium",
        [PP_ATLAS_NO_PANE] = "none"};
    double u[6];
    pp_atlas_draw(room, PP_ATLAS_OPENINGS, u);
    const char *name = names[PP_ONE_OF(room->ranges->panes, &u[2])];
    if (name)
        PP_SAY(room, " glazing=\"%s\"", name);
    else
        PP_SAY(room, " transmittance=\"%.2f\"",
               pp_between_ends(room->ranges->transmittance, u[2]));
    PP_SAY(room, " frame-factor=\"%.2f\" maintenance=\"%.2f\"", clean(room, u[3]),
           clean(room, u[4]));
    if (upright && u[5] > 0.5)
        PP_SAY(room, " reveal=\"%.2f\"",
               pp_between_ends(room->ranges->reveal_m, 2.0 * u[5] - 1.0));
}

/* Puts up to four equal windows in a wall, but only one in a gable. */
static void put_windows(struct pp_atlas_layout *room, enum pp_atlas_wall wall,
                        enum pp_atlas_group group)
{
    static const double numbers[] = {0.5, 0.25, 0.15, 0.1};
    const struct pp_atlas_ranges *ranges = room->ranges;
    double u[6];
    pp_atlas_draw(room, group, u);
    double length =
        wall == PP_ATLAS_SOUTH || wall == PP_ATLAS_NORTH ? room->width : room->depth;
    double top = room->lowest[wall];
    bool gable = room->roof == PP_ATLAS_RIDGE
                 && (wall == PP_ATLAS_SOUTH || wall == PP_ATLAS_NORTH);
    enum pp_atlas_style style = (enum pp_atlas_style)PP_ONE_OF(ranges->styles, &u[5]);
    int count = gable ? 1 : 1 + PP_ONE_OF(numbers, &u[0]);
    double sill = style == PP_ATLAS_FRENCH ? 0.05
                  : style == PP_ATLAS_CLERESTORY
                      ? fmax(top - 1.1, 0.6)
                      : fmin(pp_between_ends(ranges->sill_m, u[2]), top - 0.8);
    double head =
        pp_between(fmin(sill + ranges->least_m, top - 0.05), top - 0.05, sqrt(u[3]));
    double share = pp_between(ranges->share[0], gable ? 0.45 : ranges->share[1], u[1]);
    while (count > 1 && share * length / count < 0.4)
        count--;
    double width = fmax(share * length / count, fmin(0.4, 0.9 * length));
    double gap = (length - count * width) / (count + 1);
    for (int i = 0; i < count; i++) {
        double left = gable        ? 0.5 * (length - width)
                      : count == 1 ? u[4] * (length - width)
                                   : gap + i * (width + gap);
        PP_SAY(room,
               "  <window wall=\"%s\" left=\"%.3f\" sill=\"%.2f\" width=\"%.3f\" "
               "height=\"%.2f\"",
               wall_names[wall], left, sill, width - 0.002, head - sill);
        put_pane(room, true);
        PP_SAY(room, "/>\n");
    }
    if (wall == PP_ATLAS_SOUTH)
        room->head = head;
}

/* Puts one to four rooflights in a flat ceiling, in a row from west to east. */
static void put_rooflights(struct pp_atlas_layout *room)
{
    double u[6];
    pp_atlas_draw(room, PP_ATLAS_ROOF, u);
    int count = 1 + (int)(4.0 * u[0]);
    double share = pp_between(0.1, 0.7, u[1]), width = share * room->width / count;
    double depth = pp_between(0.1, 0.7, u[2]) * room->depth;
    double gap = (room->width - count * width) / (count + 1);
    double y = 0.05 + u[3] * (room->depth - depth - 0.1);
    for (int i = 0; i < count; i++) {
        PP_SAY(room, "  <rooflight x=\"%.3f\" y=\"%.3f\" width=\"%.3f\" depth=\"%.3f\"",
               gap + i * (width + gap), y, width, depth);
        put_pane(room, false);
        PP_SAY(room, "/>\n");
    }
}

/* Puts one or two rectangular windows in a sloping ceiling: the slope at the south
 * wall, or the west slope of a ridge. */
static void put_roof_windows(struct pp_atlas_layout *room)
{
    double u[6];
    pp_atlas_draw(room, PP_ATLAS_ROOF, u);
    bool ridge = room->roof == PP_ATLAS_RIDGE;
    double along = ridge ? room->depth : room->width;
    double run = ridge ? 0.5 * room->width : room->depth;
    int count = 1 + (int)(2.0 * u[0]);
    double width = pp_between(0.15, 0.8, u[1]) * along / count;
    double up = pp_between(0.15, 0.7, u[2]) * run,
           from = 0.05 + u[3] * (run - up - 0.1);
    double gap = (along - count * width) / (count + 1);
    for (int i = 0; i < count; i++) {
        double a = gap + i * (width + gap), b = a + width;
        /* Corners as coordinates along the eaves and, in plan, up the slope,
         * counter-clockwise as seen from inside. */
        const double corners[4][2] = {
            {a, from}, {a, from + up}, {b, from + up}, {b, from}};
        PP_SAY(room, "  <opening");
        put_pane(room, false);
        PP_SAY(room, ">");
        for (int k = 0; k < 4; k++) {
            const double *c = corners[ridge ? 3 - k : k];
            PP_SAY(room, "<vertex x=\"%.4f\" y=\"%.4f\" z=\"%.6f\"/>",
                   ridge ? c[1] : c[0], ridge ? c[0] : c[1],
                   room->eaves + room->slope * 1e-4 * round(1e4 * c[1]));
        }
        PP_SAY(room, "</opening>\n");
    }
}

/* Writes the openings; returns true if there are windows in walls. */
static bool put_openings(struct pp_atlas_layout *room)
{
    const struct pp_atlas_ranges *ranges = room->ranges;
    double u[6];
    pp_atlas_draw(room, PP_ATLAS_OPENINGS, u);
    enum pp_atlas_place place = (enum pp_atlas_place)PP_ONE_OF(ranges->places, &u[0]);
    if (place != PP_ATLAS_ROOF_ONLY)
        put_windows(room, PP_ATLAS_SOUTH, PP_ATLAS_WALL_1);
    if (place == PP_ATLAS_CORNER)
        put_windows(room, PP_ATLAS_EAST, PP_ATLAS_WALL_2);
    if (place == PP_ATLAS_OPPOSITE)
        put_windows(room, PP_ATLAS_NORTH, PP_ATLAS_WALL_2);
    /* Half of the rooms with windows in walls and a sloping ceiling also have roof
     * windows. */
    if (place == PP_ATLAS_ROOF_ONLY
        || u[1] < (room->roof == PP_ATLAS_FLAT ? ranges->rooflights : 0.5)) {
        if (room->roof == PP_ATLAS_FLAT)
            put_rooflights(room);
        else
            put_roof_windows(room);
    }
    return place != PP_ATLAS_ROOF_ONLY;
}

/* ---- points ---- */

/* Writes the points, at least 0.25 m from the walls, and where the ceiling is at least
 * 0.3 m above the plane. */
static void put_points(struct pp_atlas_layout *room)
{
    const double margin = 0.25;
    double low[2] = {margin, margin};
    double high[2] = {room->width - margin, room->depth - margin};
    double short_of = room->plane + 0.3 - room->eaves;
    if (short_of > 0.0 && room->roof == PP_ATLAS_MONO_PITCH)
        low[1] = fmax(low[1], short_of / room->slope);
    if (short_of > 0.0 && room->roof == PP_ATLAS_RIDGE) {
        low[0] = fmax(low[0], short_of / room->slope);
        high[0] = room->width - low[0];
    }
    PP_SAY(room, "  <working-plane height=\"%.2f\"/>\n", room->plane);
    for (int i = 0; i < PP_ATLAS_POINTS; i++) {
        double u[2];
        pp_sobol_sequence_draw(&room->design->sequence,
                               PP_ATLAS_POINTS * room->index + (uint32_t)i,
                               PP_ATLAS_POINT, 2, u);
        PP_SAY(room, "  <point x=\"%.3f\" y=\"%.3f\"/>\n",
               pp_between(low[0], high[0], u[0]), pp_between(low[1], high[1], u[1]));
    }
}

void pp_atlas_design_room(const struct pp_atlas_design *design, uint32_t index,
                          char xml[PP_ATLAS_XML])
{
    struct pp_atlas_layout room = {.design = design, .index = index, .xml = xml};
    xml[0] = '\0';
    PP_SAY(&room,
           "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<room version=\"1\" name=\"Atlas room %u\">\n",
           (unsigned)index);
    double u[6];
    pp_atlas_draw(&room, PP_ATLAS_PLACE, u);
    room.ranges = u[2] < 0.5 ? &pp_atlas_ordinary : &pp_atlas_unusual;
    pp_atlas_outside_site(&room);
    put_shape(&room);
    put_finishes(&room);
    pp_atlas_outside_put(&room, put_openings(&room));
    put_points(&room);
    PP_SAY(&room, "</room>\n");
}
