/* study.h - definition of pepperpot.h's struct pp_study, for use inside api/ only. */
#ifndef PP_API_STUDY_H
#define PP_API_STUDY_H

#include "methods/variant.h"
#include "pepperpot.h"
#include "studies/criteria/assessment.h"
#include "studies/simulation.h"
#include "studies/study_room.h"

struct pp_study {
    struct pp_study_room room;
    char *file;                      /* file name for messages and reports */
    struct pp_room *description;     /* copy of the room in the building, with the sky
                                      * of the study */
    struct pp_study_options options; /* options of the last evaluation */
    struct pp_variant_list
        variants; /* variants of formulae, to which the method options point */
    struct pp_report report;
    struct pp_light_scene *scene;     /* scene of the world; NULL: not yet built */
    struct pp_simulation *simulation; /* the simulation; NULL: none requested */
    struct pp_grid_choice grid;       /* grid of the points; empty if they are not on a
                                       * grid */
    struct pp_assessment assessment;
    bool has_assessment;
    bool has_plan_without_average; /* pp_study_plan leaves out the average */
};

/* Replaces the report by an empty report for the present room and points. */
void pp_study_begin_report(struct pp_study *study);

#endif
