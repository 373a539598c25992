/* closed_forms.c - the cases for hand methods and for the simulation. */
#include "studies/research/validation/closed_forms.h"

#include <math.h>
#include <stdio.h>

#include "model/light/graded_sky.h"
#include "studies/research/validation/known_room.h"

/* ---- by hand methods ---- */

/* Checks rectangles seen from a point one metre away, with one corner on the
 * perpendicular through the point. */
static enum pp_status check_rectangles(struct pp_known_cases *cases,
                                       struct pp_error *err)
{
    static const struct {
        bool overhead;
        double a, b, per_cent[2]; /* vertical: height, width; overhead: both sides */
    } list[] = {
        {false, 0.5, 0.5, {1.3928, 0.9430}},  {false, 1.0, 1.0, {5.5734, 4.5251}},
        {false, 1.0, 2.0, {6.8697, 5.4586}},  {false, 2.0, 1.0, {9.5068, 8.8164}},
        {false, 0.5, 2.0, {2.5164, 1.6457}},  {true, 1.0, 1.0, {13.8532, 15.9497}},
        {true, 0.5, 2.0, {10.6838, 12.2905}},
    };
    static const char *const skies[] = {"uniform", "overcast"};
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++)
        for (int sky = 0; sky < 2; sky++) {
            char xml[640], opening[160], what[80];
            snprintf(opening, sizeof opening,
                     list[i].overhead ? "<rooflight x='1' y='1' width='%g' depth='%g' "
                                        "glazing='none'/>"
                                      : "<window wall='south' left='1' sill='1' "
                                        "height='%g' width='%g' glazing='none'/>",
                     list[i].a, list[i].b);
            snprintf(xml, sizeof xml,
                     "<room version='1'><sky type='%s'/><plan width='4' depth='4' "
                     "height='%d'/>%s<working-plane height='1'/><point x='1' y='1'/>"
                     "</room>",
                     skies[sky], list[i].overhead ? 2 : 4, opening);
            snprintf(what, sizeof what, "%s %g x %g m, 1 m off, %s sky",
                     list[i].overhead ? "level" : "upright", list[i].a, list[i].b,
                     skies[sky]);
            struct pp_known_room room;
            enum pp_status status = pp_known_room_evaluate(&room, xml, "exact", err);
            if (status != PP_OK)
                return status;
            pp_known_case_add_per_cent(cases, what, "exact",
                                       pp_known_room_at_point(&room, PP_SC, "exact"),
                                       list[i].per_cent[sky], 4);
            pp_known_room_clear(&room);
        }
    return PP_OK;
}

/* Checks a glazed window; the expected value is a quadrature over azimuth and
 * altitude. */
static enum pp_status check_glass(struct pp_known_cases *cases, struct pp_error *err)
{
    struct pp_known_room room;
    enum pp_status status =
        pp_known_room_evaluate(&room, PP_KNOWN_HALL "</room>", "exact", err);
    if (status != PP_OK)
        return status;
    pp_known_case_add_per_cent(cases, "window 3 x 1.8 m at 3 m, clear single glass",
                               "exact", pp_known_room_at_point(&room, PP_SC, "exact"),
                               3.424, 3);
    pp_known_room_clear(&room);
    return PP_OK;
}

static void check_skies(struct pp_known_cases *cases)
{
    struct pp_sky overcast = pp_sky_overcast(), uniform = pp_sky_uniform();
    struct pp_vec3 up = {0.0, 0.0, 1.0}, south = {0.0, -1.0, 0.0};
    pp_known_case_add(cases, "horizontal plane under an open overcast sky", "sky",
                      pp_sky_on_plane(&overcast, up), 1.0, 1e-9);
    pp_known_case_add(cases, "horizontal plane under an open uniform sky", "sky",
                      pp_sky_on_plane(&uniform, up), 1.0, 1e-9);
    pp_known_case_add_per_cent(cases, "vertical plane under an open overcast sky",
                               "sky", pp_sky_on_plane(&overcast, south), 39.6177, 4);
    pp_known_case_add_per_cent(
        cases, "sky above an endless skyline of 25 degrees, overcast", "sky",
        pp_graded_sky_over_skyline(PP_GRADED_SKY_OVERCAST, 25.0 * PP_RAD), 27.31, 2);
    pp_known_case_add_per_cent(
        cases, "sky above an endless skyline of 25 degrees, uniform", "sky",
        pp_graded_sky_over_skyline(PP_GRADED_SKY_UNIFORM, 25.0 * PP_RAD), 28.87, 2);
    struct pp_glass glass = pp_glass_clear_single();
    pp_known_case_add(cases, "clear single glass, light at normal incidence", "glass",
                      glass.normal, 0.900, 5.001e-4);
    pp_known_case_add(cases, "clear single glass, diffuse light", "glass",
                      glass.diffuse, 0.827, 5.001e-4);
}

