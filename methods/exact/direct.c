/* direct.c - chooses closed form, table or quadrature for each patch of a view, and
 * adds up the results. */
#include "methods/exact/direct.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/exact/pane_luminance.h"
#include "methods/part_steps.h"

/* ---- closed forms ---- */

enum { CORNERS_ON_STACK = 64 };

/* Writes the patch's half-spaces and `more` into one array; returns their number. */
static int join_half_spaces(struct pp_vec3 all[PP_HALF_SPACES_MOST],
                            const struct pp_visible_patch *patch,
                            const struct pp_vec3 *more, int more_count)
{
    int count = 0;
    for (int i = 0; i < patch->half_space_count; i++)
        all[count++] = patch->half_spaces[i];
    for (int i = 0; i < more_count; i++)
        all[count++] = more[i];
    return count;
}

enum pp_status pp_direct_moments(struct pp_moments *moments,
                                 const struct pp_visible *visible,
                                 const struct pp_visible_patch *patch,
                                 struct pp_vec3 normal, const struct pp_vec3 *more,
                                 int more_count, struct pp_error *err)
{
    struct pp_vec3 limits[PP_HALF_SPACES_MOST];
    int limit_count = join_half_spaces(limits, patch, more, more_count);
    *moments = (struct pp_moments){0};
    for (int r = 0; r < patch->region.count; r++) {
        const struct pp_ring *ring = &patch->region.rings[r];
        struct pp_vec3 stack[CORNERS_ON_STACK], *corners = stack;
        if (ring->count > CORNERS_ON_STACK) {
            corners = malloc((size_t)ring->count * sizeof *corners);
            if (!corners)
                return pp_fail_memory(err);
        }
        for (int i = 0; i < ring->count; i++)
            corners[i] = pp_projection_to_room(
                &visible->view,
                pp_vec(ring->xy[i][0], ring->xy[i][1], visible->view.distance_m));
        pp_solid_angle_add_moments(moments, corners, ring->count, normal, limits,
                                   limit_count);
        if (corners != stack)
            free(corners);
    }
    return PP_OK;
}

/* ---- steps of a patch ----
 *
 * For a sky with a closed form, the steps give the moments of the patch, the sky
 * component without glass calculated from them (solid_angle.h), and the mean
 * transmittance of the glass. For any other sky the steps give the value of the
 * integral.
 */

/* The results for one patch, divided by Eh. */
struct patch_figures {
    bool hidden;
    struct pp_moments moments; /* moments of the part above the horizon */
    bool closed_form; /* the sky component without glass follows from the moments in
                       * closed form */
    bool glazed;
    double above;  /* light through the glass from the sky; for an obstruction, from
                    * the sky that it hides, before `factor` is applied */
    double below;  /* light from the ground for a reflectance of 1; for an obstruction,
                    * light from its part below the horizon, for the luminance of the
                    * horizon */
    double own;    /* light from the obstruction's exitance */
    double factor; /* luminance factor of the obstruction, or reflectance of the
                    * ground */
};

struct sum_text {
    char text[80];
};

/* Formula for the sky component without glass; its factor is pi L(0)/Eh = 3/(3 +
 * 2b). */
static struct sum_text closed_form(const struct pp_sky *sky)
{
    double b = sky->gradation;
    struct sum_text sum = {"100 E_0# / pi"};
    if (b != 0.0)
        snprintf(sum.text, sizeof sum.text, "300 (E_0# + %g E_1#) / (%g pi)", b,
                 3.0 + 2.0 * b);
    return sum;
}

/* Records the terms of the sky component. Returns its formula; "" for an integral. */
static struct sum_text add_sky_terms(struct pp_part_steps *terms,
                                     const struct patch_figures *figures,
                                     const struct pp_sky *sky)
{
    const struct pp_moments *moments = &figures->moments;
    pp_part_steps_read(terms, PP_UNIT_NUMBER, moments->omega, "omega",
                       figures->hidden
                           ? "solid angle of the sky that the obstruction hides, sr"
                           : "solid angle of the visible sky, sr");
    if (!figures->closed_form)
        return (struct sum_text){""};
    pp_part_steps_read(
        terms, PP_UNIT_NUMBER, moments->cosine, "E_0",
        "integral of the cosine of the angle of incidence over this solid angle");
    if (sky->gradation != 0.0)
        pp_part_steps_read(terms, PP_UNIT_NUMBER, moments->cosine_sine, "E_1",
                           "integral of that cosine times the sine of the altitude");
    double bare = pp_solid_angle_sky_component(moments, sky);
    struct sum_text sum = closed_form(sky);
    if (!figures->glazed || !(bare > 0.0))
        return sum;
    pp_part_steps_figure(terms, PP_UNIT_DAYLIGHT_FACTOR, bare, "s", sum.text,
                         "sky component without glass, in closed form");
    pp_part_steps_read(terms, PP_UNIT_NUMBER, figures->above / bare, "t",
                       "mean transmittance over this solid angle, by quadrature");
    return (struct sum_text){"s# t#"};
}

