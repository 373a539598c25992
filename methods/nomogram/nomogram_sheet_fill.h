/* nomogram_sheet_fill.h - fills a sheet of a nomogram (model/results/nomogram_sheet.h): its
 * scales with their marks, and what is read on it of a room. */
#ifndef PP_METHODS_NOMOGRAM_NOMOGRAM_SHEET_FILL_H
#define PP_METHODS_NOMOGRAM_NOMOGRAM_SHEET_FILL_H

#include "model/base/error.h"
#include "model/results/nomogram_sheet.h"
#include "model/room/world.h"

/* How high the scales stand, and how near marks and numbered marks may be. */
struct pp_nomogram_spacing {
    double height_mm, fine_mm, number_mm;
};

/* A blank one. On failure, too, the sheet may be cleared. */
enum pp_status pp_nomogram_sheet_fill_blank(struct pp_nomogram_sheet *sheet,
                                            enum pp_nomogram_kind kind,
                                            struct pp_nomogram_spacing spacing,
                                            struct pp_error *err);

/* With the readings of the room's openings: upright ones on I and II, all others on
 * III. The world must outlive the sheet. PP_BAD_INPUT where the sky is not overcast,
 * the mean reflectance is off scale B, or no opening is of that sort. The sum of I is
 * what the method `nomogram` gives. */
enum pp_status pp_nomogram_sheet_fill_room(struct pp_nomogram_sheet *sheet,
                                           enum pp_nomogram_kind kind,
                                           const struct pp_world *world,
                                           struct pp_nomogram_spacing spacing,
                                           struct pp_error *err);

#endif
