/* well_window.c - see well_window.h. */
#include "methods/reflected/well_window.h"

#include <math.h>
#include <stddef.h>

#include "methods/method.h"
#include "methods/refusals.h"
#include "methods/reflected/interior.h"
#include "methods/reflected/sky_angle.h"
#include "methods/reflected/well.h"

enum {
    COLUMNS = 2, /* points of a window, along and up: 4 x 6 change E_v of windows up to
                  * 4 m wide by less than 1 % */
    ROWS = 3,
    AZIMUTHS = 64, /* directions from a point to the walls */
};

/* Distance of the points from the wall (m): as far as points of a file may be. */
static const double before_wall_m = 1e-3;

static const struct pp_formula_quantity of_light[] = {
    {"E_s", PP_UNIT_DAYLIGHT_FACTOR, "light of the sky on the window"},
    {"E_r", PP_UNIT_DAYLIGHT_FACTOR, "light of the well's surfaces on the window"},
    {0},
};

const struct pp_formula pp_well_window_light = {
    .symbol = "E_v",
    .sum = "E_s + E_r",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "vertical daylight factor on the wall of the well, at the window",
    .quantities = of_light,
};

static const struct pp_formula_quantity of_theta[] = {
    {"E_v", PP_UNIT_DAYLIGHT_FACTOR, "vertical daylight factor at the window"},
    {"theta_h", PP_UNIT_ANGLE, "upper limit of the visible sky in section"},
    {0},
};

const struct pp_formula pp_well_window_theta = {
    .symbol = "theta",
    .sum = "2 E_v theta_h / 90",
    .unit = PP_UNIT_ANGLE,
    .what = "angle of visible sky that gives the same light on the window",
    .quantities = of_theta,
};

/* ---- the well ---- */

/* A coarse model as a shaft. */
struct well_box {
    struct pp_well_shape shape; /* width along the window's wall */
    double low_m, high_m;       /* z of floor and roof */
    double floor, roof; /* reflectances from within; of the roof, with the glass */
    double glazed;      /* net glass area over the area of the roof */
};

static bool is_roof(const struct pp_world *coarse, const struct pp_opening *opening)
{
    return coarse->surfaces[opening->face].role == PP_CEILING;
}

static double net_share(const struct well_box *box, const struct pp_opening *opening)
{
    return opening->inner.area_m2 * opening->frame_factor
           / (box->shape.width_m * box->shape.length_m);
}

/* Describes the well as seen from the wall of the opening of the coarse model. */
static struct well_box box_behind(const struct pp_world *coarse,
                                  const struct pp_opening *opening)
{
    struct well_box box = {.low_m = INFINITY, .high_m = -INFINITY};
    const struct pp_polygon *wall = &coarse->surfaces[opening->face].outline;
    double plan_m2 = pp_interior_role(coarse, PP_CEILING).area_m2, bare = 1.0;
    for (int k = 0; k < wall->count; k++) {
        box.low_m = fmin(box.low_m, wall->vertices[k].z);
        box.high_m = fmax(box.high_m, wall->vertices[k].z);
    }
    for (int i = 0; i < coarse->opening_count; i++)
        if (is_roof(coarse, &coarse->openings[i]))
            plan_m2 += coarse->openings[i].inner.area_m2;
    box.shape.depth_m = box.high_m - box.low_m;
    box.shape.width_m = wall->area_m2 / box.shape.depth_m;
    box.shape.length_m = plan_m2 / box.shape.width_m;
    box.shape.sides = pp_interior_role(coarse, PP_WALL).reflectance;
    box.floor = pp_interior_role(coarse, PP_FLOOR).reflectance;
    for (int i = 0; i < coarse->opening_count; i++) {
        const struct pp_opening *roof = &coarse->openings[i];
        if (!is_roof(coarse, roof))
            continue;
        double share = net_share(&box, roof);
        box.glazed += share;
        box.roof += share * pp_well_glass_back(&roof->glass);
        bare -= roof->inner.area_m2 / plan_m2;
    }
    box.roof += bare * pp_interior_role(coarse, PP_CEILING).reflectance;
    return box;
}

/* Six faces that are horizontal or vertical, and walls as long as those of a
 * rectangle of this area. */
static bool is_box(const struct pp_world *coarse)
{
    double floor_m2 = 0.0, walls_m2 = 0.0, longest_m2 = 0.0;
    for (int i = 0; i < coarse->face_count; i++) {
        const struct pp_surface *face = &coarse->surfaces[i];
        double up = fabs(face->outline.normal.z);
        if (face->outline.count != 4 || (up > 1e-6 && up < 1.0 - 1e-6)
            || (face->role == PP_WALL) != (up < 0.5))
            return false;
        if (face->role == PP_FLOOR)
            floor_m2 += face->outline.area_m2;
        if (face->role != PP_WALL)
            continue;
        walls_m2 += face->outline.area_m2;
        longest_m2 = fmax(longest_m2, face->outline.area_m2);
    }
    double a_m = longest_m2 / coarse->height_m, b_m = floor_m2 / a_m;
    return coarse->face_count == 6
           && fabs(2.0 * (a_m + b_m) * coarse->height_m - walls_m2) < 1e-4 * walls_m2;
}

