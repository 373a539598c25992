/* cie171.c - makes the rooms of CIE 171 and compares their results with the report's
 * table, in the order of the table. */
#include "studies/research/validation/cie171.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "methods/exact/quadrature.h"
#include "methods/method.h"
#include "methods/view/visible.h"

/* One row of the table; values in per cent. Texts are arrays, not pointers, since each
 * pointer would need a relocation at every start. */
struct figure {
    char scene[16];
    double a, b, sky;
    double x, y, z, nx, ny, nz, sun_y;
    double value, check;
    char flag[8];
};

static const struct figure figures[] = {
#include "tables/cie171.inc"
};

enum {
    FIGURES = sizeof figures / sizeof *figures,
    POINTS_MOST = 32, /* most points of one room */
};

/* Tolerances for the independent integration (three decimals; coarser if a mask cuts
 * the opening), and for printed values (two decimals). */
static const double CHECK_SHARE = 0.001, MASKED_SHARE = 0.0025, CHECK_LEAST = 0.001e-2;
static const double PRINTED_SHARE = 0.01, PRINTED_LEAST = 0.02e-2;

/* ---- the rooms ---- */

static bool is_glazed(const struct figure *figure)
{
    return strstr(figure->scene, "glass") != NULL;
}

/* A plane outside that is so long that an infinite plane would give the same last
 * digit. */
#define PLANE                                                                          \
    "<surface reflectance='0' exitance='%g'><vertex x='-2000' y='%g' z='%g'/>"         \
    "<vertex x='2000' y='%g' z='%g'/><vertex x='2000' y='%g' z='%g'/>"                 \
    "<vertex x='-2000' y='%g' z='%g'/></surface>"

/* Exitance of the canopy's underside that reproduces the printed values. For a building
 * opposite, no exitance reproduces the printed values; those cases have sky light
 * only. */
static const double CANOPY_EXITANCE = 0.05;

/* Writes the opening and the obstructions as elements of a room file. */
static void write_opening(char *text, size_t size, const struct figure *figure)
{
    const char *glass = is_glazed(figure) ? "clear-single" : "none";
    double a = figure->a, b = figure->b;
    if (strncmp(figure->scene, "roof", 4) == 0)
        snprintf(text, size,
                 "<rooflight x='%g' y='%g' width='%g' depth='%g' glazing='%s'/>",
                 2.0 - a / 2.0, 2.0 - b / 2.0, a, b, glass);
    else if (strncmp(figure->scene, "facade", 6) == 0)
        snprintf(text, size,
                 "<window wall='south' left='%g' sill='%g' width='%g' height='%g' "
                 "glazing='%s'/>",
                 2.0 - a / 2.0, b < 3.0 ? 1.0 : 0.0, a, b, glass);
    else if (strcmp(figure->scene, "canopy") == 0)
        snprintf(text, size,
                 "<window wall='south' left='1' sill='1' width='2' height='1' "
                 "glazing='none'/>" PLANE,
                 CANOPY_EXITANCE, 0.0, 3.0, 0.0, 3.0, -a, 3.0, -a, 3.0);
    else
        snprintf(text, size,
                 "<window wall='south' left='1' sill='1' width='2' height='1' "
                 "glazing='none'/>" PLANE,
                 0.0, -6.0, 0.0, -6.0, 0.0, -6.0, a, -6.0, a);
}

/* Makes the room of a figure. The ground is lit as if there were no building on it. */
static enum pp_status build_room(struct pp_world **world,
                                 struct pp_outside_light *light,
                                 const struct figure *figure, struct pp_error *err)
{
    char opening[700], sky[128], xml[1200];
    write_opening(opening, sizeof opening, figure);
    if (figure->sky == 16.0)
        snprintf(sky, sizeof sky, "<sky type='overcast'/>");
    else
        snprintf(sky, sizeof sky,
                 "<sky type='iso-%g' sun-altitude='60' sun-bearing='%d'/>", figure->sky,
                 figure->sun_y > 0.0 ? 0 : 180);
    snprintf(xml, sizeof xml,
             "<room version='1'><site ground-reflectance='0.3' ground='open'/>%s"
             "<plan width='4' depth='4' height='3'/>"
             "<finishes floor='0' walls='0' ceiling='0'/>%s</room>",
             sky, opening);
    return pp_known_room_world(world, light, xml, err);
}

