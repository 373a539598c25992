/* variant_values.h - simulated daylight factors of a variant of a room.
 *
 * A variant is a changed copy of the room's description, its light or its points. The
 * path tracer simulates the variant. If the number of reflections is limited, the
 * sensors of simulate/transport are used instead, since they can end paths at the
 * limit.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_VARIANT_VALUES_H
#define PP_STUDIES_RESEARCH_COMPARE_VARIANT_VALUES_H

#include "studies/research/compare/room_variant.h"
#include "studies/study_room.h"

/* Values at the room's receivers, fractions, with their standard errors: values[i] and
 * errors[i]. PP_BAD_INPUT if a switch is not possible in this room, PP_INTERRUPTED if
 * `look` returns false. */
enum pp_status pp_variant_values(double *values, double *errors,
                                 const struct pp_study_room *room,
                                 const struct pp_room_variant *variant,
                                 const struct pp_variant_tracing *tracing,
                                 struct pp_error *err);

#endif
