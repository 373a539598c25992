/* plane_margin.h - the mean over the working plane inside 0.5 m of its edge, as grids of
 * standards have it: without the bright strip along the windows and the dim ones in
 * corners.
 *
 * It is what methods and simulation say of the same room with a smaller plane:
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

/* The room with the smaller plane, and no points. */
struct pp_plane_margin {
    struct pp_world world; /* the room's, but for its plane */
    struct pp_study_room room;
    bool has_plane; /* something is left of it */
};

enum pp_status pp_plane_margin_init(struct pp_plane_margin *margin,
                                    const struct pp_study_room *room,
                                    struct pp_error *err);
void pp_plane_margin_clear(struct pp_plane_margin *margin);

/* Gives the report's columns the averages that `inside`, a report of the same columns on
 * the margin's room, has of its plane; NULL: there is none. A formula that speaks of the
 * plane as a whole has none either. */
enum pp_status pp_plane_margin_take(struct pp_report *report,
                                    const struct pp_report *inside,
                                    struct pp_error *err);

#endif
