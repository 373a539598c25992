/* atlas_drawn.h - a room of the sweep as designed, with the results of every hand
 * method, but without simulation. */
#ifndef PP_STUDIES_RESEARCH_ATLAS_ATLAS_DRAWN_H
#define PP_STUDIES_RESEARCH_ATLAS_ATLAS_DRAWN_H

#include "model/results/report.h"
#include "studies/research/atlas/atlas_design.h"
#include "studies/study_options.h"
#include "studies/study_room.h"

/* Settings for tracing the rooms. */
struct pp_atlas_trace {
    double error; /* target standard error relative to the daylight factor, at every
                   * point */
    uint64_t seed;
};

struct pp_atlas_drawn {
    struct pp_building *building;
    struct pp_study_room room;
    struct pp_study_options options; /* options for one thread, with the room's own
                                      * seed */
    struct pp_report report;         /* report with the results of all methods */
};

/* Makes room `index` of the sweep and its report. The caller must clear *drawn, even
 * after a failure. PP_BAD_INPUT if the room is invalid, which is a bug in
 * atlas_design.c. */
enum pp_status pp_atlas_drawn_room(struct pp_atlas_drawn *drawn,
                                   const struct pp_atlas_design *design, int index,
                                   const struct pp_atlas_trace *trace,
                                   struct pp_error *err);
void pp_atlas_drawn_clear(struct pp_atlas_drawn *drawn);

#endif