/* ---- traced ---- */

/* Checks a component at one receiver, within four standard errors. */
static enum pp_status check_traced(struct pp_known_cases *cases, const char *what,
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_receiver *receiver,
                                   enum pp_component component, double expected,
                                   const struct pp_known_trace *how,
                                   struct pp_error *err)
{
    struct pp_reading readings[1][PP_COMPONENT_COUNT];
    enum pp_status status =
        pp_known_room_trace(readings, world, light, receiver, 1, how, err);
    if (status == PP_OK)
        pp_known_case_add_traced(cases, what, readings[0][component], expected, 4.0);
    return status;
}

static const struct pp_receiver facing_up = {.position = {1.0, 1.0, 1.0},
                                             .normal = {0.0, 0.0, 1.0}};

/* Checks points under the open sky, without any surface. */
static enum pp_status check_open_sky(struct pp_known_cases *cases,
                                     const struct pp_known_trace *how,
                                     struct pp_error *err)
{
    const struct pp_world world = {0};
    const struct pp_outside_light light = {.sky = pp_sky_overcast()};
    struct pp_receiver upright = facing_up;
    upright.normal = pp_vec(0.0, -1.0, 0.0);
    enum pp_status status =
        check_traced(cases, "horizontal plane under an open overcast sky", &world,
                     &light, &facing_up, PP_SC, 1.0, how, err);
    if (status == PP_OK)
        status = check_traced(cases, "vertical plane under an open overcast sky",
                              &world, &light, &upright, PP_SC, 0.39617706, how, err);
    return status;
}

/* In a closed room of any form, with exitance 1 and reflectance rho everywhere, the
 * illuminance is 1 + rho + rho^2 + ... = 1/(1 - rho), as in an integrating sphere. */
static enum pp_status check_closed_cube(struct pp_known_cases *cases,
                                        const struct pp_known_trace *how,
                                        struct pp_error *err)
{
    static const double reflectances[] = {0.2, 0.5, 0.8};
    struct pp_world *world = NULL;
    struct pp_outside_light light;
    struct pp_receiver oblique = facing_up;
    oblique.position = pp_vec(0.6, 1.3, 0.7);
    oblique.normal = pp_vec_unit(pp_vec(0.2, 0.3, 1.0));
    enum pp_status status = pp_known_room_world(
        &world, &light,
        "<room version='1'><plan width='2' depth='2' height='2'/><point x='1' y='1'/>"
        "</room>",
        err);
    for (int i = 0; i < 3 && status == PP_OK; i++) {
        char what[80];
        for (int k = 0; k < world->surface_count; k++) {
            world->surfaces[k].exitance = 1.0;
            world->surfaces[k].front = reflectances[i];
        }
        snprintf(what, sizeof what,
                 "closed room with luminous surfaces, 1/(1 - rho), rho %g",
                 reflectances[i]);
        status = check_traced(cases, what, world, &light, &oblique, PP_IRC,
                              1.0 / (1.0 - reflectances[i]), how, err);
    }
    pp_world_destroy(world);
    return status;
}

/* Configuration factor of a rectangle parallel to the receiver, with a corner above the
 * receiver; a, b: its sides divided by its distance. */
static double parallel_factor(double a, double b)
{
    double p = sqrt(1.0 + a * a), q = sqrt(1.0 + b * b);
    return (a / p * atan(b / p) + b / q * atan(a / q)) / (2.0 * PP_PI);
}

/* Configuration factor of a rectangle perpendicular to the receiver's plane, with its
 * lower edge in that plane and a corner in front of the receiver; w, h: width and
 * height divided by the distance. */
static double upright_factor(double w, double h)
{
    double r = sqrt(1.0 + h * h);
    return (atan(w) - atan(w / r) / r) / (2.0 * PP_PI);
}

/* Checks the configuration factor of one luminous surface in a black room, 4 x 3 x 2.5
 * m, at a point of the floor 1 m from two walls. */
