/* printed_tables.c - compares the tables of the program cell by cell with published
 * ones. */
#include "studies/research/validation/printed_tables.h"

#include <math.h>
#include <stdio.h>

#include "methods/method.h"
#include "methods/reflected/obstruction.h"
#include "model/light/graded_sky.h"
#include "studies/research/validation/known_room.h"

/* ---- the BRS simplified daylight table ---- */

/* Rows by h/d, columns by w/d; values in per cent. */
static const double brs[][21] = {
#include "tables/brs_simplified_table.inc"
};

/* Width of an endless window relative to the distance of the point; a wider window
 * gives the same printed digits. */
static const double ENDLESS = 300.0;

/* Greatest permitted error of a cell, per cent: half a unit of its last digit plus 6 %
 * of the value, since the table was calculated by hand. All values in the lowest row of
 * the table are wrong by one or two units. */
static double brs_limit(double per_cent, double h)
{
    if (h < 0.15)
        return 0.03;
    return (per_cent < 1.0 ? 0.005 : 0.05) + 0.06 * per_cent;
}

/* Cells with known larger errors: h/d and w/d. */
static const double odd[][2] = {
#include "tables/brs_odd_cells.inc"
};

static const double ODD_LIMIT = 0.3; /* fraction of the printed value */

static bool is_odd(double h, double w)
{
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++)
        if (odd[i][0] == h && odd[i][1] == w)
            return true;
    return false;
}

static double bounded(double ratio)
{
    return isinf(ratio) ? ENDLESS : ratio;
}

static void write_ratio(char text[16], double ratio)
{
    snprintf(text, 16, isinf(ratio) ? "endless" : "%g", ratio);
}

/* Sky component 1 m from a window with clear single glass, h high and w wide. The sill
 * is level with the point, and one jamb is straight ahead of the point. */
static enum pp_status sky_component(double *value, double h, double w,
                                    struct pp_error *err)
{
    char xml[400];
    struct pp_world *world = NULL;
    struct pp_outside_light light;
    struct pp_part part = {0};
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='%g' depth='4' height='%g'/><window "
             "wall='south' left='%g' sill='1' width='%g' height='%g'/></room>",
             2.0 * w + 2.0, h + 2.0, w + 1.0, w, h);
    enum pp_status status = pp_known_room_world(&world, &light, xml, err);
    if (status != PP_OK)
        return status;
    const struct pp_receiver receiver = {.position = pp_vec(w + 1.0, 1.0, 1.0),
                                         .normal = pp_vec(0.0, 0.0, 1.0)};
    status = pp_method_exact.evaluate(world, &light, world->openings, &receiver, NULL,
                                      &part, err);
    *value = part.sky;
    pp_world_destroy(world);
    return status;
}

static enum pp_status check_brs_table(struct pp_known_cases *cases,
                                      struct pp_error *err)
{
    enum pp_status status = PP_OK;
    cases->group = "BRS simplified daylight table";
    for (size_t i = 1; i < sizeof brs / sizeof *brs; i++)
        for (size_t k = 1; k < sizeof *brs / sizeof **brs && status == PP_OK; k++) {
            char what[80], height[16], width[16];
            double value, h = brs[i][0], w = brs[0][k], cell = brs[i][k];
            double limit = is_odd(h, w) ? ODD_LIMIT * cell : brs_limit(cell, h);
            write_ratio(height, h);
            write_ratio(width, w);
            snprintf(what, sizeof what, "h/d %s, w/d %s%s", height, width,
                     is_odd(h, w) ? ", an irregular cell" : "");
            status = sky_component(&value, bounded(h), bounded(w), err);
            if (status == PP_OK)
                pp_known_case_add(cases, what, "exact", value, 0.01 * cell,
                                  0.01 * limit);
        }
    return status;
}

/* ---- the table of the minimum internally reflected component ---- */

/* Rows by net glass area, as a percentage of the floor area; columns by reflectances of
 * floors (10, 20, 40 %) and of walls (20, 40, 60, 80 %). */
static const double irc[][13] = {
#include "tables/irc_minimum.inc"
};

/* Our formula agrees with all cells, which have one decimal in per cent, to within 0.25
 * % daylight factor. */
static const double IRC_LIMIT = 0.0025;

/* The room that fits the table best: 20 x 20 x 10 ft, with a window from 3 ft above the
 * floor to the ceiling, and a skyline of 20 degrees opposite. IRC_GLASS_MOST: largest
 * area of glass that fits in the wall, per cent of the floor. */
static const double FOOT_M = 0.3048, IRC_GLASS_MOST = 35.0;

