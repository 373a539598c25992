/* en17037.c - daylight provision as recommended by [EN17037], by its first method (the
 * daylight factor), and by its UK national annex for dwellings.
 *
 * An illuminance is reached over half of the year's daylight hours where the daylight
 * factor is at least
 *
 *   D = E / E_v,d,med
 *
 * E_v,d,med is the site's median diffuse illuminance (capitals.h). Illuminances to be
 * reached over a fraction of the reference plane:
 *
 *   windows (table A.1)       minimum 300 lx over 50 % and 100 lx over 95 %,
 *                             medium 500 and 300 lx, high 750 and 500 lx
 *   rooflights (table A.2)    300, 500, 750 lx over 95 %
 *   UK annex (table NA.1)     100 lx bedrooms, 150 lx living rooms, 200 lx kitchens,
 *                             each over 50 %
 *
 * The reference plane is the room's working plane less 0.5 m along the walls, on a grid
 * (plane_grid.h) that the standard permits, or on a finer one. The sky is the CIE
 * overcast sky (type 16 or 1). A room all of whose glass is within 15 degrees of level
 * has rooflights; every other room has windows.
 */
#include <math.h>
#include <stdio.h>

#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/en17037/en17037_level.h"
#include "studies/criteria/factors.h"
#include "studies/criteria/grid/share_finding.h"

/* An illuminance to be reached over a part of the plane. */
struct target {
    const char *who; /* the level or the kind of room: "minimum", "bedroom" */
    double lux;
    double part; /* part of the plane, a fraction */
    int level;   /* level of the standard, from 1; 0: not part of a level */
};

/* Adds the finding on one target, from the daylight factors in `column`; not assessed
 * if there is a reason `why`. */
static enum pp_status add_target(const struct pp_inquiry *inquiry,
                                 const struct target *target,
                                 const struct pp_column *column, const char *why,
                                 struct pp_finding_list *findings, struct pp_error *err)
{
    char what[80];
    snprintf(what, sizeof what, "%s: %g lx over %g %%", target->who, target->lux,
             100.0 * target->part);
    struct pp_finding finding = pp_finding_not_judged(why ? why : "", "%s", what);
    if (!why) {
        const struct pp_share_target wanted = {
            PP_FIGURE_FACTOR, target->lux / inquiry->median.lux, target->part};
        enum pp_status status = pp_share_finding(
            &finding, &wanted, column, inquiry->factors->receivers,
            inquiry->factors->receiver_count, inquiry->grid, what, err);
        if (status != PP_OK)
            return status;
    }
    finding.level = target->level;
    finding.is_optional = target->level > PP_EN17037_MINIMUM;
    return pp_finding_list_add(findings, &finding, err);
}

/* Daylight factors of the grid; adds their basis to the findings. NULL if there are
 * none, with the reason in *why. */
static const struct pp_column *grid_factors(const struct pp_inquiry *inquiry,
                                            struct pp_finding_list *findings,
                                            const char **why)
{
    /* The sky is checked first: no option of the command changes the sky, but a missing
     * median can be given as an option. */
    *why = pp_factors_refuse(inquiry);
    if (!*why && isnan(inquiry->median.lux))
        *why = inquiry->median.how;
    if (*why)
        return NULL;
    const struct pp_column *column = pp_factors_of_grid(inquiry, findings, why);
    char grid[PP_PLANE_GRID_WORDS];
    if (inquiry->grid)
        pp_plane_grid_words(grid, inquiry->grid);
    else
        snprintf(grid, sizeof grid, "%d points", inquiry->factors->receiver_count);
    if (column)
        pp_finding_list_add_basis(
            findings, ", on %s; median external diffuse illuminance %.0f lx: %s", grid,
            inquiry->median.lux, inquiry->median.how);
    return column;
}

static enum pp_status assess_en17037(const struct pp_inquiry *inquiry,
                                     struct pp_finding_list *findings,
                                     struct pp_error *err)
{
    bool rooflights = pp_en17037_level_of_rooflights(inquiry->world);
    double half = pp_en17037_level_half, nearly_all = pp_en17037_level_nearly_all;
    const char *why;
    const struct pp_column *column = grid_factors(inquiry, findings, &why);
    for (int level = 1; level <= PP_EN17037_HIGH; level++) {
        const char *name = pp_en17037_level_names[level];
        struct target target = {name, pp_en17037_level_target_lx[level],
                                rooflights ? nearly_all : half, level};
        struct target least = {name, pp_en17037_level_minimum_lx[level], nearly_all,
                               level};
        enum pp_status status =
            add_target(inquiry, &target, column, why, findings, err);
        if (status == PP_OK && !rooflights)
            status = add_target(inquiry, &least, column, why, findings, err);
        if (status != PP_OK)
            return status;
    }
    char reached[PP_EN17037_LEVEL_WORDS];
    pp_en17037_level_words(reached, findings);
    if (column)
        pp_finding_list_add_basis(findings, "; level reached: %s", reached);
    return PP_OK;
}

static enum pp_status evaluate_annex(const struct pp_inquiry *inquiry,
                                     struct pp_finding_list *findings,
                                     struct pp_error *err)
{
    static const struct target targets[] = {{"bedroom", 100, 0.5, PP_EN17037_NONE},
                                            {"living room", 150, 0.5, PP_EN17037_NONE},
                                            {"kitchen", 200, 0.5, PP_EN17037_NONE}};
    static const enum pp_dwelling_room kinds[] = {
        PP_DWELLING_BEDROOM, PP_DWELLING_LIVING_ROOM, PP_DWELLING_KITCHEN};
    int rooms = pp_bearing_dwelling_rooms(inquiry->world->use);
    const char *why;
    const struct pp_column *column = grid_factors(inquiry, findings, &why);
    enum pp_status status = PP_OK;
    for (int i = 0; i < 3 && status == PP_OK; i++)
        if (!rooms || rooms & kinds[i])
            status = add_target(inquiry, &targets[i], column, why, findings, err);
    return status;
}

const struct pp_criterion pp_criterion_en17037 = {
    .name = "en17037",
    .title = "EN 17037 daylight provision",
    .source = "EN17037",
    .summary = "300, 500, 750 lx over half of the plane and 100, 300, 500 lx over 95 %",
    .of_factors = true,
    .bears_on_use = pp_bearing_needs_daylight,
    .evaluate = assess_en17037,
};

const struct pp_criterion pp_criterion_uk_annex = {
    .name = "uk-annex",
    .title = "EN 17037, UK annex for dwellings",
    .source = "BSEN17037",
    .summary =
        "100, 150, 200 lx over half of the plane in bedrooms, living rooms, kitchens",
    .of_factors = true,
    .bears_on_use = pp_bearing_is_dwelling,
    .countries = "GB",
    .evaluate = evaluate_annex,
};
