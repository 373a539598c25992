/* assessment.h - assessment of one room by the criteria: the daylight factors used, the
 * verdicts, and possible improvements. */
#ifndef PP_STUDIES_CRITERIA_ASSESSMENT_H
#define PP_STUDIES_CRITERIA_ASSESSMENT_H

#include <stdbool.h>

#include "studies/study_options.h"
#include "studies/study_room.h"
#include "studies/criteria/room_before.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/profile.h"
#include "studies/criteria/rules/rule_set.h"
#include "studies/sizing/gains.h"
#include "studies/year/annual.h"

struct pp_assess_options {
    const struct pp_study_options *study; /* not owned */
    const char
        *criteria; /* comma-separated names, evaluated whatever the room's use and
                    * country; NULL: the profile's */
    const struct pp_profile *profile; /* not owned; NULL: all criteria in force */
    const struct pp_rule_set *rules;  /* instead of criteria and profile; the rooms have
                                       * the rules' sky and working plane; not owned;
                                       * NULL: none */
    bool withdrawn;    /* true: if neither criteria nor a profile are given, criteria of
                        * withdrawn standards are also used */
    const char *place; /* a capital of the standard's table; NULL: the room's site */
    double median_lux; /* used instead of the site's; 0: not given */
    double french_m;   /* as in struct pp_inquiry */
    double least_altitude_rad;          /* as in struct pp_inquiry */
    double shortest_h;                  /* as in struct pp_inquiry */
    bool of_weather;                    /* true if median_lux comes from a weather
                                         * file */
    const struct pp_sunshine *sunshine; /* not owned; NULL: not known */
    const struct pp_weather_year *year; /* for criteria of_year; not owned; NULL: no
                                         * weather file */
    bool with_year;                     /* true: simulate `year` even if no criterion
                                         * needs it */
    const struct pp_rooms_before
        *mirrored; /* the rooms of the same files with the mirror
                                 * image outside; not owned; NULL: none */
    const struct pp_rooms_before
        *cumulative;    /* the rooms of files that have a cumulative state, in that
                      * state; not owned; NULL: none */
    bool of_averages;   /* true: the target error of the simulation also applies to the
                         * average over the plane, even if no criterion needs the
                         * average */
    bool verdicts_only; /* true: no search for improvements */
    struct pp_grid_choice grid; /* the grid of the plane; empty: the file's, or the
                                 * default one, halved as often as the verdicts need */
    bool
        trace_again; /* true: pp_assessment_judge may simulate on a finer grid, with the
                      * options `study` */
};

/* A selected criterion, with its findings. */
struct pp_answer {
    const struct pp_criterion *criterion;
    struct pp_finding_list findings;
};

struct pp_answer_list {
    struct pp_answer *list;
    int count;
};

struct pp_assessment {
    const struct pp_study_room *room;   /* not owned */
    const struct pp_study_room *before; /* not owned; NULL */
    int *pairs;
    bool is_new; /* true: the site has several states, and the existing state does not
                  * contain the room */
    const struct pp_study_room *mirrored; /* not owned; NULL */
    int *mirrored_pairs;
    bool has_factors; /* true if any selected criterion uses daylight factors */
    bool has_average; /* true if the target error of the simulation also applies to the
                       * average */
    struct pp_plane_grid grid;
    struct pp_report report; /* daylight factors on the grid */
    struct pp_median median;
    struct pp_answer_list answers;
    const struct pp_study_room *cumulative;   /* not owned; NULL: no such state */
    int *cumulative_pairs;                    /* pairs of openings with `before`; NULL:
                                               * none */
    struct pp_answer_list cumulative_answers; /* findings of criteria of_states for the
                                               * cumulative state in place of the
                                               * proposed one */
    bool has_gains;                           /* true if improvements were searched */
    struct pp_gains gains;
    struct pp_receiver *point_list; /* the rules' points; owned */
    struct pp_report points;        /* daylight factors at point_list */
    struct pp_reading *windows;     /* simulated illuminances of the windows' outsides;
                                     * NULL: not simulated; owned */
    struct pp_plane_grid year_grid; /* grid of the simulated year; no cells if the year
                                     * has the room's own points */
    struct pp_annual_sheet year;    /* if has_year; owned */
    bool has_year;
    struct pp_glare_sheet glare; /* if has_glare; owned */
    bool has_glare;
    bool by_clock; /* true: the simulation was stopped by its time limit */
};

enum { PP_CRITERIA_MOST = 64 };

/* Marks the criteria of a list of names separated by commas (NULL: all); an unknown
 * name is PP_BAD_INPUT. */
enum pp_status pp_assessment_choose(bool chosen[PP_CRITERIA_MOST], const char *list,
                                    struct pp_error *err);

/* Begins the assessment of a room, without verdicts: its grid, the hand methods'
 * daylight factors there, the site's median illuminance, and the room's counterpart in
 * `before` (may be NULL; pp_room_before_find). The grid is fine enough for verdicts by
 * hand methods. For verdicts by simulation, add simulated factors to assessment->report
 * (plane_trace.h) before pp_assessment_judge. The caller clears the assessment, even
 * after a failure. */
enum pp_status pp_assessment_begin(struct pp_assessment *assessment,
                                   const struct pp_study_room *room, int room_count,
                                   const struct pp_rooms_before *before,
                                   const struct pp_assess_options *options,
                                   struct pp_error *err);

/* True if the options select a criterion that needs a simulated year or, if `optional`,
 * that uses one. */
bool pp_assessment_needs_year(const char *criteria, const struct pp_profile *profile,
                              bool optional);

/* Assesses the room from the available data. Searches for improvements (gains) if the
 * options give no criteria, profile or rules, and verdicts_only is false. */
enum pp_status pp_assessment_judge(struct pp_assessment *assessment,
                                   const struct pp_assess_options *options,
                                   struct pp_error *err);
void pp_assessment_clear(struct pp_assessment *assessment);

#endif
