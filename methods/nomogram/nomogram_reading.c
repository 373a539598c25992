/* nomogram_reading.c - sets the room's quantities on the scales and reads the stems
 * between them. */
#include "methods/nomogram/nomogram_reading.h"

#include <math.h>
#include <stddef.h>

#include "methods/allowance.h"
#include "methods/reflected/interior.h"
#include "methods/nomogram/nomogram_scale.h"
#include "methods/reflected/obstruction.h"

static const struct pp_formula_quantity of_ratio[] = {
    {"W", PP_UNIT_SQUARE_METRE, "net glass area"},
    {"S", PP_UNIT_SQUARE_METRE, "area of all interior surfaces"},
    {0},
};

const struct pp_formula pp_nomogram_reading_ratio = {
    .symbol = "a",
    .sum = "W / S",
    .unit = PP_UNIT_NUMBER,
    .source = "GEEBELEN",
    .what = "ratio of net glass area to the area of all interior surfaces, on scale A",
    .quantities = of_ratio,
    .fixed = true,
};

/* Reads a stem at the point where the straight-edge, laid through the values on two
 * other stems, crosses that stem. */
void pp_nomogram_reading_lay(struct pp_nomogram_reading *reading,
                             const struct pp_nomogram *nomogram, int index)
{
    const struct pp_nomogram_edge *edge = &nomogram->edges[index];
    double y_from =
        pp_nomogram_scale_position(nomogram, edge->from, reading->value[edge->from]);
    double y_to =
        pp_nomogram_scale_position(nomogram, edge->to, reading->value[edge->to]);
    double y = pp_nomogram_scale_crossing(nomogram, index, y_from, y_to,
                                          nomogram->stems[edge->read].x);
    reading->value[edge->read] = pp_nomogram_scale_read(
        nomogram, edge->read, pp_nomogram_scale_value(nomogram, edge->read, y));
    reading->used[index] = true;
}

/* Ratio W/S times the power of ten that brings it into the range of scale A. */
static double shifted(const struct pp_nomogram_stem *stem, double ratio, int *tens)
{
    *tens = 0;
    for (; ratio < stem->low && *tens < 9; ++*tens)
        ratio *= 10.0;
    for (; ratio > stem->high && *tens > -9; --*tens)
        ratio /= 10.0;
    return ratio;
}

void pp_nomogram_reading_set_room(struct pp_nomogram_reading *reading,
                                  const struct pp_nomogram *nomogram, double R)
{
    reading->value[PP_STEM_A] = pp_nomogram_scale_read(
        nomogram, PP_STEM_A,
        shifted(&nomogram->stems[PP_STEM_A], reading->ratio, &reading->tens));
    reading->value[PP_STEM_B] = pp_nomogram_scale_read(nomogram, PP_STEM_B, R);
}

const char *pp_nomogram_reading_refuses_room(const struct pp_world *world)
{
    double R = pp_interior_all(world).reflectance;
    if (R >= PP_NOMOGRAM_LEAST_R && R <= PP_NOMOGRAM_MOST_R)
        return NULL;
    return "the reflectance scale covers 0.1 to 0.9";
}

enum pp_status pp_nomogram_reading_of_opening(struct pp_nomogram_reading *reading,
                                              const struct pp_nomogram *nomogram,
                                              const struct pp_world *world,
                                              const struct pp_outside_light *light,
                                              const struct pp_opening *opening,
                                              struct pp_error *err)
{
    struct pp_interior all = pp_interior_all(world);
    *reading = (struct pp_nomogram_reading){
        .glass_m2 = pp_allowance_net_glass_m2(opening), .inside_m2 = all.area_m2};
    for (int i = 0; i < PP_NOMOGRAM_STEMS; i++)
        reading->value[i] = NAN;
    double angle_rad = opening->slope_rad;
    enum pp_status status = PP_OK;
    if (nomogram->kind != PP_NOMOGRAM_ROOFLIGHT)
        status = pp_obstruction_angle(&angle_rad, world, light, opening, err);
    if (status != PP_OK)
        return status;

    double *value = reading->value;
    reading->ratio =
        pp_formula_value(&pp_nomogram_reading_ratio,
                         (const double[]){reading->glass_m2, reading->inside_m2});
    pp_nomogram_reading_set_room(reading, nomogram, all.reflectance);
    pp_nomogram_reading_lay(reading, nomogram, 0);

    value[PP_STEM_D] = pp_nomogram_scale_read(nomogram, PP_STEM_D, angle_rad);
    if (value[PP_STEM_D] > 0.0)
        pp_nomogram_reading_lay(reading, nomogram, 1);
    else /* E equals C without an obstruction */
        value[PP_STEM_E] = value[PP_STEM_C];

    double back = pow(10.0, -reading->tens);
    reading->component = back * value[PP_STEM_E];
    reading->further = NAN;
    if (nomogram->kind == PP_NOMOGRAM_MINIMUM) {
        value[PP_STEM_F] = pp_nomogram_scale_read(
            nomogram, PP_STEM_F, pp_interior_role(world, PP_WALL).reflectance);
        pp_nomogram_reading_lay(reading, nomogram, 2);
        reading->further = back * value[PP_STEM_G];
    }
    return PP_OK;
}
