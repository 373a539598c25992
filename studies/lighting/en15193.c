/* en15193.c - see en15193.h. */
#include "studies/lighting/en15193.h"

#include <math.h>

#include "studies/criteria/section_angle.h"
#include "studies/side_lit_box.h"

double pp_en15193_factor(double I_T, double I_De, double I_O)
{
    return fmax(0.0, (4.13 + 20.0 * I_T - 1.36 * I_De) * I_O / 100.0);
}

int pp_en15193_class(double D_C)
{
    return D_C >= 0.06 ? 3 : D_C >= 0.04 ? 2 : D_C >= 0.02 ? 1 : 0;
}

double pp_en15193_supply(int class, double target_lx, double latitude_rad)
{
    static const struct {
        double target_lx, a[3], b[3]; /* for weak, medium and strong daylight */
    } table[] = {
        {300.0, {1.2425, 1.3097, 1.2904}, {-0.0117, -0.0106, -0.0088}},
        {500.0, {0.9432, 1.2425, 1.3220}, {-0.0094, -0.0117, -0.0110}},
        {750.0, {0.6692, 1.0054, 1.2812}, {-0.0067, -0.0098, -0.0121}},
    };
    double latitude_deg = latitude_rad / PP_RAD;
    if (!(latitude_deg >= 38.0 && latitude_deg <= 60.0))
        return NAN;
    for (int i = 0; i < 3; i++)
        if (table[i].target_lx == target_lx)
            return table[i].a[class - 1] + table[i].b[class - 1] * latitude_deg;
    return NAN;
}

double pp_en15193_control(int class, bool is_manual)
{
    static const double automatic[] = {0.75, 0.77, 0.85}, manual[] = {0.20, 0.30, 0.40};
    return (is_manual ? manual : automatic)[class - 1];
}

static bool has_shades(const struct pp_world *world)
{
    for (int i = 0; i < world->surface_count; i++)
        if (world->surfaces[i].is_shade)
            return true;
    return false;
}

/* Total area of the openings. *I_O: mean of I_O over the openings, weighted by area. */
static double area_of_openings(const struct pp_world *world, double *I_O)
{
    double sum = 0.0, seen = 0.0;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        const struct pp_polygon *inner = &opening->inner;
        double area =
            pp_vec_length(pp_polygon_area_vector(inner->vertices, inner->count));
        double g = pp_section_angle(world, opening, true);
        sum += area;
        seen += g < 60.0 * PP_RAD ? area * cos(1.5 * g) : 0.0;
    }
    *I_O = seen / sum;
    return sum;
}

void pp_en15193_of_room(struct pp_lighting_standard *standard,
                        const struct pp_world *world, double latitude_rad,
                        const struct pp_lighting_control *control)
{
    static const double DEPTH_MOST = 2.5; /* limit of I_De */
    struct pp_side_lit_box box;
    *standard = (struct pp_lighting_standard){.saved = NAN};
    if (!pp_side_lit_box_of(&box, world, &standard->why))
        return;
    double height_m = box.head_z - world->working_plane_m, I_O;
    if (has_shades(world))
        standard->why = "there are overhangs or fins";
    else if (!(height_m > 0.0))
        standard->why = "the windows are below the working plane";
    if (standard->why)
        return;
    standard->depth_m = fmin(box.depth_m, DEPTH_MOST * height_m);
    standard->width_m = box.width_m;
    double A_C = area_of_openings(world, &I_O);
    standard->factor = pp_en15193_factor(A_C / (standard->depth_m * standard->width_m),
                                         standard->depth_m / height_m, I_O);
    standard->class = pp_en15193_class(standard->factor);
    if (standard->class == 0) {
        standard->saved = 0.0;
        return;
    }
    standard->supply =
        pp_en15193_supply(standard->class, control->target_lx, latitude_rad);
    standard->control =
        pp_en15193_control(standard->class, control->kind == PP_LIGHTING_MANUAL);
    if (isnan(standard->supply))
        standard->why = "its table is for 300, 500 and 750 lx and latitudes from 38 to "
                        "60 degrees north";
    else
        standard->saved = standard->supply * standard->control * standard->depth_m
                          * standard->width_m / pp_world_floor_m2(world);
}
