/* protractor_upright.c - `protractor-upright`: direct component at vertical receivers,
 * by protractors constructed like the published ones [BRE309].
 *
 * The published protractors are for points that face up. For vertical receivers there
 * are two of the same construction (protractor_scale.h): one for a receiver that faces
 * the window squarely and one for a receiver at right angles to that. At an azimuth psi
 * from the window's normal the reading is cos psi times the first plus sin psi times
 * the second:
 *
 *   1. the window is cut along the vertical line where the receiver's plane meets it
 *   2. both primary scales are read at the upper and the lower sight line: i and j
 *   3. both auxiliary scales are read at the jambs, for the average altitude: K, as on
 *      the published ones, and J, the reading at the right jamb less that at the left
 *   4. SC = i K cos psi + j J sin psi; ERC is the same for the obstruction, times its
 *      luminance factor
 *
 * The method is for vertical openings with clear glass or none, under the overcast or
 * the uniform sky. Light from below the horizon is not counted. The figures contain
 * clear single glass.
 */
#include <math.h>
#include <stdlib.h>

#include "methods/method.h"
#include "methods/part_steps.h"
#include "methods/protractor/protractor_dial.h"
#include "methods/refusals.h"
#include "methods/view/elevation.h"
#include "methods/view/visible.h"

/* The two protractors for openings with glass, and those for openings without. */
struct upright_dials {
    struct pp_protractor_dial ahead, aside;
};
struct upright_set {
    struct upright_dials *glazed, *bare;
};

/* ---- the formulae ---- */

static const struct pp_formula_quantity of_primary[] = {
    {"p_u", PP_UNIT_DAYLIGHT_FACTOR,
     "reading of the primary scale at the upper edge, for a receiver facing the "
     "window"},
    {"p_l", PP_UNIT_DAYLIGHT_FACTOR,
     "reading of the primary scale at the lower edge, for a receiver facing the "
     "window"},
    {"q_u", PP_UNIT_DAYLIGHT_FACTOR,
     "reading of the primary scale at the upper edge, for a receiver side-on to the "
     "window"},
    {"q_l", PP_UNIT_DAYLIGHT_FACTOR,
     "reading of the primary scale at the lower edge, for a receiver side-on to the "
     "window"},
    {0},
};
static const struct pp_formula_quantity of_auxiliary[] = {
    {"k_r", PP_UNIT_NUMBER,
     "reading of the auxiliary scale at the right jamb, for a receiver facing the "
     "window"},
    {"k_l", PP_UNIT_NUMBER,
     "reading of the auxiliary scale at the left jamb, for a receiver facing the "
     "window (negative to the left)"},
    {"m_r", PP_UNIT_NUMBER,
     "reading of the auxiliary scale at the right jamb, for a receiver side-on to the "
     "window"},
    {"m_l", PP_UNIT_NUMBER,
     "reading of the auxiliary scale at the left jamb, for a receiver side-on to the "
     "window"},
    {0},
};
static const struct pp_formula_quantity of_component[] = {
    {"i", PP_UNIT_DAYLIGHT_FACTOR,
     "initial component for a receiver facing the window"},
    {"K", PP_UNIT_NUMBER,
     "correction factor for the width, receiver facing the window"},
    {"j", PP_UNIT_DAYLIGHT_FACTOR,
     "initial component for a receiver side-on to the window"},
    {"J", PP_UNIT_NUMBER,
     "correction factor for the width, receiver side-on to the window"},
    {"psi", PP_UNIT_ANGLE,
     "horizontal angle of the receiver from the normal of the window (positive to the "
     "right)"},
    {0},
};
static const struct pp_formula_quantity of_reflected[] = {
    {"e", PP_UNIT_DAYLIGHT_FACTOR, "equivalent sky component of the obstruction"},
    {"f", PP_UNIT_NUMBER, "luminance factor of the obstruction"},
    {0},
};

#define READ(left, right, of, words, list)                                             \
    {                                                                                  \
        .symbol = left, .sum = right, .unit = of, .source = "BRE309", .what = words,   \
        .quantities = list, .fixed = true                                              \
    }
static const struct pp_formula initial_ahead =
    READ("i", "p_u - p_l", PP_UNIT_DAYLIGHT_FACTOR,
         "initial component for a receiver facing the window", of_primary);
static const struct pp_formula initial_aside =
    READ("j", "q_u - q_l", PP_UNIT_DAYLIGHT_FACTOR,
         "initial component for a receiver side-on to the window", of_primary);
static const struct pp_formula width_ahead =
    READ("K", "k_r - k_l", PP_UNIT_NUMBER,
         "correction factor for the width, receiver facing the window", of_auxiliary);
static const struct pp_formula width_aside = READ(
    "J", "m_r - m_l", PP_UNIT_NUMBER,
    "correction factor for the width, receiver side-on to the window", of_auxiliary);
