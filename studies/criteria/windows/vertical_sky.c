/* vertical_sky.c - the sky that a window faces: the vertical sky component, the 0.8
 * rule and the 25 degree rule of [BR209].
 *
 *   VSC >= 27 %                              on the outside, at the window's middle
 *   VSC >= 27 %  or  VSC >= 0.8 VSC before
 *   theta <= 25 degrees                      obstruction angle in front of the window
 *
 * The vertical sky component VSC is the illuminance of the wall's plane from the sky
 * alone over that of a horizontal plane under the open CIE overcast sky, whatever the
 * room's own sky; without obstructions it is 39.6 %. An endless obstruction of 25
 * degrees leaves 27.3 %. A window that meets the 25 degree rule therefore also meets
 * VSC >= 27 %; where the angle is larger, the vertical sky component decides.
 */
#include "studies/criteria/windows/vertical_sky.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/windows/opening_words.h"
#include "studies/criteria/section_angle.h"
#include "methods/exact/exterior.h"

#define VSC_WANTED 0.27
#define FORMER_SHARE_WANTED 0.8
#define FRENCH_FOOT_M 0.2
#define NO_SKY 1e-6 /* with less, a window counts as seeing no sky, and has no ratio */
#define ANGLE_WANTED (25.0 * PP_RAD)

static const char none[] = "the room has no openings";
static const char slopes[] =
    "the opening is not vertical; the rule is for windows in walls";

bool pp_vertical_sky_is_upright(const struct pp_opening *opening)
{
    return fabs(opening->slope_rad - PP_PI / 2.0) < 1.0 * PP_RAD;
}

/* True if the window is assessed at the height french_m: it extends from near the floor
 * to above that height. */
static bool is_french(const struct pp_opening *opening, double french_m)
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < opening->inner.count; i++) {
        low = fmin(low, opening->inner.vertices[i].z);
        high = fmax(high, opening->inner.vertices[i].z);
    }
    return french_m > 0.0 && low <= FRENCH_FOOT_M && high > french_m;
}

struct pp_vec3 pp_vertical_sky_point(const struct pp_opening *opening, double french_m)
{
    struct pp_vec3 point = pp_exterior_opening_centroid(opening);
    if (is_french(opening, french_m))
        point.z = french_m;
    return point;
}

enum pp_status pp_vertical_sky_at_point(double *share, const struct pp_world *world,
                                        const struct pp_opening *opening,
                                        double french_m, struct pp_error *err)
{
    const struct pp_outside_light light = {.sky = pp_sky_overcast()}; /* no ground */
    const struct pp_vec3 out = pp_vec_scale(opening->inner.normal, -1.0);
    struct pp_exterior_light outside;
    if (!is_french(opening, french_m))
        return pp_exterior_sky_on_plane(share, world, opening, out, &light.sky, err);
    enum pp_status status = pp_exterior_light_on_plane(
        &outside, world, &light, pp_vertical_sky_point(opening, french_m), out,
        opening->face, err);
    if (status == PP_OK)
        *share = outside.sky;
    return status;
}

/* Gives `bare` its own lists of surfaces and meshes, without the shades of the windows.
 * Among the surfaces, shades follow the sides of the blocks and precede the triangles
 * of the meshes. The caller frees both lists. */
static bool take_shades_off(struct pp_world *bare, const struct pp_world *world)
{
    bare->surfaces = calloc((size_t)world->surface_count + 1, sizeof *bare->surfaces);
    bare->meshes = calloc((size_t)world->mesh_count + 1, sizeof *bare->meshes);
    bare->surface_count = 0;
    if (!bare->surfaces || !bare->meshes)
        return false;
    for (int i = 0; i < world->surface_count; i++)
        if (!world->surfaces[i].is_shade)
            bare->surfaces[bare->surface_count++] = world->surfaces[i];
    for (int i = 0; i < world->mesh_count; i++) {
        bare->meshes[i] = world->meshes[i];
        bare->meshes[i].first_side -= world->surface_count - bare->surface_count;
    }
    return true;
}