/* The minimum internally reflected component by `bre-min` in that room. */
static enum pp_status irc_of_room(double *value, double glass_percent, double floor,
                                  double walls, struct pp_error *err)
{
    const double side = 20.0 * FOOT_M, sill = 3.0 * FOOT_M, height = 7.0 * FOOT_M;
    char xml[700];
    struct pp_world *world = NULL;
    struct pp_outside_light light;
    struct pp_part part = {0};
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='%g' depth='%g' height='%g'/>"
             "<finishes floor='%g' walls='%g' ceiling='0.7'/><window wall='south' "
             "left='0' sill='%g' width='%g' height='%g'/>"
             "<skyline wall='south' angle='20'/></room>",
             side, side, sill + height, floor, walls, sill,
             0.01 * glass_percent * side * side / height, height);
    enum pp_status status = pp_known_room_world(&world, &light, xml, err);
    if (status == PP_OK)
        status = pp_method_bre_min.evaluate(world, &light, world->openings, NULL, NULL,
                                            &part, err);
    *value = part.value;
    pp_world_destroy(world);
    return status;
}

static enum pp_status check_irc_table(struct pp_known_cases *cases,
                                      struct pp_error *err)
{
    static const double floors[] = {0.1, 0.2, 0.4}, walls[] = {0.2, 0.4, 0.6, 0.8};
    enum pp_status status = PP_OK;
    cases->group = "minimum internally reflected component";
    for (size_t r = 0; r < sizeof irc / sizeof *irc && irc[r][0] <= IRC_GLASS_MOST; r++)
        for (int i = 0; i < 12 && status == PP_OK; i++) {
            char what[80];
            double value, f = floors[i / 4], w = walls[i % 4];
            snprintf(what, sizeof what, "glass %g %%, floor %g, walls %g", irc[r][0], f,
                     w);
            status = irc_of_room(&value, irc[r][0], f, w, err);
            if (status == PP_OK)
                pp_known_case_add(cases, what, "bre-min", value, 0.01 * irc[r][1 + i],
                                  IRC_LIMIT);
        }
    return status;
}

/* ---- BRE's obstruction factors ---- */

static const double factors[][2] = {
#include "tables/bre_obstruction_factors.inc"
};

/* The factors agree with the light of the overcast sky above the obstruction plus a
 * tenth of the hidden light, to within 1.3 units. The printed factors are whole
 * numbers, in per cent, rounded in several steps. */
static void check_obstruction_factors(struct pp_known_cases *cases)
{
    double open = pp_graded_sky_over_skyline(PP_GRADED_SKY_OVERCAST, 0.0);
    cases->group = "BRE obstruction factor C";
    for (size_t i = 0; i < sizeof factors / sizeof *factors; i++) {
        char what[80];
        double above =
            pp_graded_sky_over_skyline(PP_GRADED_SKY_OVERCAST, factors[i][0] * PP_RAD);
        snprintf(what, sizeof what, "%g degrees", factors[i][0]);
        pp_known_case_add(cases, what, "sky", above + 0.1 * (open - above),
                          0.01 * factors[i][1], 0.013);
    }
}

/* ---- ISO 15469 ---- */

/* Checks the luminance at 45 degrees, opposite a sun 60 degrees high, relative to the
 * luminance of the zenith, against values documented by other programs. */
static enum pp_status check_iso_skies(struct pp_known_cases *cases,
                                      struct pp_error *err)
{
    static const struct {
        int type;
        double luminance;
    } list[] = {{1, 0.8325846}, {12, 0.4544524}};
    const struct pp_vec3 sun = {0.5, 0.0, sqrt(0.75)}, u = {-sqrt(0.5), 0.0, sqrt(0.5)},
                         zenith = {0.0, 0.0, 1.0};
    cases->group = "ISO 15469 luminance relative to the zenith";
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        struct pp_sky sky;
        char what[80];
        enum pp_status status = pp_sky_iso(&sky, list[i].type, sun, err);
        if (status != PP_OK)
            return status;
        snprintf(what, sizeof what, "type %d", list[i].type);
        pp_known_case_add(cases, what, "sky",
                          pp_sky_luminance(&sky, u) / pp_sky_luminance(&sky, zenith),
                          list[i].luminance, 0.5001e-7);
    }
    return PP_OK;
}

/* ---- configuration factors of CIE 171 ---- */

/* A black parallelogram with this exitance; refers to the caller's four corners. */
static struct pp_surface plate(struct pp_vec3 *corners, double exitance)
{
    struct pp_vec3 a = pp_vec_sub(corners[1], corners[0]),
                   b = pp_vec_sub(corners[3], corners[0]), n = pp_vec_cross(a, b);
    double area_m2 = pp_vec_length(n);
    return (struct pp_surface){
        .outline = {4, corners, pp_vec_scale(n, 1.0 / area_m2), area_m2},
        .role = PP_FREE_SURFACE,
        .exitance = exitance,
        .owner = -1};
}

