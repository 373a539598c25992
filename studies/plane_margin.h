/* plane_margin.h - the mean over the working plane inside 0.5 m of its edge, as in
 * grids of standards: without the bright strip along the windows and the dim ones in
 * corners.
 *
 * It is the average by methods and simulation in the same room with a smaller plane:
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

/* The room with the smaller plane, without points. */
struct pp_plane_margin {
    struct pp_world world; /* as the room's, except for its plane */
    struct pp_study_room room;
    bool has_plane; /* false: the margin leaves nothing of the plane */
};

enum pp_status pp_plane_margin_init(struct pp_plane_margin *margin,
                                    const struct pp_study_room *room,
                                    struct pp_error *err);
void pp_plane_margin_clear(struct pp_plane_margin *margin);

/* Copies the averages of `inside`, a report with the same columns for the margin's room
 * (NULL: there is none), to the report's columns. A column by a formula for the whole
 * plane gets none. */
enum pp_status pp_plane_margin_take(struct pp_report *report,
                                    const struct pp_report *inside,
                                    struct pp_error *err);

#endif