/* True if the coarse model consists of its faces and the sides of its openings. */
static bool is_bare_box(const struct pp_world *coarse)
{
    for (int i = coarse->face_count; i < coarse->surface_count; i++)
        if (coarse->surfaces[i].role != PP_REVEAL)
            return false;
    return coarse->skyline_count == 0;
}

static bool is_counterpart(const struct pp_world *world, int index)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].is_nested && world->openings[i].counterpart == index)
            return true;
    return false;
}

static const char *why_no_roof(const struct pp_opening *roof)
{
    if (roof->slope_rad > 1e-3 || roof->reveal_m > 0.0)
        return "the rooflight of the coarse model slopes or has a reveal, but the "
               "method covers only wells with horizontal rooflights without a reveal";
    if (roof->blind
        || (roof->measured && roof->measured->kind == PP_MEASURED_SCATTERING))
        return "the rooflight of the coarse model has a blind, or a pane that scatters "
               "light by direction";
    return NULL;
}

const char *pp_well_window_refuses_room(const struct pp_world *world)
{
    const struct pp_world *coarse = world->within;
    int roofs = 0;
    if (!coarse)
        return "valid only for rooms nested within an atrium or light well (within)";
    if (!world->within_is_before)
        return "the coarse model is in the place of the room, not an atrium or light "
               "well in front of its windows";
    if (!is_box(coarse))
        return "the coarse model is not a box with a horizontal roof, but the method "
               "covers only atria and light wells of this shape";
    if (!is_bare_box(coarse))
        return "the coarse model has surfaces, blocks or skylines besides its floor, "
               "walls and roof, but the method covers only empty atria and light wells";
    for (int i = 0; i < coarse->opening_count; i++) {
        const struct pp_opening *opening = &coarse->openings[i];
        if (!is_roof(coarse, opening)) {
            if (is_counterpart(world, i))
                continue;
            return "the coarse model has a window in a wall or floor without a "
                   "counterpart in the room, but the method covers only atria and "
                   "light wells that are lit from above";
        }
        const char *why = why_no_roof(opening);
        if (why)
            return why;
        roofs++;
    }
    if (roofs == 0)
        return "the coarse model has no rooflight, so that it is no atrium or light "
               "well";
    return pp_refusals_if_luminous(coarse);
}

const char *pp_well_window_refuses(const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_opening *opening,
                                   const struct pp_receiver *receiver)
{
    (void)world, (void)light, (void)receiver;
    if (!opening->is_nested)
        return "has no counterpart in the coarse model, but the method covers only "
               "windows off an atrium or light well";
    return pp_refusals_unless_vertical(opening);
}

/* ---- light on the window ---- */

/* The sky component at a point of a wall of the well. */
static enum pp_status sky_at(double *sky, const struct pp_world *coarse,
                             const struct pp_outside_light *light,
                             const struct pp_receiver *point, struct pp_error *err)
{
    *sky = 0.0;
    for (int i = 0; i < coarse->opening_count; i++) {
        const struct pp_opening *roof = &coarse->openings[i];
        struct pp_part part = {0};
        if (!is_roof(coarse, roof))
            continue;
        enum pp_status status =
            pp_method_exact.evaluate(coarse, light, roof, point, NULL, &part, err);
        if (status != PP_OK)
            return status;
        *sky += part.sky * pp_allowance_factor(pp_method_exact.allowances, roof);
    }
    return PP_OK;
}

/* Flux on the parts of the well. */
static struct pp_well_flux flux_in(const struct pp_world *coarse,
                                   const struct pp_outside_light *light,
                                   const struct well_box *box)
{
    struct pp_well_flux flux = {.top = 0.0};
    for (int i = 0; i < coarse->opening_count; i++) {
        const struct pp_opening *roof = &coarse->openings[i];
        if (!is_roof(coarse, roof))
            continue;
        double others = pp_allowance_factor(PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME,
                                            roof); /* dirt and the like */
        pp_well_add_sky(&flux, &box->shape,
                        roof->glass.diffusing ? 0.0 : light->sky.gradation,
                        &roof->glass, net_share(box, roof) * others);
    }
    pp_well_exchange(&flux, &box->shape, box->roof, box->floor);
    return flux;
}

/* Illuminance of a vertical plane per unit of the sine of the azimuth, from a unit
 * luminance below the altitude whose tangent is rise / away. */
static double below(double rise_m, double away_m)
{
    double altitude_rad = atan2(rise_m, away_m);
    return (altitude_rad + sin(altitude_rad) * cos(altitude_rad)) / 2.0;
}

