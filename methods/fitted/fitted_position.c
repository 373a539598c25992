/* fitted_position.c - the dimensions of the room perpendicular to an opening's wall and
 * along it, the position of a receiver in them, and the two factors. */
#include "methods/fitted/fitted_position.h"

#include "methods/fitted/fitted_constants.h"
#include "model/geometry/min_max.h"

#define SECTION                                                                        \
    {"w_r", PP_UNIT_METRE, "width of the room along the wall with the opening"},       \
    {                                                                                  \
        "h_r", PP_UNIT_METRE, "height of the room"                                     \
    }
#define DEPTH                                                                          \
    {                                                                                  \
        "d_r", PP_UNIT_METRE,                                                          \
            "depth of the room, perpendicular to the wall with the opening"            \
    }
#define RANGE                                                                          \
    {"R", PP_UNIT_NUMBER, "mean reflectance of all interior surfaces"},                \
    {                                                                                  \
        "l", PP_UNIT_METRE, "decay length of the light in a room where R = 0"          \
    }
#define BREADTH                                                                        \
    {                                                                                  \
        "w", PP_UNIT_METRE, "width of the opening"                                     \
    }

static const struct pp_formula_quantity of_l[] = {SECTION, DEPTH, {0}};
static const struct pp_formula_quantity of_q_d[] = {SECTION, DEPTH, RANGE, {0}};
static const struct pp_formula_quantity of_q_s[] = {
    SECTION, DEPTH, RANGE, BREADTH, {0}};
static const struct pp_formula_quantity of_f_d[] = {
    SECTION,
    DEPTH,
    RANGE,
    {"q_d", PP_UNIT_NUMBER,
     "exponent of the decay with depth, for the depth beyond the start of the decay"},
    {"m_d", PP_UNIT_NUMBER, "absolute value of q_d, at least 0.000001"},
    {"x", PP_UNIT_METRE, "distance of the point from the wall with the opening"},
    {0}};
static const struct pp_formula_quantity of_f_s[] = {
    SECTION,
    DEPTH,
    RANGE,
    {"q_s", PP_UNIT_NUMBER,
     "exponent of the decay along the wall, for the width beside the opening"},
    {"y", PP_UNIT_METRE, "distance from the centre of the opening along its wall"},
    {0}};

const struct pp_formula pp_fitted_position_l = {
    .symbol = "l",
    .sum = "2 w_r h_r / (w_r + h_r)",
    .unit = PP_UNIT_METRE,
    .what =
        "decay length for R = 0: twice the area of the cross-section divided by half "
        "its perimeter",
    .quantities = of_l,
};

const struct pp_formula pp_fitted_position_q_d = {
    .symbol = "q_d",
    .sum = "sqrt(1 - R) (" PP_FITTED_DEPTH " d_r / l - " PP_FITTED_START ")",
    .unit = PP_UNIT_NUMBER,
    .source = "ATLAS",
    .what =
        "exponent of the decay with depth, for the depth beyond the start of the decay",
    .quantities = of_q_d,
};

const struct pp_formula pp_fitted_position_m_d = {
    .symbol = "m_d",
    .sum = "max(abs(q_d), 0.000001)",
    .unit = PP_UNIT_NUMBER,
    .what = "absolute value of q_d, at least 0.000001",
    .quantities = of_f_d,
};

/* q exp(-q x/d) / (1 - exp(-q)), written without powers that could overflow; 1 if q is
 * 0. */
const struct pp_formula pp_fitted_position_f_d = {
    .symbol = "f_d",
    .sum = "m_d exp((q_d - m_d) / 2 - q_d x / d_r) / (1 - exp(-m_d))",
    .unit = PP_UNIT_NUMBER,
    .what = "factor for the distance of the point from this wall",
    .quantities = of_f_d,
};

const struct pp_formula pp_fitted_position_q_s = {
    .symbol = "q_s",
    .sum = "max(" PP_FITTED_SIDE " (w_r - w) sqrt(1 - R) / l, 0.000001)",
    .unit = PP_UNIT_NUMBER,
    .source = "ATLAS",
    .what =
        "exponent of the decay along the wall, for the width beside the opening; at "
        "least 0.000001",
    .quantities = of_q_s,
};