/* Steps of a patch that shows sky and ground. */
static void add_sky_steps(struct pp_part_steps *terms,
                          const struct patch_figures *figures, const struct pp_sky *sky)
{
    struct sum_text formula = add_sky_terms(terms, figures, sky);
    pp_part_steps_component(terms, false, figures->above, formula.text,
                            formula.text[0] ? "sky component"
                                            : "sky component, by quadrature");
    if (figures->below == 0.0)
        return;
    pp_part_steps_read(terms, PP_UNIT_DAYLIGHT_FACTOR, figures->below, "c",
                       "component of the visible ground if its reflectance were 1");
    pp_part_steps_read(terms, PP_UNIT_NUMBER, figures->factor, "rho_g",
                       "reflectance of the ground");
    pp_part_steps_component(terms, true, figures->factor * figures->below, "rho_g# c#",
                            "externally reflected component");
}

/* Steps of a patch that shows an obstruction. */
static void add_hidden_steps(struct pp_part_steps *terms,
                             const struct patch_figures *figures,
                             const struct pp_sky *sky)
{
    struct sum_text formula = add_sky_terms(terms, figures, sky);
    pp_part_steps_figure(
        terms, PP_UNIT_DAYLIGHT_FACTOR, figures->above, "e", formula.text,
        formula.text[0] ? "equivalent sky component of the obstruction"
                        : "equivalent sky component of the obstruction, by quadrature");
    bool below = figures->below != 0.0, own = figures->own != 0.0;
    if (below)
        pp_part_steps_read(
            terms, PP_UNIT_DAYLIGHT_FACTOR, figures->below, "b",
            "component of the part of the obstruction below the horizon, with the same "
            "luminance");
    pp_part_steps_read(terms, PP_UNIT_NUMBER, figures->factor, "f",
                       "luminance factor of the obstruction");
    if (own)
        pp_part_steps_read(terms, PP_UNIT_DAYLIGHT_FACTOR, figures->own, "g",
                           "direct component of the light that the obstruction emits");
    pp_part_steps_component(
        terms, true, figures->factor * (figures->above + figures->below) + figures->own,
        below && own ? "f# (e# + b#) + g#"
        : below      ? "f# (e# + b#)"
        : own        ? "f# e# + g#"
                     : "f# e#",
        "externally reflected component");
}

/* Records the steps of a patch as the next part; records nothing for an empty patch. */
static void add_patch_steps(struct pp_part_steps *terms,
                            const struct patch_figures *figures,
                            const struct pp_sky *sky)
{
    bool nothing = !(figures->moments.omega > 1e-9) && figures->below == 0.0
                   && figures->own == 0.0;
    if (nothing)
        return;
    pp_part_steps_next(terms);
    if (figures->hidden)
        add_hidden_steps(terms, figures, sky);
    else
        add_sky_steps(terms, figures, sky);
}

/* ---- a patch ---- */

/* One patch, the receiver's normal, and the sum to which the patch is added. */
struct task {
    struct pp_direct *sum;
    const struct pp_visible *visible;
    const struct pp_visible_patch *patch;
    struct pp_vec3 normal;
    struct pp_pane_luminance lights;
};

static bool is_unglazed(const struct task *task)
{
    return task->lights.glass->panes == 0;
}

/* Side of the horizon. */
enum side { ABOVE, BELOW, BOTH };

/* Sets `limits` to the half-spaces in front of the receiver and on that side of the
 * horizon. Returns their number. */
static int limits_of(struct pp_vec3 limits[2], const struct task *task, enum side side)
{
    struct pp_vec3 up = {0.0, 0.0, side == ABOVE ? 1.0 : -1.0};
    limits[0] = task->normal;
    if (side == BOTH
        || (task->normal.x == 0.0 && task->normal.y == 0.0 && task->normal.z == up.z))
        return 1;
    limits[1] = up;
    return 2;
}

