/* protractor_sheet_fill.h - fills a sheet of a protractor
 * (model/results/protractor_sheet.h): its scales, and the readings of an opening. */
#ifndef PP_METHODS_PROTRACTOR_PROTRACTOR_SHEET_FILL_H
#define PP_METHODS_PROTRACTOR_PROTRACTOR_SHEET_FILL_H

#include "methods/protractor/protractor_scale.h"
#include "model/light/outside_light.h"
#include "model/results/protractor_sheet.h"

/* The least angles between marks and between labelled marks of the primary scale. */
struct pp_mark_spacing {
    double fine_rad, label_rad;
};

/* Makes a sheet of a protractor, without readings, for a slope from 0 to pi/2 (not
 * checked). PP_BAD_INPUT for diffusing glass, and for a sky whose luminance depends on
 * azimuth. glass_words names the glass ("clear single glass"). The sheet can be cleared
 * even after a failure. */
enum pp_status pp_protractor_sheet_fill_blank(struct pp_protractor_sheet *sheet,
                                              const struct pp_protractor *protractor,
                                              const char *glass_words,
                                              struct pp_mark_spacing spacing,
                                              struct pp_error *err);

/* Makes a sheet of the protractor and its readings for the opening with the largest
 * direct component at the receiver, before the corrections for glass, frame and dirt.
 * The world must outlive the sheet. PP_BAD_INPUT if the method `protractor` does not
 * cover the room or one of its openings, or if no light from outside above the horizon
 * reaches the receiver through any opening. */
enum pp_status pp_protractor_sheet_fill_room(struct pp_protractor_sheet *sheet,
                                             const struct pp_world *world,
                                             const struct pp_outside_light *light,
                                             const struct pp_receiver *receiver,
                                             struct pp_mark_spacing spacing,
                                             struct pp_error *err);

#endif
