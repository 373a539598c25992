/* site_study.h - the rooms of a site and all objects around them, in the building's
 * axes, with the vertical sky component of each vertical window, now and before. */
#ifndef PP_STUDIES_SITE_SITE_STUDY_H
#define PP_STUDIES_SITE_SITE_STUDY_H

#include "model/base/error.h"
#include "model/results/sheets/site_sheet.h"
#include "studies/study_room.h"

/* Rooms of one file, 1 or more, each with its former state (NULL: it did not exist, or
 * is unknown). */
struct pp_site_rooms {
    const struct pp_study_room *list;
    const struct pp_study_room *const *before;
    int count;
    double french_m; /* as for pp_vertical_sky_at_point (vertical_sky.h); 0: none */
};

/* Fills sheet, which the caller clears; empty on failure. Objects outside are taken
 * from the first room, and from the first room that existed before. Windows of rooms
 * one above the other, in one wall's plane, are counted as storeys from below. */
enum pp_status pp_site_study_make(struct pp_site_sheet *sheet,
                                  const struct pp_site_rooms *rooms,
                                  struct pp_error *err);

#endif