static bool same_room(const struct figure *one, const struct figure *other)
{
    return one->a == other->a && one->b == other->b && one->sky == other->sky
           && one->sun_y == other->sun_y && strcmp(one->scene, other->scene) == 0;
}

static struct pp_receiver receiver_of(const struct figure *figure)
{
    return (struct pp_receiver){{figure->x, figure->y, figure->z},
                                {figure->nx, figure->ny, figure->nz},
                                0,
                                0.0};
}

/* ---- the report's glass ---- */

static double polynomial_glass(double c)
{
    double tau =
        -0.028378
        + c
              * (3.156075
                 + c * (-3.058376 + c * (-1.428919 + c * (4.014235 - c * 1.775827))));
    return fmax(tau, 0.0);
}

struct through_glass {
    const struct pp_sky *sky; /* NULL: uniform luminance */
    struct pp_vec3 toward;
};

static double luminance(const void *context, struct pp_vec3 u)
{
    const struct through_glass *through = context;
    return (through->sky ? pp_sky_luminance(through->sky, u) : 1.0)
           * polynomial_glass(pp_vec_dot(through->toward, u));
}

/* Integrates the light of the visible directions above the horizon (up = 1: the sky) or
 * below it (up = -1: uniform luminance). */
static enum pp_status integrate_visible(double *value, const struct pp_visible *visible,
                                        struct pp_vec3 normal, double up,
                                        const struct pp_sky *sky, struct pp_error *err)
{
    const struct through_glass through = {sky, visible->view.toward};
    const struct pp_integrand integrand = {
        luminance, &through, sky && pp_sky_has_azimuth(sky) ? &sky->sun : NULL, 0.0};
    const struct pp_vec3 limits[2] = {normal, {0.0, 0.0, up}};
    struct pp_quadrature result = {0};
    enum pp_status status =
        pp_quadrature_over(&result, &visible->view, &visible->patches[0].region, limits,
                           2, normal, &integrand, 1e-6, err);
    *value = result.value;
    return status;
}

static enum pp_status through_polynomial(double *value, const struct pp_world *world,
                                         const struct pp_outside_light *light,
                                         const struct pp_receiver *receiver,
                                         struct pp_error *err)
{
    struct pp_visible visible;
    double sky = 0.0, ground = 0.0;
    enum pp_status status =
        pp_visible_through(&visible, world, world->openings, receiver->position, err);
    if (status != PP_OK)
        return status;
    if (visible.patch_count > 0) {
        status =
            integrate_visible(&sky, &visible, receiver->normal, 1.0, &light->sky, err);
        if (status == PP_OK)
            status =
                integrate_visible(&ground, &visible, receiver->normal, -1.0, NULL, err);
    }
    pp_visible_clear(&visible);
    *value = sky + light->ground_reflectance / PP_PI * ground;
    return status;
}

/* ---- the values ---- */

static double check_share(const struct figure *figure)
{
    bool masked =
        strcmp(figure->scene, "canopy") == 0 || strcmp(figure->scene, "opposite") == 0;
    return masked ? MASKED_SHARE : CHECK_SHARE;
}

static double within(double share, double least, double per_cent)
{
    return fmax(least, 0.01 * share * per_cent);
}

static enum pp_status by_exact(double *value, const struct pp_world *world,
                               const struct pp_outside_light *light,
                               const struct pp_receiver *receiver, struct pp_error *err)
{
    struct pp_part part = {0};
    enum pp_status status = pp_method_exact.evaluate(world, light, world->openings,
                                                     receiver, NULL, &part, err);
    *value = part.sky + part.external;
    return status;
}