/* The part of the patch on one side of the horizon, for the tables; `limits` has room
 * for PP_HALF_SPACES_MOST. */
static struct pp_pane_part pane_part_of(const struct task *task, struct pp_vec3 *limits,
                                        enum side side)
{
    struct pp_vec3 sides[2];
    int count = limits_of(sides, task, side);
    return (struct pp_pane_part){
        .visible = task->visible,
        .patch = task->patch,
        .normal = task->normal,
        .half_spaces = limits,
        .half_space_count = join_half_spaces(limits, task->patch, sides, count),
        .glazed = !is_unglazed(task),
        .rough = task->sum->rough || task->sum->unglazed_error >= PP_QUADRATURE_PANE};
}

static enum pp_status by_quadrature(double *value, const struct task *task,
                                    enum side side, pp_luminance_function *luminance,
                                    const struct pp_vec3 *cusp, struct pp_error *err)
{
    struct pp_vec3 sides[2], limits[PP_HALF_SPACES_MOST];
    int count = limits_of(sides, task, side);
    count = join_half_spaces(limits, task->patch, sides, count);
    double grain_rad =
        luminance == pp_pane_luminance_unity ? 0.0 : pp_sky_grain(task->lights.sky);
    struct pp_integrand integrand = {luminance, &task->lights, cusp, grain_rad};
    double unglazed = task->sum->unglazed_error > 0.0 ? task->sum->unglazed_error
                                                      : PP_QUADRATURE_UNGLAZED;
    double relative_error = task->sum->rough    ? PP_QUADRATURE_ROUGH
                            : is_unglazed(task) ? unglazed
                                                : PP_QUADRATURE_GLAZED;
    struct pp_quadrature result;
    enum pp_status status =
        pp_quadrature_over(&result, &task->visible->view, &task->patch->region, limits,
                           count, task->normal, &integrand, relative_error, err);
    task->sum->error += result.error;
    *value = result.value;
    return status;
}

/* Integral of tau (n.u). */
static enum pp_status transmitted(double *value, const struct task *task,
                                  enum side side, struct pp_error *err)
{
    const struct pp_pane_light *tables = task->sum->tables;
    if (!is_unglazed(task) && tables && tables->glass) {
        struct pp_vec3 all[PP_HALF_SPACES_MOST];
        struct pp_pane_part part = pane_part_of(task, all, side);
        return pp_pane_light_transmitted(value, tables, &part, err);
    }
    if (!is_unglazed(task))
        return by_quadrature(value, task, side, pp_pane_luminance_unity, NULL, err);
    struct pp_vec3 limits[2];
    int count = limits_of(limits, task, side);
    struct pp_moments moments;
    enum pp_status status = pp_direct_moments(&moments, task->visible, task->patch,
                                              task->normal, limits, count, err);
    *value = moments.cosine;
    return status;
}

/* Integral of L tau (n.u) above the horizon: visible or hidden sky. */
static enum pp_status from_sky(double *value, const struct task *task,
                               struct pp_error *err)
{
    const struct pp_sky *sky = task->lights.sky;
    if (!is_unglazed(task) || !pp_solid_angle_has_closed_form(sky)) {
        struct pp_vec3 all[PP_HALF_SPACES_MOST];
        struct pp_pane_part part = pane_part_of(task, all, ABOVE);
        if (task->sum->tables && pp_pane_light_has_sky(task->sum->tables, sky, &part))
            return pp_pane_light_sky(value, task->sum->tables, sky, &part, err);
        return by_quadrature(
            value, task, ABOVE, pp_pane_luminance_sky,
            sky->kind == PP_SKY_ISO && pp_sky_has_azimuth(sky) ? &sky->sun : NULL, err);
    }
    struct pp_vec3 limits[2];
    int count = limits_of(limits, task, ABOVE);
    struct pp_moments moments;
    enum pp_status status = pp_direct_moments(&moments, task->visible, task->patch,
                                              task->normal, limits, count, err);
    *value = pp_solid_angle_sky_component(&moments, sky);
    return status;
}

