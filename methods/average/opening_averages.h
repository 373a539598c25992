/* opening_averages.h - the averages over the working plane that a method has for itself
 * (pp_method.average), of all openings of a room. */
#ifndef PP_METHODS_AVERAGE_OPENING_AVERAGES_H
#define PP_METHODS_AVERAGE_OPENING_AVERAGES_H

#include "methods/method.h"
#include "model/base/thread_pool.h"

/* parts[i], zero before, is that of opening i of the beams' world, before the corrections for
 * glass, frame and dirt. *known is false where the method has none for one of them; the
 * parts are then not valid. The pool's workers share the openings. */
enum pp_status pp_opening_averages(struct pp_part *parts, bool *known,
                                   const struct pp_method *method,
                                   struct pp_beams *beams,
                                   const struct pp_outside_light *light,
                                   const void *tools, struct pp_thread_pool *pool,
                                   struct pp_error *err);

#endif
