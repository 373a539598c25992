/* compare_subject.h - the points at which another program's values are compared with
 * ours, in a room or in an imported scene. */
#ifndef PP_STUDIES_RESEARCH_COMPARE_COMPARE_SUBJECT_H
#define PP_STUDIES_RESEARCH_COMPARE_COMPARE_SUBJECT_H

#include "model/light/scene_description.h"
#include "studies/research/compare/room_variant.h"
#include "studies/study_room.h"

struct pp_compare_subject {  /* owns nothing */
    const char *file, *name; /* name: NULL if it has none */
    const struct pp_receiver *points;
    int count;
    const struct pp_study_room *room;         /* NULL: a scene */
    const struct pp_scene_description *scene; /* NULL: a room */
};

/* The subject of a room, at the room's receivers. */
struct pp_compare_subject pp_compare_subject_of_room(const struct pp_study_room *room);

/* Simulates our values (fractions) at the subject's points, with the switches of a
 * variant, and their standard errors. PP_BAD_INPUT if a switch is not possible for the
 * subject; PP_INTERRUPTED if `look` returns false. */
enum pp_status pp_compare_subject_values(double *values, double *errors,
                                         const struct pp_compare_subject *subject,
                                         const struct pp_room_variant *variant,
                                         const struct pp_variant_tracing *tracing,
                                         struct pp_error *err);

#endif