const struct pp_formula pp_fitted_position_f_s = {
    .symbol = "f_s",
    .sum = "q_s exp(-2 q_s y / w_r) / (1 - exp(-q_s))",
    .unit = PP_UNIT_NUMBER,
    .what = "factor for the position of the point along the wall",
    .quantities = of_f_s,
};

static struct pp_vec3 opening_middle(const struct pp_opening *opening)
{
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    for (int i = 0; i < opening->inner.count; i++)
        sum = pp_vec_add(sum, opening->inner.vertices[i]);
    return pp_vec_scale(sum, 1.0 / opening->inner.count);
}

struct pp_fitted_place pp_fitted_position_of(const struct pp_world *world,
                                             const struct pp_opening *opening,
                                             const struct pp_receiver *receiver)
{
    struct pp_vec3 middle = opening_middle(opening), in = opening->inner.normal;
    double deep = 0.0, left = INFINITY, right = -INFINITY;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++) {
            struct pp_vec3 from =
                pp_vec_sub(world->surfaces[i].outline.vertices[k], middle);
            double along = pp_vec_dot(from, opening->along);
            deep = pp_max(deep, pp_vec_dot(from, in));
            left = pp_min(left, along);
            right = pp_max(right, along);
        }
    struct pp_fitted_place place = {
        .d_r = deep, .w_r = right - left, .h_r = world->height_m};
    if (receiver) {
        struct pp_vec3 from = pp_vec_sub(receiver->position, middle);
        place.x = fmax(pp_vec_dot(from, in), 0.0);
        place.y = fabs(pp_vec_dot(from, opening->along));
    }
    return place;
}

void pp_fitted_position_put_room(struct pp_worksheet *sheet,
                                 const struct pp_world *world,
                                 const struct pp_opening *opening)
{
    const struct pp_fitted_place room = pp_fitted_position_of(world, opening, NULL);
    pp_worksheet_put(sheet, PP_UNIT_METRE, room.d_r, "d_r",
                     "depth of the room, perpendicular to the wall with the opening");
    pp_worksheet_put(sheet, PP_UNIT_METRE, room.w_r, "w_r", "width");
    pp_worksheet_put(sheet, PP_UNIT_METRE, room.h_r, "h_r", "height");
}

/* Records f_d and f_s with their quantities. */
static void put_factors(struct pp_worksheet *sheet, const struct pp_world *world,
                        const struct pp_opening *opening,
                        const struct pp_receiver *receiver)
{
    if (!receiver) {
        pp_worksheet_put(sheet, PP_UNIT_NUMBER, 1.0, "f_d",
                         "mean of the factor over the depth");
        pp_worksheet_put(sheet, PP_UNIT_NUMBER, 1.0, "f_s",
                         "mean of the factor over the width");
        return;
    }
    const struct pp_fitted_place place =
        pp_fitted_position_of(world, opening, receiver);
    pp_worksheet_work(sheet, &pp_fitted_position_l,
                      "decay length of the light in a room where R = 0");
    pp_worksheet_put(sheet, PP_UNIT_METRE, place.x, "x",
                     "distance of the point from this wall");
    pp_worksheet_put(sheet, PP_UNIT_METRE, place.y, "y",
                     "distance from the centre of the opening along the wall");
    pp_worksheet_work(sheet, &pp_fitted_position_q_d,
                      "exponent of the decay with depth, for the depth beyond the "
                      "start of the decay");
    pp_worksheet_work(sheet, &pp_fitted_position_m_d, "absolute value of q_d");
    pp_worksheet_work(sheet, &pp_fitted_position_f_d,
                      "factor for the distance of the point from this wall");
    pp_worksheet_work(sheet, &pp_fitted_position_q_s,
                      "exponent of the decay along the wall, from the width beside the "
                      "opening");
    pp_worksheet_work(sheet, &pp_fitted_position_f_s,
                      "factor for the position of the point along the wall");
}

double pp_fitted_position_work(struct pp_worksheet *sheet,
                               const struct pp_formula *mean,
                               const struct pp_formula *at_point,
                               const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver)
{
    pp_worksheet_work(sheet, mean, "mean internally reflected component");
    put_factors(sheet, world, opening, receiver);
    return pp_worksheet_work(sheet, at_point,
                             "internally reflected component at the point");
}