/* Vertical sky component without the overhangs, fins, balconies and shelves of the
 * room's own windows and of other rooms in the same front. Such shades hide sky
 * whatever is opposite; [BR209] requires both values to be stated (from memory). NAN:
 * there are no shades. */
static enum pp_status find_unshaded(double *share, const struct pp_world *world,
                                    const struct pp_opening *opening, double french_m,
                                    struct pp_error *err)
{
    struct pp_world bare = *world;
    *share = NAN;
    enum pp_status status = take_shades_off(&bare, world) ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK && bare.surface_count < world->surface_count)
        status = pp_vertical_sky_at_point(share, &bare, opening, french_m, err);
    free(bare.surfaces);
    free(bare.meshes);
    return status;
}

static const char without[] =
    "without the overhangs and balconies of the window's own building";

/* Least difference of two vertical sky components (fractions) that is worth a note:
 * half a unit of the last printed digit. */
#define SHARE_STATED 0.0005

/* Adds a finding for each opening: made by `find` for vertical openings, not assessed
 * for all others. */
static enum pp_status for_each_window(
    const struct pp_inquiry *inquiry, struct pp_finding_list *findings,
    enum pp_status (*find)(struct pp_finding *, const struct pp_inquiry *, int opening,
                           const char *what, struct pp_error *),
    struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    if (world->opening_count == 0) {
        struct pp_finding finding = pp_finding_not_judged(none, "windows");
        return pp_finding_list_add(findings, &finding, err);
    }
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        char words[PP_OPENING_WORDS];
        pp_opening_words(words, world, opening);
        struct pp_finding finding = pp_finding_not_judged(slopes, "%s", words);
        enum pp_status status = PP_OK;
        if (pp_vertical_sky_is_upright(opening))
            status = find(&finding, inquiry, i, words, err);
        finding.line = opening->line;
        if (status == PP_OK)
            status = pp_finding_list_add(findings, &finding, err);
        if (status != PP_OK)
            return status;
    }
    return PP_OK;
}

static enum pp_status find_component(struct pp_finding *finding,
                                     const struct pp_inquiry *inquiry, int opening,
                                     const char *what, struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    double share, bare;
    enum pp_status status = pp_vertical_sky_at_point(
        &share, world, &world->openings[opening], inquiry->french_m, err);
    if (status == PP_OK)
        status = find_unshaded(&bare, world, &world->openings[opening],
                               inquiry->french_m, err);
    if (status != PP_OK)
        return status;
    *finding = pp_finding_of(PP_FIGURE_FACTOR, share, VSC_WANTED, false, "%s", what);
    pp_finding_compares(finding, PP_FIGURE_FACTOR, share, NAN);
    finding->now_unshaded = bare;
    if (fabs(bare - share) >= SHARE_STATED)
        pp_finding_note(finding, "%.1f %% %s", 100.0 * bare, without);
    return PP_OK;
}

static enum pp_status evaluate_component(const struct pp_inquiry *inquiry,
                                         struct pp_finding_list *findings,
                                         struct pp_error *err)
{
    return for_each_window(inquiry, findings, find_component, err);
}

