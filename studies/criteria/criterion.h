/* criterion.h - what a room's daylight has to reach, and whether it does.
 *
 * A criterion is one entry in one list (studies/criteria/criteria.c); a file holds one, or a
 * family. It says of the room what it finds: figures, each with what is wanted and with
 * its verdict. Criteria trace nothing: what rests on simulation comes in as readings.
 */
#ifndef PP_STUDIES_CRITERIA_CRITERION_H
#define PP_STUDIES_CRITERIA_CRITERION_H

#include <stdbool.h>

#include "studies/criteria/finding.h"
#include "model/results/report.h"
#include "model/room/world.h"

/* Illuminance outside that a place has over half of its daylight hours. */
struct pp_median {
    double lux;    /* of a level plane, from the sky alone; NAN: not known */
    char how[200]; /* where it comes from ("London, 12 km away"), or why it is not
                    * known, as a sentence without a full stop */
};

/* What criteria are judged by. Nothing in it is owned. */
struct pp_inquiry {
    const struct pp_world *world;
    const struct pp_world *before; /* the same room with other surroundings; NULL: none
                                    * was given */
    const int
        *pairs; /* for each of world's openings that of before; by pp_pair_rooms */

    /* Daylight factors of the standard's grid, which is its receivers
     * (studies/criteria/en17037_grid.h), and of the average over the working plane: columns
     * "traced" where the room was simulated, and those that pp_factors_by_hand adds. */
    const struct pp_report *factors;
    struct pp_median median;
};

struct pp_criterion {
    const char *name;    /* as typed on the command line, and in JSON */
    const char *title;   /* for people */
    const char *source;  /* keys in docs/SOURCES.md, with ", " between */
    const char *summary; /* one line for the help, without a full stop */
    bool needs_before;   /* compares with the room before; else not asked without it */
    bool of_factors;     /* judges by the inquiry's factors; else they may be NULL */

    /* Adds its findings; those it can't judge are among them, with why. Fails where the
     * machine does. */
    enum pp_status (*evaluate)(const struct pp_inquiry *inquiry,
                               struct pp_finding_list *findings, struct pp_error *err);
};

/* All criteria, in the order in which they are shown; NULL at the end. index is at most
 * one past the last. */
const struct pp_criterion *pp_criteria_at(int index);

/* The criterion of that name, or NULL. */
const struct pp_criterion *pp_criteria_find(const char *name);

#endif
