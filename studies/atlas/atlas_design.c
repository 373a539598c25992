/* atlas_design.c - from coordinates to lengths, and from these to a room file. */
#include "studies/atlas/atlas_design.h"

#include <math.h>
#include <stdbool.h>

#include "model/base/text.h"

/* The groups of coordinates that a room takes, six each; a point takes two of its own. */
enum group {
    SHAPE,
    FINISHES,
    OPENINGS,
    WALL_1,
    WALL_2,
    ROOF,
    OUTSIDE,
    PLACE,
    SKY,
    POINT
};

enum roof { FLAT, MONO_PITCH, RIDGE };

enum wall { SOUTH, EAST, NORTH, WEST, WALLS };
static const char *const wall_names[WALLS] = {"south", "east", "north", "west"};

/* A room that is being laid out. Lengths in m; the south wall lies along y = 0. */
struct layout {
    const struct pp_atlas_design *design;
    uint32_t index;
    char *xml;

    enum roof roof;
    double width, depth;
    double eaves;         /* height of the walls; of the lowest one under slopes */
    double slope;         /* rise of the ceiling over a metre */
    double plane;         /* height of the working plane */
    double ground;        /* z of the ground outside */
    double lowest[WALLS]; /* height that a window has in that wall */
    double head;          /* of the highest window in the south wall */
};

void pp_atlas_design_init(struct pp_atlas_design *design, enum pp_atlas_sky sky)
{
    design->sky = sky;
    pp_sobol_init(&design->sobol);
    pp_sobol_sequence_init(&design->sequence, &design->sobol, UINT64_C(20260101));
}

/* ---- numbers ---- */

static void draw(const struct layout *room, enum group group, double u[6])
{
    pp_sobol_sequence_draw(&room->design->sequence, room->index, group, 6, u);
}

static double between(double low, double high, double u)
{
    return low + (high - low) * u;
}

/* Evenly in the logarithm. */
static double scaled(double low, double high, double u)
{
    return low * pow(high / low, u);
}

/* Which of several, with these shares of 1; u is left as a number in (0, 1) of its own. */
static int one_of(const double *shares, int count, double *u)
{
    int chosen = 0;
    while (chosen < count - 1 && *u >= shares[chosen])
        *u -= shares[chosen++];
    *u /= shares[chosen];
    return chosen;
}

#define ONE_OF(shares, u) one_of(shares, sizeof shares / sizeof shares[0], u)

#define SAY(room, ...) pp_text_append((room)->xml, PP_ATLAS_XML, __VA_ARGS__)

/* ---- the room itself ---- */

static void choose_shape(struct layout *room)
{
    static const double roofs[] = {0.85, 0.08, 0.07};
    double u[6];
    draw(room, SHAPE, u);
    double area = scaled(6.0, 120.0, u[0]), ratio = scaled(0.4, 2.5, u[1]);
    room->width = sqrt(area * ratio);
    room->depth = sqrt(area / ratio);
    room->roof = (enum roof)ONE_OF(roofs, &u[3]);
    /* Large rooms are higher. */
    double lowest = 2.3 + 0.005 * area;
    room->eaves = scaled(lowest, lowest + 1.3, u[2]);
    room->plane = u[5] < 0.8 ? 0.85 : 0.7;
    if (room->roof == FLAT)
        return;
    room->slope = tan(between(8.0, 45.0, u[4]) * M_PI / 180.0);
    room->eaves = between(1.3, 2.6, u[2]);
    /* No ceiling above 6 m. */
    double run = room->roof == RIDGE ? 0.5 * room->width : room->depth;
    room->slope = fmin(room->slope, (6.0 - room->eaves) / run);
}

static double high_end(const struct layout *room)
{
    double run = room->roof == RIDGE ? 0.5 * room->width : room->depth;
    return room->eaves + (room->roof == FLAT ? 0.0 : run * room->slope);
}

static void face(struct layout *room, const char *role, const char *name,
                 const double (*v)[3], int count)
{
    SAY(room, "    <face role=\"%s\" name=\"%s\">", role, name);
    for (int i = 0; i < count; i++)
        SAY(room, "<vertex x=\"%.3f\" y=\"%.3f\" z=\"%.3f\"/>", v[i][0], v[i][1],
            v[i][2]);
    SAY(room, "</face>\n");
}