static const struct pp_formula sky_component =
    READ("sc", "max(i K cos(psi) + j J sin(psi), 0)", PP_UNIT_DAYLIGHT_FACTOR,
         "sky component", of_component);
static const struct pp_formula equivalent =
    READ("e", "max(i K cos(psi) + j J sin(psi), 0)", PP_UNIT_DAYLIGHT_FACTOR,
         "equivalent sky component of the obstruction", of_component);
static const struct pp_formula reflected =
    READ("erc", "f e", PP_UNIT_DAYLIGHT_FACTOR, "externally reflected component",
         of_reflected);

static const struct pp_formula *const formulae[] = {
    &initial_ahead, &initial_aside, &width_ahead, &width_aside,
    &sky_component, &equivalent,    &reflected,   NULL};

/* ---- the protractors ---- */

static void destroy_upright_protractor_tools(void *tools)
{
    struct upright_set *set = tools;
    if (set) {
        free(set->glazed);
        free(set->bare);
    }
    free(set);
}

static struct upright_dials *dials_of(const struct pp_sky *sky, struct pp_glass glass)
{
    struct upright_dials *dials = malloc(sizeof *dials);
    struct pp_protractor protractor = {.sky = *sky,
                                       .glass = glass,
                                       .slope_rad = PP_PI / 2.0,
                                       .receiver = PP_PROTRACTOR_AHEAD};
    if (!dials)
        return NULL;
    pp_protractor_dial_init(&dials->ahead, &protractor);
    protractor.receiver = PP_PROTRACTOR_ASIDE;
    pp_protractor_dial_init(&dials->aside, &protractor);
    return dials;
}

static enum pp_status prepare_upright_protractor(void **tools,
                                                 const struct pp_world *world,
                                                 const struct pp_outside_light *light,
                                                 struct pp_error *err)
{
    (void)world;
    struct upright_set *set = malloc(sizeof *set);
    if (!set)
        return pp_fail_memory(err);
    *set = (struct upright_set){dials_of(&light->sky, pp_glass_clear_single()),
                                dials_of(&light->sky, pp_glass_none())};
    if (set->glazed && set->bare) {
        *tools = set;
        return PP_OK;
    }
    destroy_upright_protractor_tools(set);
    return pp_fail_memory(err);
}

static const char *upright_protractor_refuses_room(const struct pp_world *world,
                                                   const struct pp_outside_light *light,
                                                   const struct pp_receiver *receiver)
{
    if (!pp_sky_is_graded(&light->sky))
        return "valid only for the overcast and the uniform sky";
    if (receiver && fabs(receiver->normal.z) > 1e-9)
        return "valid only for points that face horizontally";
    const char *why = pp_refusals_if_mesh(world);
    return why ? why : pp_refusals_if_luminous(world);
}

static const char *upright_protractor_refuses(const struct pp_world *world,
                                              const struct pp_outside_light *light,
                                              const struct pp_opening *opening,
                                              const struct pp_receiver *receiver)
{
    (void)world, (void)light, (void)receiver;
    if (opening->glass.diffusing)
        return "has diffusing glass, but protractors are for clear glass only";
    return pp_refusals_unless_vertical(opening);
}

/* ---- the sum ---- */

/* Symbols for the readings of both scales of one protractor, and the name of its
 * receiver. */
struct scale_symbols {
    const char *upper, *lower, *left, *right, *what;
};

static void put_scales(struct pp_worksheet *sheet,
                       const struct pp_protractor_dial *dial,
                       const struct scale_symbols *symbols,
                       const struct pp_elevation_part *part)
{
    double high = atan(part->high), low = atan(fmax(part->low, 0.0));
    double average = (high + low) / 2.0, sides[2];
    const double jambs[2] = {atan(part->left), atan(part->right)};
    for (int i = 0; i < 2; i++) {
        sides[i] = pp_protractor_dial_factor(dial, average, jambs[i], false);
        if (dial->protractor.receiver == PP_PROTRACTOR_ASIDE)
            sides[i] = fabs(sides[i]);
    }
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR,
                     pp_protractor_dial_share(dial, high), symbols->upper,
                     "reading of the primary scale for a receiver %s, at the upper "
                     "edge",
                     symbols->what);
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR,
                     pp_protractor_dial_share(dial, low), symbols->lower,
                     "reading of the same scale at the lower edge");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, sides[0], symbols->left,
                     "reading of the auxiliary scale for a receiver %s, at the left "
                     "jamb",
                     symbols->what);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, sides[1], symbols->right,
                     "reading of the same scale at the right jamb");
}

