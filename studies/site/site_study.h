/* site_study.h - the rooms of a site and all objects around them, in the axes of the
 * building, with the present and former vertical sky component of each vertical
 * window. */
#ifndef PP_STUDIES_SITE_SITE_STUDY_H
#define PP_STUDIES_SITE_SITE_STUDY_H

#include "model/base/error.h"
#include "model/results/sheets/site_sheet.h"
#include "studies/study_room.h"

/* Rooms of a file (1 or more), each with its former state; NULL entry: the room did not
 * exist, or its former state is unknown. */
struct pp_site_rooms {
    const struct pp_study_room *list;
    const struct pp_study_room *const *before;
    int count;
    double french_m; /* height of the reference point on French windows, m
                      * (vertical_sky.h); 0: none */
};

/* Makes the sheet. The caller clears *sheet, which is empty after a failure. Objects
 * outside are those of the first room, and of its former state if that is known.
 * Windows of rooms one above the other, in the same wall plane, are counted as storeys
 * from the lowest. */
enum pp_status pp_site_study_make(struct pp_site_sheet *sheet,
                                  const struct pp_site_rooms *rooms,
                                  struct pp_error *err);

#endif