/* The light of the well's surfaces at a point of a wall: z, and the distances of the
 * side walls to the left and right. Vertical planes through the point at equal steps of
 * the sine of their azimuth meet the walls at one distance, and see floor, bands and
 * roof one above the other. */
static double reflected_at(const struct well_box *box, const struct pp_well_flux *flux,
                           double z, double left_m, double right_m)
{
    double sum = 0.0, band_m = box->shape.depth_m / PP_WELL_BANDS;
    /* Ratio of the section to the area of a band. */
    double section = PP_WELL_BANDS / (4.0 * pp_well_index(&box->shape));
    for (int k = 0; k < AZIMUTHS; k++) {
        double s = 2.0 * (k + 0.5) / AZIMUTHS - 1.0;
        double away_m = fmin(box->shape.length_m / sqrt(1.0 - s * s),
                             (s > 0.0 ? right_m : left_m) / fabs(s));
        double upper = below(box->high_m - z, away_m);
        sum += box->roof * flux->top * (PP_PI / 4.0 - upper);
        for (int i = 0; i < PP_WELL_BANDS; i++) {
            double lower = below(box->high_m - (i + 1) * band_m - z, away_m);
            sum += box->shape.sides * flux->bands[i] * section * (upper - lower);
            upper = lower;
        }
        sum += box->floor * flux->foot * (upper + PP_PI / 4.0);
    }
    return sum * 2.0 / AZIMUTHS / PP_PI;
}

enum pp_status pp_well_window_of(struct pp_well_window *on_window,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_opening *opening, struct pp_error *err)
{
    const struct pp_world *coarse = world->within;
    const struct pp_opening *own = &coarse->openings[opening->counterpart];
    const struct pp_polygon *wall = &coarse->surfaces[own->face].outline;
    struct well_box box = box_behind(coarse, own);
    struct pp_well_flux flux = flux_in(coarse, light, &box);
    struct pp_vec3 middle = pp_polygon_middle(&own->inner);
    enum pp_status status = PP_OK;
    *on_window = (struct pp_well_window){0};
    for (int i = 0; i < COLUMNS * ROWS && status == PP_OK; i++) {
        double x_m = ((i % COLUMNS + 0.5) / COLUMNS - 0.5) * own->width_m,
               z_m = ((i / COLUMNS + 0.5) / ROWS - 0.5) * own->height_m;
        double left_m = 0.0, right_m = 0.0, sky;
        struct pp_receiver point = {.normal = own->inner.normal};
        point.position = pp_vec_along(middle, x_m, own->along);
        point.position = pp_vec_along(point.position, z_m, own->up);
        for (int k = 0; k < wall->count; k++) {
            double aside_m =
                pp_vec_dot(pp_vec_sub(wall->vertices[k], point.position), own->along);
            left_m = fmax(left_m, -aside_m);
            right_m = fmax(right_m, aside_m);
        }
        on_window->reflected +=
            reflected_at(&box, &flux, point.position.z, left_m, right_m)
            / (COLUMNS * ROWS);
        point.position = pp_vec_along(point.position, before_wall_m, point.normal);
        status = sky_at(&sky, coarse, light, &point, err);
        if (status == PP_OK)
            on_window->sky += sky / (COLUMNS * ROWS);
    }
    return status;
}

enum pp_status pp_well_window_angle(struct pp_worksheet *sheet,
                                    const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_opening *opening,
                                    struct pp_error *err)
{
    const struct pp_world *coarse = world->within;
    const struct pp_opening *own = &coarse->openings[opening->counterpart];
    struct well_box box = box_behind(coarse, own);
    struct pp_well_window on_window;
    enum pp_status status = pp_well_window_of(&on_window, world, light, opening, err);
    if (status != PP_OK)
        return status;
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, pp_well_index(&box.shape), "w",
                     "well index");
    pp_worksheet_put(sheet, PP_UNIT_METRE,
                     box.high_m - pp_polygon_middle(&own->inner).z, "z",
                     "depth of the window's middle below the roof of the well");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, box.shape.sides, "rho_w",
                     "mean reflectance of the walls of the well");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, box.floor, "rho_b",
                     "reflectance of the floor of the well");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, box.roof, "rho_r",
                     "mean reflectance of the roof of the well, from below");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, box.glazed, "g",
                     "net glass area over the area of the roof of the well");
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, on_window.sky, "E_s",
                     "light of the sky on the window");
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, on_window.reflected, "E_r",
                     "light of the well's surfaces on the window");
    pp_worksheet_work(sheet, &pp_well_window_light,
                      "vertical daylight factor at the window");
    pp_sky_angle_head_of(sheet, opening);
    pp_worksheet_work(sheet, &pp_well_window_theta,
                      "angle of visible sky that gives the same light");
    return PP_OK;
}