#define FACE(room, role, name, ...)                                                    \
    face(room, role, name, (const double[][3]){__VA_ARGS__},                           \
         sizeof(const double[][3]){__VA_ARGS__} / sizeof(double[3]))

/* The ceiling rises from the south wall to the north one. */
static void put_mono_pitch(struct layout *room, double w, double d, double low,
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

/* The ridge runs from south to north over the middle. */
static void put_ridge(struct layout *room, double w, double d, double low, double high)
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

/* Lengths as they are printed, so that faces meet. */
static void round_shape(struct layout *room)
{
    room->width = 0.01 * round(100.0 * room->width);
    room->depth = 0.01 * round(100.0 * room->depth);
    room->eaves = 0.01 * round(100.0 * room->eaves);
    double run = room->roof == RIDGE ? 0.5 * room->width : room->depth;
    if (room->roof != FLAT)
        room->slope = 0.001 * round(1000.0 * room->slope * run) / run;
}

static void put_shape(struct layout *room)
{
    choose_shape(room);
    round_shape(room);
    double high = high_end(room);
    for (int i = 0; i < WALLS; i++)
        room->lowest[i] = room->eaves;
    if (room->roof == FLAT) {
        SAY(room, "  <plan width=\"%.2f\" depth=\"%.2f\" height=\"%.2f\"/>\n",
            room->width, room->depth, room->eaves);
        return;
    }
    SAY(room, "  <envelope>\n");
    if (room->roof == MONO_PITCH)
        put_mono_pitch(room, room->width, room->depth, room->eaves, high);
    else
        put_ridge(room, room->width, room->depth, room->eaves, high);
    SAY(room, "  </envelope>\n");
    if (room->roof == MONO_PITCH)
        room->lowest[NORTH] = fmin(high, 3.5);
    else /* as high as a window as wide as half the gable may be */
        room->lowest[SOUTH] = room->lowest[NORTH] = 0.5 * (room->eaves + high);
}

static void put_finishes(struct layout *room)
{
    double u[6];
    draw(room, FINISHES, u);
    SAY(room, "  <finishes floor=\"%.2f\" walls=\"%.2f\" ceiling=\"%.2f\"/>\n",
        between(0.1, 0.5, u[0]), between(0.3, 0.85, u[1]), between(0.5, 0.9, u[2]));
}

/* ---- openings ---- */

/* What all openings of a room have, as attributes. */
static void put_pane(struct layout *room, bool upright)
{
    static const double shares[] = {0.2, 0.3, 0.2, 0.08, 0.06, 0.1, 0.06};
    static const char *const names[] = {
        "clear-single",         "clear-double", "low-e-double", "low-e-triple",
        "solar-control-medium", NULL,           "none"};
    double u[6];
    draw(room, OPENINGS, u);
    const char *name = names[ONE_OF(shares, &u[2])];
    if (name)
        SAY(room, " glazing=\"%s\"", name);
    else
        SAY(room, " transmittance=\"%.2f\"", between(0.3, 0.85, u[2]));
    SAY(room, " frame-factor=\"%.2f\" maintenance=\"%.2f\"",
        u[3] < 0.15 ? 1.0 : between(0.6, 0.95, (u[3] - 0.15) / 0.85),
        u[4] < 0.15 ? 1.0 : between(0.6, 0.95, (u[4] - 0.15) / 0.85));
    if (upright && u[5] > 0.5)
        SAY(room, " reveal=\"%.2f\"", between(0.05, 0.4, 2.0 * u[5] - 1.0));
}

/* Up to four equal windows in a wall. */
static void put_windows(struct layout *room, enum wall wall, enum group group)
{
    enum style { USUAL, FRENCH, CLERESTORY };
    static const double styles[] = {0.78, 0.12, 0.1},
                        numbers[] = {0.5, 0.25, 0.15, 0.1};
    double u[6];
    draw(room, group, u);
    double length = wall == SOUTH || wall == NORTH ? room->width : room->depth;
    double top = room->lowest[wall];
    bool gable = room->roof == RIDGE && (wall == SOUTH || wall == NORTH);
    enum style style = (enum style)ONE_OF(styles, &u[5]);
    int count = gable ? 1 : 1 + ONE_OF(numbers, &u[0]);
    double sill = style == FRENCH       ? 0.05
                  : style == CLERESTORY ? fmax(top - 1.1, 0.6)
                                        : fmin(between(0.3, 1.2, u[2]), top - 0.8);
    double head = between(fmin(sill + 0.6, top - 0.05), top - 0.05, sqrt(u[3]));
    double share = between(0.15, gable ? 0.45 : 0.95, u[1]);
    while (count > 1 && share * length / count < 0.4)
        count--;
    double width = fmax(share * length / count, fmin(0.4, 0.9 * length));
    double gap = (length - count * width) / (count + 1);
    for (int i = 0; i < count; i++) {
        double left = gable        ? 0.5 * (length - width)
                      : count == 1 ? u[4] * (length - width)
                                   : gap + i * (width + gap);
        SAY(room,
            "  <window wall=\"%s\" left=\"%.3f\" sill=\"%.2f\" width=\"%.3f\" "
            "height=\"%.2f\"",
            wall_names[wall], left, sill, width - 0.002, head - sill);
        put_pane(room, true);
        SAY(room, "/>\n");
    }
    if (wall == SOUTH)
        room->head = head;
}

/* One to four in a flat ceiling, in a row from west to east. */
static void put_rooflights(struct layout *room)
{
    double u[6];
    draw(room, ROOF, u);
    int count = 1 + (int)(4.0 * u[0]);
    double share = between(0.1, 0.7, u[1]), width = share * room->width / count;
    double depth = between(0.1, 0.7, u[2]) * room->depth;
    double gap = (room->width - count * width) / (count + 1);
    double y = 0.05 + u[3] * (room->depth - depth - 0.1);
    for (int i = 0; i < count; i++) {
        SAY(room, "  <rooflight x=\"%.3f\" y=\"%.3f\" width=\"%.3f\" depth=\"%.3f\"",
            gap + i * (width + gap), y, width, depth);
        put_pane(room, false);
        SAY(room, "/>\n");
    }
}

/* One or two windows in the slope over the south wall, or in the west one of a ridge:
 * rectangles along the slope. */
static void put_roof_windows(struct layout *room)
{
    double u[6];
    draw(room, ROOF, u);
    bool ridge = room->roof == RIDGE;
    double along = ridge ? room->depth : room->width;
    double run = ridge ? 0.5 * room->width : room->depth;
    int count = 1 + (int)(2.0 * u[0]);
    double width = between(0.15, 0.8, u[1]) * along / count;
    double up = between(0.15, 0.7, u[2]) * run, from = 0.05 + u[3] * (run - up - 0.1);
    double gap = (along - count * width) / (count + 1);
    for (int i = 0; i < count; i++) {
        double a = gap + i * (width + gap), b = a + width;
        /* Along the slope and up it, counter-clockwise from inside. */
        const double corners[4][2] = {
            {a, from}, {a, from + up}, {b, from + up}, {b, from}};
        SAY(room, "  <opening");
        put_pane(room, false);
        SAY(room, ">");
        for (int k = 0; k < 4; k++) {
            const double *c = corners[ridge ? 3 - k : k];
            SAY(room, "<vertex x=\"%.4f\" y=\"%.4f\" z=\"%.6f\"/>", ridge ? c[1] : c[0],
                ridge ? c[0] : c[1],
                room->eaves + room->slope * 1e-4 * round(1e4 * c[1]));
        }
        SAY(room, "</opening>\n");
    }
}

/* Returns whether there are windows in walls. */
static bool put_openings(struct layout *room)
{
    enum choice { ONE_WALL, CORNER, OPPOSITE, ROOF_ONLY };
    static const double shares[] = {0.64, 0.16, 0.1, 0.1};
    double u[6];
    draw(room, OPENINGS, u);
    enum choice choice = (enum choice)ONE_OF(shares, &u[0]);
    if (choice != ROOF_ONLY)
        put_windows(room, SOUTH, WALL_1);
    if (choice == CORNER)
        put_windows(room, EAST, WALL_2);
    if (choice == OPPOSITE)
        put_windows(room, NORTH, WALL_2);
    /* A room under slopes has windows in them as often as not. */
    if (choice == ROOF_ONLY || u[1] < (room->roof == FLAT ? 0.12 : 0.5)) {
        if (room->roof == FLAT)
            put_rooflights(room);
        else
            put_roof_windows(room);
    }
    return choice != ROOF_ONLY;
}

/* ---- outside ---- */

static void block(struct layout *room, double x, double y, double width, double depth,
                  double height, double reflectance)
{
    SAY(room,
        "  <block x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" depth=\"%.2f\" base=\"%.2f\" "
        "height=\"%.2f\" reflectance=\"%.2f\"/>\n",
        x, y, width, depth, room->ground, height, reflectance);
}

static void facade(struct layout *room, double aside, double up, double reflectance)
{
    SAY(room,
        "  <facade wall=\"south\" left=\"%.2f\" right=\"%.2f\" up=\"%.2f\" "
        "down=\"%.2f\" reflectance=\"%.2f\"/>\n",
        aside, aside, up, -room->ground, reflectance);
}

/* A slab over the south wall's windows. */
static void put_balcony(struct layout *room, const double u[6])
{
    double out = between(0.5, 2.2, u[1]),
           z = fmax(room->head + 0.05, room->lowest[SOUTH]);
    double low = between(-1.0, 0.0, u[2]), high = room->width - low;
    SAY(room,
        "  <surface reflectance=\"%.2f\"><vertex x=\"%.2f\" y=\"%.2f\" z=\"%.2f\"/>"
        "<vertex x=\"%.2f\" y=\"%.2f\" z=\"%.2f\"/><vertex x=\"%.2f\" y=\"-0.45\" "
        "z=\"%.2f\"/><vertex x=\"%.2f\" y=\"-0.45\" z=\"%.2f\"/></surface>\n",
        between(0.2, 0.6, u[3]), low, -0.45 - out, z, high, -0.45 - out, z, high, z,
        low, z);
}

/* The block opposite, and two that close the sides, with the house's own walls around. */
static void put_court(struct layout *room, double distance, double half, double height,
                      double reflectance)
{
    double middle = 0.5 * room->width, thick = 6.0;
    block(room, middle - half - thick, -distance - thick, 2.0 * (half + thick), thick,
          height, reflectance);
    block(room, middle - half - thick, -distance, thick, distance - 0.5, height,
          reflectance);
    block(room, middle + half, -distance, thick, distance - 0.5, height, reflectance);
    facade(room, half, fmax(height + room->ground - room->eaves, 0.0), reflectance);
}

static void put_street(struct layout *room, const double u[6])
{
    double distance = scaled(5.0, 35.0, u[1]),
           height = distance * between(0.2, 2.0, u[2]);
    double length = room->width * scaled(1.0, 12.0, u[3]), middle = 0.5 * room->width;
    double reflectance = between(0.1, 0.5, u[4]);
    block(room, middle - 0.5 * length, -distance - 10.0, length, 10.0,
          height - room->ground, reflectance);
    if (u[5] < 0.5)
        facade(room, 0.5 * length, fmax(height - room->eaves, 0.0), reflectance);
}

static void put_outside(struct layout *room, bool windows)
{
    enum kind {
        NOTHING,
        FAR_SKYLINE,
        NEAR_SKYLINE,
        STREET,
        LIGHT_WELL,
        COURT,
        BALCONY,
        FACADE,
        ASIDE,
    };
    static const double shares[] = {0.2, 0.2, 0.1, 0.2, 0.06, 0.07, 0.08, 0.04, 0.05};
    double u[6], reflectance;
    draw(room, OUTSIDE, u);
    enum kind kind = (enum kind)ONE_OF(shares, &u[0]);
    reflectance = between(0.1, 0.6, u[4]);
    if (!windows || room->roof != FLAT)
        kind = kind == STREET || kind == ASIDE || (windows && kind == FAR_SKYLINE)
                   ? kind
                   : NOTHING;
    switch (kind) {
    case NOTHING:
        break;
    case FAR_SKYLINE:
        SAY(room, "  <skyline wall=\"south\" angle=\"%.1f\" reflectance=\"%.2f\"/>\n",
            between(4.0, 60.0, u[1]), reflectance);
        break;
    case NEAR_SKYLINE:
        SAY(room,
            "  <skyline wall=\"south\" angle=\"%.1f\" distance=\"%.1f\" "
            "reflectance=\"%.2f\"/>\n",
            between(8.0, 60.0, u[1]), scaled(4.0, 40.0, u[2]), reflectance);
        break;
    case STREET:
        put_street(room, u);
        break;
    case LIGHT_WELL:
        put_court(room, between(2.0, 6.0, u[1]),
                  0.5 * room->width + between(0.0, 2.0, u[2]),
                  between(4.0, 15.0, u[3]) - room->ground, between(0.2, 0.7, u[4]));
        break;
    case COURT:
        put_court(room, scaled(6.0, 25.0, u[1]),
                  0.5 * room->width + between(1.0, 10.0, u[2]),
                  between(3.0, 15.0, u[3]) - room->ground, reflectance);
        break;
    case BALCONY:
        put_balcony(room, u);
        break;
    case FACADE:
        facade(room, between(1.0, 15.0, u[1]), between(0.0, 12.0, u[2]), reflectance);
        break;
    case ASIDE: {
        double distance = scaled(2.0, 15.0, u[1]), height = between(3.0, 20.0, u[2]);
        block(room, between(0.0, 1.5, u[3]) * room->width, -distance - 8.0, 12.0, 8.0,
              height - room->ground, reflectance);
        break;
    }
    }
}

static void put_site(struct layout *room)
{
    double u[6];
    draw(room, PLACE, u);
    room->ground = u[0] < 0.6 ? 0.0 : -3.0 * floor(1.0 + 4.999 * (u[0] - 0.6) / 0.4);
    SAY(room, "  <site ground-reflectance=\"%.2f\" ground-level=\"%.1f\"/>\n",
        u[1] < 0.96 ? between(0.05, 0.4, u[1] / 0.96)
                    : between(0.6, 0.85, (u[1] - 0.96) / 0.04),
        room->ground);
    if (room->design->sky == PP_ATLAS_OVERCAST)
        return;
    draw(room, SKY, u);
    SAY(room, "  <sky type=\"iso-%d\" sun-altitude=\"%.1f\" sun-bearing=\"%.1f\"/>\n",
        1 + (int)(15.0 * u[0]), between(5.0, 80.0, u[1]), between(0.0, 360.0, u[2]));
}

/* ---- points ---- */

/* Where the ceiling is 0.3 m above the plane, to 0.25 m from the walls. */
static void put_points(struct layout *room)
{
    const double margin = 0.25;
    double low[2] = {margin, margin};
    double high[2] = {room->width - margin, room->depth - margin};
    double short_of = room->plane + 0.3 - room->eaves;
    if (short_of > 0.0 && room->roof == MONO_PITCH)
        low[1] = fmax(low[1], short_of / room->slope);
    if (short_of > 0.0 && room->roof == RIDGE) {
        low[0] = fmax(low[0], short_of / room->slope);
        high[0] = room->width - low[0];
    }
    SAY(room, "  <working-plane height=\"%.2f\"/>\n", room->plane);
    for (int i = 0; i < PP_ATLAS_POINTS; i++) {
        double u[2];
        pp_sobol_sequence_draw(&room->design->sequence,
                               PP_ATLAS_POINTS * room->index + (uint32_t)i, POINT, 2,
                               u);
        SAY(room, "  <point x=\"%.3f\" y=\"%.3f\"/>\n", between(low[0], high[0], u[0]),
            between(low[1], high[1], u[1]));
    }
}

void pp_atlas_design_room(const struct pp_atlas_design *design, uint32_t index,
                          char xml[PP_ATLAS_XML])
{
    struct layout room = {.design = design, .index = index, .xml = xml};
    xml[0] = '\0';
    SAY(&room,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<room version=\"1\" name=\"Atlas room %u\">\n",
        (unsigned)index);
    put_site(&room);
    put_shape(&room);
    put_finishes(&room);
    put_outside(&room, put_openings(&room));
    put_points(&room);
    SAY(&room, "</room>\n");
}