static void work_part(struct pp_part_steps *terms, struct pp_part *sum,
                      const struct upright_dials *dials, const struct pp_sky *sky,
                      const struct pp_elevation_part *part)
{
    static const struct scale_symbols ahead = {"p_u", "p_l", "k_l", "k_r",
                                               "facing the window"};
    static const struct scale_symbols aside = {"q_u", "q_l", "m_l", "m_r",
                                               "side-on to the window"};
    struct pp_worksheet *sheet = terms->sheet;
    bool hidden = !isnan(part->reflectance);
    pp_part_steps_next(terms);
    pp_worksheet_note(sheet, PP_UNIT_ANGLE, atan(part->high),
                      "altitude of the upper edge of the %s",
                      hidden ? "obstruction" : "opening");
    pp_worksheet_note(sheet, PP_UNIT_ANGLE, atan(fmax(part->low, 0.0)),
                      "altitude of the lower edge");
    pp_worksheet_note(sheet, PP_UNIT_ANGLE, atan(part->left),
                      "angle of the left jamb from the normal (positive to the right)");
    pp_worksheet_note(sheet, PP_UNIT_ANGLE, atan(part->right),
                      "angle of the right jamb from the normal");
    put_scales(sheet, &dials->ahead, &ahead, part);
    put_scales(sheet, &dials->aside, &aside, part);
    pp_worksheet_work(sheet, &initial_ahead,
                      "initial component for a receiver facing the window");
    pp_worksheet_work(sheet, &width_ahead,
                      "correction factor for the width, receiver facing the window");
    pp_worksheet_work(sheet, &initial_aside,
                      "initial component for a receiver side-on to the window");
    pp_worksheet_work(
        sheet, &width_aside,
        "correction factor for the width, receiver side-on to the window");
    if (!hidden) {
        sum->sky += pp_part_steps_work(terms, false, &sky_component, "sky component");
        return;
    }
    pp_worksheet_work(sheet, &equivalent,
                      "equivalent sky component of the obstruction");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER,
                     pp_visible_luminance_factor(sky, part->reflectance), "f",
                     "luminance factor of the obstruction");
    sum->external +=
        pp_part_steps_work(terms, true, &reflected, "externally reflected component");
}

/* Keeps the parts in front of the receiver's own plane. That plane crosses the
 * opening's plane in a vertical line, 90 degrees from the direction that the receiver
 * faces. */
static void cut_by_receiver(struct pp_elevation *elevation, double psi_rad)
{
    double left = psi_rad > 0.0 ? tan(psi_rad - PP_PI / 2.0) : -INFINITY;
    double right = psi_rad < 0.0 ? tan(psi_rad + PP_PI / 2.0) : INFINITY;
    int count = 0;
    for (int i = 0; i < elevation->count; i++) {
        struct pp_elevation_part part = elevation->parts[i];
        part.left = fmax(part.left, left);
        part.right = fmin(part.right, right);
        if (part.left < part.right)
            elevation->parts[count++] = part;
    }
    elevation->count = count;
}

static enum pp_status evaluate_upright_protractor(
    const struct pp_world *world, const struct pp_outside_light *light,
    const struct pp_opening *opening, const struct pp_receiver *receiver,
    const void *tools, struct pp_part *part, struct pp_error *err)
{
    const struct upright_set *set = tools;
    struct pp_vec3 out = pp_vec_scale(opening->inner.normal, -1.0);
    double psi_rad = atan2(pp_vec_dot(receiver->normal, opening->along),
                           pp_vec_dot(receiver->normal, out));
    struct pp_elevation elevation;
    enum pp_status status =
        pp_elevation_init(&elevation, world, opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    cut_by_receiver(&elevation, psi_rad);
    pp_worksheet_put(&part->sheet, PP_UNIT_ANGLE, psi_rad, "psi",
                     "horizontal angle of the receiver from the normal of the window "
                     "(positive to the right)");
    struct pp_part_steps terms = pp_part_steps_on(&part->sheet, elevation.count);
    for (int i = 0; i < elevation.count; i++)
        work_part(&terms, part, opening->glass.panes > 0 ? set->glazed : set->bare,
                  &light->sky, &elevation.parts[i]);
    pp_part_steps_end(&terms);
    pp_elevation_clear(&elevation);
    return PP_OK;
}

const struct pp_method pp_method_protractor_upright = {
    .name = "protractor-upright",
    .summary = "direct component at points that face horizontally, by protractors for "
               "vertical planes",
    .source = "BRE309",
    .formulae = formulae,
    .gives = PP_GIVES_DIRECT,
    .speaks_for = PP_FOR_POINT,
    .by_name = true,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_NO_GLASS,
    .prepare = prepare_upright_protractor,
    .destroy_tools = destroy_upright_protractor_tools,
    .refuses_room = upright_protractor_refuses_room,
    .refuses = upright_protractor_refuses,
    .evaluate = evaluate_upright_protractor,
};
