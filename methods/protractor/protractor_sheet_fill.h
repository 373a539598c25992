/* protractor_sheet_fill.h - what is drawn of a protractor, by itself or on a room. */
#ifndef PP_METHODS_PROTRACTOR_PROTRACTOR_SHEET_FILL_H
#define PP_METHODS_PROTRACTOR_PROTRACTOR_SHEET_FILL_H

#include "methods/protractor/protractor_scale.h"
#include "model/results/protractor_sheet.h"

/* How near marks and labelled marks of the primary scale may stand, radians. */
struct pp_mark_spacing {
    double fine_rad, label_rad;
};

/* Any glass but a diffusing one, slopes from 0 to pi/2, skies without azimuth; else
 * PP_BAD_INPUT. glass_words names the glass ("clear single glass"). On failure, too,
 * the sheet may be cleared. */
enum pp_status pp_protractor_sheet_fill_blank(struct pp_protractor_sheet *sheet,
                                              const struct pp_protractor *protractor,
                                              const char *glass_words,
                                              struct pp_mark_spacing spacing,
                                              struct pp_error *err);

/* The protractor as it is laid on the world, which must outlive the sheet, to read the
 * opening that gives the receiver the most. PP_BAD_INPUT where there is none, or where
 * no protractor is made for it. */
enum pp_status pp_protractor_sheet_fill_room(struct pp_protractor_sheet *sheet,
                                             const struct pp_world *world,
                                             const struct pp_receiver *receiver,
                                             struct pp_mark_spacing spacing,
                                             struct pp_error *err);

#endif
