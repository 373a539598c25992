/* criterion.h - a criterion of daylight: a rule that a room meets or does not meet.
 *
 * Each criterion is one entry in one list (studies/criteria/criteria.c); a file
 * contains one criterion, or a family of criteria. A criterion adds findings about the
 * room: figures, each with its bound and a verdict. Criteria do not simulate: they
 * receive simulated daylight factors as readings.
 */
#ifndef PP_STUDIES_CRITERIA_CRITERION_H
#define PP_STUDIES_CRITERIA_CRITERION_H

#include <stdbool.h>

#include "model/light/outside_light.h"
#include "studies/climate/sunshine.h"
#include "studies/criteria/capitals.h"
#include "studies/criteria/finding.h"
#include "studies/criteria/grid/plane_grid.h"
#include "model/results/report.h"
#include "model/results/sheets/annual_sheet.h"
#include "model/results/sheets/glare_sheet.h"
#include "model/room/world.h"

struct pp_rule_set; /* rules/rule_set.h */

/* The room to be assessed, and the data for it. Nothing is owned. */
struct pp_inquiry {
    const struct pp_world *world;
    const struct pp_outside_light *light;
    const struct pp_world *before; /* the same room with its former surroundings; NULL:
                                    * none was given */
    const int *pairs; /* for each opening of `world` its index in `before`, as
                       * pp_pair_rooms finds them */

    const struct pp_world
        *mirrored;             /* the same room with the building's mirror image outside
                                * instead of the proposed parts; NULL: not requested */
    const int *mirrored_pairs; /* like `pairs`, for `mirrored` */

    /* Daylight factors at the points of a grid (plane_grid.h), which are the report's
     * receivers, and averages over the working plane: columns "traced" where the room
     * was simulated, and the columns that pp_factors_by_hand adds. */
    const struct pp_report *factors;
    const struct pp_plane_grid *grid;
    struct pp_median median;            /* median diffuse illuminance outside, at the
                                         * room's site */
    const struct pp_sunshine *sunshine; /* sunshine at the site; NULL: not known */
    double french_m; /* height above the floor at which the vertical sky component of a
                      * full-height window is calculated; 0: at its centre */
    double least_altitude_rad; /* altitude above which the sun counts for EN 17037; 0:
                                * the value of the country's rules, if known */
    double shortest_h; /* times of sun on a day that are shorter do not count, and the
                        * others are listed; 0: not given */
    const struct pp_annual_sheet *year;    /* the room's simulated year; NULL: none */
    const struct pp_plane_grid *year_grid; /* grid of the year's points; NULL: not on a
                                            * grid of the plane */
    const struct pp_rule_set *rules; /* rules to assess; the world already has their sky
                                      * and working plane; NULL: none */
    const struct pp_report *points;  /* daylight factors at the rules' points; NULL: the
                                     * rules have none */
    const struct pp_reading *windows;   /* for each opening the simulated illuminance of
                                       * its outside, over Eh (traced_windows.h); NULL:
                                       * not simulated */
    const struct pp_glare_sheet *glare; /* glare of the room's views in that year; NULL:
                                         * none */
    const char *country; /* ISO 3166 code of the country whose rules apply; "":
                                * unknown */
    int threads;         /* 0: one for each processor */
};

struct pp_criterion {
    const char *name;        /* as typed on the command line, and in JSON */
    const char *alias;       /* usual short name, also accepted; NULL: none */
    const char *title;       /* title in reports */
    const char *source;      /* keys in docs/SOURCES.md, separated by ", " */
    const char *withdrawn;   /* for a rule that is no longer in force: its present
                              * status, as a sentence without a full stop; such a rule
                              * is assessed only on request. NULL: in force */
    const char *summary;     /* one line for the help, without a full stop */
    bool needs_before;       /* true: evaluated only if there is a former state of the
                              * room */
    bool needs_mirror_image; /* true: evaluated only if there is a room with the mirror
                              * image */
    bool of_states;          /* true: assesses sky or sun, which change with the state
                              * of the site */
    bool of_gardens;         /* true: evaluated only for a room with gardens */
    bool of_year;            /* true: uses the inquiry's year; assessed only if named or
                              * in a profile */
    bool of_glare;      /* true: uses the inquiry's glare; assessed only if named or in
                         * a profile */
    bool of_plane_year; /* true: uses the inquiry's year on a grid of the plane, if
                         * there is a weather file */
    bool without_trees; /* true: crowns of trees count as transparent, as BR 209
                        * prescribes for sky and sun */
    bool of_factors;    /* true: uses the inquiry's factors, which may otherwise be
                         * NULL */
    bool (*bears_on_use)(enum pp_room_use use); /* NULL: applies to rooms of any use */
    const char *countries;                      /* codes of the countries in which the
                                                 * criterion applies, "GB IE"; NULL:
                                                 * any */

    /* Adds the criterion's findings, including figures that are not applicable, with
     * the reason. Fails only on errors such as lack of memory. */
    enum pp_status (*evaluate)(const struct pp_inquiry *inquiry,
                               struct pp_finding_list *findings, struct pp_error *err);
};

#endif