/* Writes the name of a case's experiment: "5.9, roof 1 x 1 m". */
static void name_group(char text[48], const struct figure *figure)
{
    static const struct {
        const char *scene, *words;
    } names[] = {
        {"roof", "case 5.9, roof %g x %g m"},
        {"roof-glass", "case 5.10, glazed roof %g x %g m"},
        {"facade", "case 5.11, facade %g x %g m"},
        {"facade-glass", "case 5.12, glazed facade %g x %g m"},
        {"canopy", "case 5.13, canopy %g m"},
        {"opposite", "case 5.14, mask opposite %g m"},
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(figure->scene, names[i].scene) == 0)
            snprintf(text, 48, names[i].words, figure->a, figure->b);
}

/* Adds the cases of one row of the table: by `exact`, and by simulation if `traced` is
 * not NULL. */
static enum pp_status add_figure(struct pp_known_cases *cases,
                                 const struct figure *figure,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_reading *traced, double std_errors,
                                 struct pp_error *err)
{
    struct pp_receiver receiver = receiver_of(figure);
    double exact, answer;
    char what[80];
    enum pp_status status = by_exact(&exact, world, light, &receiver, err);
    answer = exact;
    if (status == PP_OK && is_glazed(figure))
        status = through_polynomial(&answer, world, light, &receiver, err);
    if (status != PP_OK)
        return status;
    snprintf(what, sizeof what, "sky %g, at %g, %g, %g", figure->sky, figure->x,
             figure->y, figure->z);
    pp_known_case_add(cases, what, "exact", answer, 0.01 * figure->check,
                      within(check_share(figure), CHECK_LEAST, figure->check));
    if (traced)
        pp_known_case_add_traced(cases, what, *traced, exact, std_errors);
    snprintf(what, sizeof what, "sky %g, at %g, %g, %g, as printed", figure->sky,
             figure->x, figure->y, figure->z);
    if (strcmp(figure->flag, "ok") == 0)
        pp_known_case_add(cases, what, "exact", answer, 0.01 * figure->value,
                          within(PRINTED_SHARE, PRINTED_LEAST, figure->value));
    return PP_OK;
}

/* Adds the rows of one room, which are adjacent in the table. */
static enum pp_status add_room(struct pp_known_cases *cases,
                               const struct figure *figure, int count,
                               const struct pp_known_trace *how, double std_errors,
                               struct pp_error *err)
{
    struct pp_world *world = NULL;
    struct pp_outside_light light;
    struct pp_receiver receivers[POINTS_MOST];
    struct pp_reading readings[POINTS_MOST][PP_COMPONENT_COUNT];
    char group[48] = "";
    for (int i = 0; i < count; i++)
        receivers[i] = receiver_of(&figure[i]);
    name_group(group, figure);
    cases->group = group;
    enum pp_status status = build_room(&world, &light, figure, err);
    if (status == PP_OK && how)
        status =
            pp_known_room_trace(readings, world, &light, receivers, count, how, err);
    for (int i = 0; i < count && status == PP_OK; i++)
        status = add_figure(cases, &figure[i], world, &light,
                            how ? &readings[i][PP_DF] : NULL, std_errors, err);
    cases->group = NULL;
    pp_world_destroy(world);
    return status;
}

enum pp_status pp_cie171(struct pp_known_cases *cases, const struct pp_known_trace *how,
                         double std_errors, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int first = 0, end; first < FIGURES && status == PP_OK; first = end) {
        for (end = first + 1; end < FIGURES && end - first < POINTS_MOST
                              && same_room(&figures[first], &figures[end]);
             end++)
            continue;
        status = add_room(cases, &figures[first], end - first, how, std_errors, err);
    }
    return status;
}
