/* plane_margin.h - mean over the working plane without a margin of 0.5 m along its
 * edge, like the grids of standards. The margin includes the bright strip along the
 * windows and the dim corners.
 *
 * The mean is calculated by hand methods and simulation for the same room with a
 * smaller plane:
 *
 *     pp_plane_margin_init(&margin, room, err)
 *     ... a report on margin.room, if that has a plane ...
 *     pp_plane_margin_take(report, &inside, err)
 *     pp_plane_margin_clear(&margin)
 */
#ifndef PP_STUDIES_PLANE_MARGIN_H
#define PP_STUDIES_PLANE_MARGIN_H

#include "model/results/report.h"
#include "studies/study_room.h"

/* A copy of the room with the smaller plane and without points. */
struct pp_plane_margin {
    struct pp_world world; /* like the room's world, except for its plane */
    struct pp_study_room room;
    bool has_plane; /* false: nothing of the plane is left inside the margin */
};

enum pp_status pp_plane_margin_init(struct pp_plane_margin *margin,
                                    const struct pp_study_room *room,
                                    struct pp_error *err);
void pp_plane_margin_clear(struct pp_plane_margin *margin);

/* Copies the averages of `inside` to the columns of `report`. inside: a report on the
 * room with the smaller plane, with the same columns; NULL: there is none. Columns of
 * formulae for the whole plane get no value. */
enum pp_status pp_plane_margin_take(struct pp_report *report,
                                    const struct pp_report *inside,
                                    struct pp_error *err);

#endif
