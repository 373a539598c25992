/* compare_subject.c - see compare_subject.h. */
#include "studies/research/compare/compare_subject.h"

#include "studies/research/compare/variant_scene.h"
#include "studies/research/compare/variant_values.h"

struct pp_compare_subject pp_compare_subject_of_room(const struct pp_study_room *room)
{
    return (struct pp_compare_subject){.file = room->file,
                                       .name = room->world->name,
                                       .points = room->receivers,
                                       .count = room->receiver_count,
                                       .room = room};
}

enum pp_status pp_compare_subject_values(double *values, double *errors,
                                         const struct pp_compare_subject *subject,
                                         const struct pp_room_variant *variant,
                                         const struct pp_variant_tracing *tracing,
                                         struct pp_error *err)
{
    return subject->room
               ? pp_variant_values(values, errors, subject->room, variant, tracing, err)
               : pp_variant_scene_values(values, errors, subject->scene,
                                         subject->points, subject->count, variant,
                                         tracing, err);
}