static enum pp_status check_configuration_factors(struct pp_known_cases *cases,
                                                  const struct pp_known_trace *how,
                                                  struct pp_error *err)
{
    const double h = 2.5;
    const struct {
        const char *what;
        struct pp_vec3 inward;
        double factor;
    } list[] = {
        {"configuration factor of a luminous ceiling",
         {0.0, 0.0, -1.0},
         parallel_factor(1.0 / h, 1.0 / h) + parallel_factor(3.0 / h, 1.0 / h)
             + parallel_factor(1.0 / h, 2.0 / h) + parallel_factor(3.0 / h, 2.0 / h)},
        {"configuration factor of a luminous wall",
         {0.0, 1.0, 0.0},
         upright_factor(1.0, h) + upright_factor(3.0, h)},
    };
    struct pp_world *world = NULL;
    struct pp_outside_light light;
    struct pp_receiver floor = facing_up;
    floor.position.z = 0.0;
    enum pp_status status = pp_known_room_world(
        &world, &light,
        "<room version='1'><plan width='4' depth='3' height='2.5'/><finishes "
        "floor='0' walls='0' ceiling='0'/><point x='1' y='1'/></room>",
        err);
    for (size_t i = 0; i < sizeof list / sizeof list[0] && status == PP_OK; i++) {
        for (int k = 0; k < world->surface_count; k++)
            world->surfaces[k].exitance =
                pp_vec_dot(world->surfaces[k].outline.normal, list[i].inward) > 0.9;
        status = check_traced(cases, list[i].what, world, &light, &floor, PP_IRC,
                              list[i].factor, how, err);
    }
    pp_world_destroy(world);
    return status;
}

/* Checks windows whose sky component is known in closed form or by quadrature, and a
 * room without light. */
static enum pp_status check_windows(struct pp_known_cases *cases,
                                    const struct pp_known_trace *how,
                                    struct pp_error *err)
{
    static const struct {
        const char *what, *xml;
        double per_cent;
        enum pp_component component;
    } list[] = {
        {"vertical opening 1 x 1 m at 1 m, overcast sky",
         "<room version='1'><plan width='4' depth='4' height='4'/><window wall='south' "
         "left='1' sill='1' height='1' width='1' glazing='none'/>"
         "<working-plane height='1'/><point x='1' y='1'/></room>",
         4.52508, PP_SC},
        {"horizontal opening 1 x 1 m at 1 m, overcast sky",
         "<room version='1'><plan width='4' depth='4' height='2'/><rooflight x='1' "
         "y='1' width='1' depth='1' glazing='none'/><working-plane height='1'/>"
         "<point x='1' y='1'/></room>",
         15.94970, PP_SC},
        {"closed room without light",
         "<room version='1'><plan width='4' depth='4' height='4'/><point x='1' y='1'/>"
         "</room>",
         0.0, PP_DF},
    };
    enum pp_status status = PP_OK;
    for (size_t i = 0; i < sizeof list / sizeof list[0] && status == PP_OK; i++) {
        struct pp_world *world = NULL;
        struct pp_outside_light light;
        status = pp_known_room_world(&world, &light, list[i].xml, err);
        if (status == PP_OK)
            status =
                check_traced(cases, list[i].what, world, &light, world->receivers,
                             list[i].component, list[i].per_cent / 100.0, how, err);
        pp_world_destroy(world);
    }
    return status;
}

/* Checks the sky component of the hall's window through glass, simulated and by
 * `exact`. Both calculations are independent of each other. */
static enum pp_status check_traced_and_exact(struct pp_known_cases *cases,
                                             const struct pp_known_trace *how,
                                             struct pp_error *err)
{
    struct pp_known_room room;
    enum pp_status status =
        pp_known_room_evaluate(&room, PP_KNOWN_HALL "</room>", "exact", err);
    if (status != PP_OK)
        return status;
    status = check_traced(cases, "window 3 x 1.8 m at 3 m, glazed, compared with exact",
                          room.world, &room.light, room.world->receivers, PP_SC,
                          pp_known_room_at_point(&room, PP_SC, "exact"), how, err);
    pp_known_room_clear(&room);
    return status;
}

enum pp_status pp_closed_forms(struct pp_known_cases *cases,
                               const struct pp_known_trace *how, struct pp_error *err)
{
    check_skies(cases);
    enum pp_status status = check_rectangles(cases, err);
    if (status == PP_OK)
        status = check_glass(cases, err);
    static enum pp_status (*const traced[])(
        struct pp_known_cases *, const struct pp_known_trace *, struct pp_error *) = {
        check_open_sky, check_closed_cube, check_configuration_factors, check_windows,
        check_traced_and_exact};
    for (size_t i = 0; i < sizeof traced / sizeof *traced && status == PP_OK; i++)
        status = traced[i](cases, how, err);
    return status;
}
