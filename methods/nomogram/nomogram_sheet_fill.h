/* nomogram_sheet_fill.h - fills a sheet of a nomogram (model/results/nomogram_sheet.h):
 * the scales with their marks, and the readings of a room. */
#ifndef PP_METHODS_NOMOGRAM_NOMOGRAM_SHEET_FILL_H
#define PP_METHODS_NOMOGRAM_NOMOGRAM_SHEET_FILL_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/results/nomogram_sheet.h"
#include "model/room/world.h"

/* Height and width of the scales, and the least distances between marks and between
 * numbered marks. */
struct pp_nomogram_spacing {
    double height_mm, width_mm, fine_mm, number_mm;
};

/* Makes a sheet without readings. The sheet can be cleared even after a failure. */
enum pp_status pp_nomogram_sheet_fill_blank(struct pp_nomogram_sheet *sheet,
                                            enum pp_nomogram_kind kind,
                                            struct pp_nomogram_spacing spacing,
                                            struct pp_error *err);

/* Fills the sheet with readings for the room's openings: vertical ones on I, II and IV,
 * all others on III. receiver: the point for nomogram IV; unused for the others. The
 * world must outlive the sheet. PP_BAD_INPUT if the sky is not overcast, the mean
 * reflectance is outside scale B, the room has no opening for that nomogram, or an
 * opening has a value off its scales. The sum on I is the component by the method
 * `nomogram`. The sums on IV are results of `irc-atlas`, for the room and for the
 * point, as read on the scales, so that each reading is rounded. */
enum pp_status pp_nomogram_sheet_fill_room(struct pp_nomogram_sheet *sheet,
                                           enum pp_nomogram_kind kind,
                                           const struct pp_world *world,
                                           const struct pp_outside_light *light,
                                           const struct pp_receiver *receiver,
                                           struct pp_nomogram_spacing spacing,
                                           struct pp_error *err);

#endif