/* Integral of the horizon's luminance times tau (n.u), below the horizon. */
static enum pp_status from_below(double *value, const struct task *task,
                                 struct pp_error *err)
{
    const struct pp_sky *sky = task->lights.sky;
    if (pp_sky_has_azimuth(sky))
        return by_quadrature(value, task, BELOW, pp_pane_luminance_horizon, NULL, err);
    enum pp_status status = transmitted(value, task, BELOW, err);
    *value *= pp_pane_luminance_at_horizon(sky, pp_vec(1.0, 0.0, 0.0));
    return status;
}

/* Records the steps of a patch. */
static enum pp_status add_steps(struct pp_part_steps *terms, const struct task *task,
                                struct patch_figures *figures, struct pp_error *err)
{
    const struct pp_sky *sky = task->lights.sky;
    struct pp_vec3 limits[2];
    int count = limits_of(limits, task, ABOVE);
    figures->hidden = task->patch->hidden;
    figures->closed_form = pp_solid_angle_has_closed_form(sky);
    figures->glazed = !is_unglazed(task);
    enum pp_status status =
        pp_direct_moments(&figures->moments, task->visible, task->patch, task->normal,
                          limits, count, err);
    if (status == PP_OK)
        add_patch_steps(terms, figures, sky);
    return status;
}

static enum pp_status add_patch(const struct task *task, double ground_reflectance,
                                struct pp_part_steps *terms, struct pp_error *err)
{
    const struct pp_visible_patch *patch = task->patch;
    struct patch_figures figures = {0};
    double all = 0.0;
    bool faces_up =
        task->normal.x == 0.0 && task->normal.y == 0.0 && task->normal.z > 0.0;
    enum pp_status status = from_sky(&figures.above, task, err);
    if (!patch->hidden) {
        if (status == PP_OK && !faces_up)
            status = transmitted(&figures.below, task, BELOW, err);
        task->sum->sky += figures.above;
        task->sum->external += ground_reflectance / PP_PI * figures.below;
        figures.below /= PP_PI;
        figures.factor = ground_reflectance;
    } else {
        if (status == PP_OK && !faces_up)
            status = from_below(&figures.below, task, err);
        if (status == PP_OK && patch->exitance > 0.0)
            status = transmitted(&all, task, BOTH, err);
        figures.factor =
            pp_visible_luminance_factor(task->lights.sky, patch->reflectance);
        figures.own = patch->exitance / PP_PI * all;
        task->sum->external +=
            figures.factor * (figures.above + figures.below) + figures.own;
    }
    if (status == PP_OK && terms->steps)
        status = add_steps(terms, task, &figures, err);
    return status;
}

enum pp_status pp_direct_add(struct pp_direct *sum, const struct pp_visible *visible,
                             struct pp_vec3 normal, const struct pp_glass *glass,
                             const struct pp_outside_light *light, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    struct pp_part_steps terms = pp_part_steps_begin(sum->steps, visible->patch_count);
    for (int i = 0; i < visible->patch_count && status == PP_OK; i++) {
        struct task task = {sum,
                            visible,
                            &visible->patches[i],
                            normal,
                            {&light->sky, glass, visible->view.toward}};
        status = add_patch(&task, light->ground_reflectance, &terms, err);
    }
    pp_part_steps_end(&terms);
    return status;
}

enum pp_status pp_direct_through(struct pp_direct *sum, const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_opening *opening,
                                 const struct pp_receiver *receiver,
                                 const struct pp_glass *glass, struct pp_error *err)
{
    struct pp_visible visible;
    enum pp_status status =
        pp_visible_in_parts(&visible, world, opening, receiver->position, err);
    if (status != PP_OK)
        return status;
    status = pp_direct_add(sum, &visible, receiver->normal, glass, light, err);
    pp_visible_clear(&visible);
    return status;
}

enum pp_status pp_direct_quadrature(double *value, const struct pp_visible *visible,
                                    const struct pp_visible_patch *patch,
                                    struct pp_vec3 normal,
                                    const struct pp_integrand *integrand,
                                    struct pp_error *err)
{
    struct pp_vec3 limits[PP_HALF_SPACES_MOST];
    int count = join_half_spaces(limits, patch, &normal, 1);
    struct pp_quadrature result = {0};
    enum pp_status status =
        pp_quadrature_over(&result, &visible->view, &patch->region, limits, count,
                           normal, integrand, PP_QUADRATURE_GLAZED, err);
    *value = result.value;
    return status;
}
