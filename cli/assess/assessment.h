/* assessment.h - one room, held against the criteria: what is gathered for it, and what
 * the run has to say of it.
 */
#ifndef PP_CLI_ASSESS_ASSESSMENT_H
#define PP_CLI_ASSESS_ASSESSMENT_H

#include <stdio.h>

#include "cli/rooms.h"
#include "studies/criteria/criteria.h"
#include "studies/sizing/gains.h"

struct pp_assess_options {
    struct pp_room_options room;
    const char *criteria; /* as typed; NULL: all */
    const char *before;   /* the file with the room as it was; NULL: none */
    const char *place;    /* a capital of the standard's table; NULL: the room's site */
    double median_lux;    /* instead; 0: not given */
    const char *weather;  /* or the weather file that it is taken from; NULL: none */
};

/* A criterion that was asked for, and what it found. */
struct pp_answer {
    const struct pp_criterion *criterion;
    struct pp_finding_list findings;
};

struct pp_assessment {
    const struct pp_loaded_room *room;   /* not owned */
    const struct pp_loaded_room *before; /* not owned; NULL */
    int *pairs;
    bool has_factors; /* does any criterion that was asked for judge by them? */
    struct pp_receiver *grid;
    struct pp_report report; /* daylight factors on the grid */
    struct pp_median median;
    struct pp_answer *answers;
    int answer_count;
    bool has_gains; /* was everything asked for, and with it what would help? */
    struct pp_gains gains;
    bool by_clock; /* the simulation was stopped by --time */
};

struct pp_assessments {
    struct pp_assessment *list;
    int count;
    bool several; /* as a list, even if there is only one */
    bool more_than_one_file;
    const struct pp_assess_options *options; /* not owned */
};

/* As text `width` columns wide (60 or more). */
enum pp_status pp_assess_text(const struct pp_assessments *assessments, int width,
                              bool utf8, FILE *out, struct pp_error *err);

/* One object a room ("pepperpot-assess-1"), an array of them if there are several. */
enum pp_status pp_assess_json(const struct pp_assessments *assessments, FILE *out,
                              struct pp_error *err);

/* "met", "not met", "undecided", "not judged"; NULL for what is only stated. */
const char *pp_assess_text_verdict(enum pp_verdict verdict);

#endif