static enum pp_status find_loss(struct pp_finding *finding,
                                const struct pp_inquiry *inquiry, int opening,
                                const char *what, struct pp_error *err)
{
    const struct pp_opening *of_now = &inquiry->world->openings[opening];
    const struct pp_opening *of_then =
        &inquiry->before->openings[inquiry->pairs[opening]];
    const double french_m = inquiry->french_m;
    double now, then, bare_now, bare_then;
    enum pp_status status =
        pp_vertical_sky_at_point(&now, inquiry->world, of_now, french_m, err);
    if (status == PP_OK)
        status =
            pp_vertical_sky_at_point(&then, inquiry->before, of_then, french_m, err);
    if (status == PP_OK)
        status = find_unshaded(&bare_now, inquiry->world, of_now, french_m, err);
    if (status == PP_OK)
        status = find_unshaded(&bare_then, inquiry->before, of_then, french_m, err);
    if (status != PP_OK)
        return status;
    if (!(then > NO_SKY)) {
        *finding = pp_finding_not_judged("the window had no view of the sky before",
                                         "%s", what);
        pp_finding_compares(finding, PP_FIGURE_FACTOR, now, then);
        return PP_OK;
    }
    *finding = pp_finding_of(PP_FIGURE_RATIO, now / then, FORMER_SHARE_WANTED, false,
                             "%s", what);
    pp_finding_compares(finding, PP_FIGURE_FACTOR, now, then);
    pp_finding_note(finding, "%.1f %% now, %.1f %% before", 100.0 * now, 100.0 * then);
    if (finding->verdict == PP_NOT_MET && now >= VSC_WANTED) {
        finding->verdict = PP_MET;
        pp_finding_note(finding,
                        "; the vertical sky component is still at least 27 %%");
    }
    finding->now_unshaded = bare_now;
    finding->before_unshaded = bare_then;
    if (bare_now / bare_then > 0.0
        && (fabs(bare_now - now) >= SHARE_STATED
            || fabs(bare_then - then) >= SHARE_STATED))
        pp_finding_note(finding, "; ratio %.3f %s (%.1f %% now, %.1f %% before)",
                        bare_now / bare_then, without, 100.0 * bare_now,
                        100.0 * bare_then);
    return PP_OK;
}

static enum pp_status evaluate_loss(const struct pp_inquiry *inquiry,
                                    struct pp_finding_list *findings,
                                    struct pp_error *err)
{
    return for_each_window(inquiry, findings, find_loss, err);
}

static enum pp_status find_angle(struct pp_finding *finding,
                                 const struct pp_inquiry *inquiry, int opening,
                                 const char *what, struct pp_error *err)
{
    (void)err;
    double angle =
        pp_section_angle(inquiry->world, &inquiry->world->openings[opening], true);
    *finding = pp_finding_of(PP_FIGURE_ANGLE, angle, ANGLE_WANTED, true, "%s", what);
    if (finding->verdict == PP_NOT_MET) {
        finding->verdict = PP_STATED;
        finding->decided_by = pp_criterion_vertical_sky.name;
        pp_finding_note(finding,
                        "only a first check; the vertical sky component decides");
    }
    return PP_OK;
}

static enum pp_status evaluate_angle(const struct pp_inquiry *inquiry,
                                     struct pp_finding_list *findings,
                                     struct pp_error *err)
{
    return for_each_window(inquiry, findings, find_angle, err);
}

const struct pp_criterion pp_criterion_vertical_sky = {
    .name = "vertical-sky",
    .alias = "vsc",
    .title = "Vertical sky component",
    .source = "BR209",
    .summary = "at least 27 % at the centre of the outer face of each window",
    .bears_on_use = pp_bearing_needs_daylight,
    .of_states = true,
    .without_trees = true,
    .evaluate = evaluate_component,
};

const struct pp_criterion pp_criterion_former_sky = {
    .name = "former-sky",
    .title = "0.8 of the former vertical sky component",
    .source = "BR209",
    .summary = "at least 27 %, or 0.8 of the former value, at each window (--before)",
    .needs_before = true,
    .bears_on_use = pp_bearing_needs_daylight,
    .of_states = true,
    .without_trees = true,
    .evaluate = evaluate_loss,
};

const struct pp_criterion pp_criterion_obstruction = {
    .name = "obstruction",
    .title = "25 degree rule",
    .source = "BR209",
    .summary = "no obstruction above 25 degrees in section, seen from the centre of "
               "each window",
    .bears_on_use = pp_bearing_needs_daylight,
    .without_trees = true,
    .evaluate = evaluate_angle,
};