/* Points in a row, each with a letter, and their printed configuration factors. */
struct factor_row {
    const char *what;
    char first; /* letter */
    struct pp_vec3 start, step, normal;
    int count;
    double per_cent[8];
};

/* Checks the illuminance of the points, divided by the exitance of the only luminous
 * plate. */
static enum pp_status check_row(struct pp_known_cases *cases, struct pp_surface *plates,
                                int plate_count, const struct factor_row *row,
                                const struct pp_known_trace *how, struct pp_error *err)
{
    enum { MOST = sizeof row->per_cent / sizeof row->per_cent[0] };
    const struct pp_world world = {.surfaces = plates, .surface_count = plate_count};
    const struct pp_outside_light light = {.sky = pp_sky_overcast()};
    struct pp_receiver receivers[MOST];
    struct pp_reading readings[MOST][PP_COMPONENT_COUNT];
    for (int i = 0; i < row->count; i++)
        receivers[i] = (struct pp_receiver){
            .position = pp_vec_add(row->start, pp_vec_scale(row->step, i)),
            .normal = row->normal};
    enum pp_status status =
        pp_known_room_trace(readings, &world, &light, receivers, row->count, how, err);
    for (int i = 0; i < row->count && status == PP_OK; i++) {
        char what[80];
        snprintf(what, sizeof what, "%s, %c", row->what, row->first + i);
        pp_known_case_add_traced_printed(cases, what, readings[i][PP_ERC],
                                         row->per_cent[i], 2);
    }
    return status;
}

/* Case 5.6: a plate of 4 x 4 m on the ground. Case 5.7, with Ashdown's corrections: a
 * wall of 4 x 3 m behind a black box 1 m high. */
static enum pp_status check_configuration_factors(struct pp_known_cases *cases,
                                                  const struct pp_known_trace *how,
                                                  struct pp_error *err)
{
    struct pp_vec3 level[4] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                   wall[4] = {{0, 4, 0}, {4, 4, 0}, {4, 4, 3}, {0, 4, 3}},
                   front[4] = {{0, 2.5, 0}, {4, 2.5, 0}, {4, 2.5, 1}, {0, 2.5, 1}},
                   back[4] = {{0, 2.7, 0}, {4, 2.7, 0}, {4, 2.7, 1}, {0, 2.7, 1}},
                   top[4] = {{0, 2.5, 1}, {4, 2.5, 1}, {4, 2.7, 1}, {0, 2.7, 1}};
    struct pp_surface ground[] = {plate(level, 1.0)};
    struct pp_surface masked[] = {plate(wall, 1.0), plate(front, 0.0), plate(back, 0.0),
                                  plate(top, 0.0)};
    static const struct factor_row over_ground[] = {
        {"case 5.6, on a wall",
         'B',
         {2, 0, 0.75},
         {0, 0, 0.5},
         {0, 1, 0},
         5,
         {35.901, 27.992, 21.639, 16.716, 12.967}},
        {"case 5.6, 3 m above the plate",
         'G',
         {2, 0.25, 3},
         {0, 0.5, 0},
         {0, 0, -1},
         8,
         {26.80, 30.94, 33.98, 35.57, 35.57, 33.98, 30.94, 26.80}},
    };
    static const struct factor_row behind_the_box[] = {
        {"case 5.7, on a wall",
         'A',
         {2, 0, 2.75},
         {0, 0, -0.5},
         {0, 1, 0},
         6,
         {16.07, 16.33, 15.40, 13.32, 10.32, 7.08}},
        {"case 5.7, on the floor",
         'G',
         {2, 0.25, 0},
         {0, 0.5, 0},
         {0, 0, 1},
         5,
         {3.38, 3.63, 3.01, 0.0, 0.0}},
    };
    enum pp_status status = PP_OK;
    cases->group = "configuration factors of CIE 171";
    for (int i = 0; i < 2 && status == PP_OK; i++)
        status = check_row(cases, ground, 1, &over_ground[i], how, err);
    for (int i = 0; i < 2 && status == PP_OK; i++)
        status = check_row(cases, masked, 4, &behind_the_box[i], how, err);
    return status;
}

enum pp_status pp_printed_tables(struct pp_known_cases *cases,
                                 const struct pp_known_trace *how, struct pp_error *err)
{
    enum pp_status status = check_brs_table(cases, err);
    if (status == PP_OK)
        status = check_irc_table(cases, err);
    if (status == PP_OK) {
        check_obstruction_factors(cases);
        status = check_iso_skies(cases, err);
    }
    if (status == PP_OK)
        status = check_configuration_factors(cases, how, err);
    cases->group = NULL;
    return status;
}
