/* blind_groups.h - groups of openings whose blinds close together, and the rule for
 * closing them, by LM-83-12. */
#ifndef PP_STUDIES_YEAR_BLIND_GROUPS_H
#define PP_STUDIES_YEAR_BLIND_GROUPS_H

#include "model/base/error.h"
#include "model/room/world.h"

enum { PP_BLIND_GROUPS_MOST = 16 };

/* Diffuse transmittance of a closed blind. */
#define PP_BLIND_GROUPS_TRANSMITTANCE 0.2

/* Openings of one kind are in one face and have the same glass, frame, dirt, curtains and
 * device. If there are too many kinds, openings that do not scatter light by direction are
 * grouped with less detail. */
enum pp_blind_grouping {
    PP_BLIND_GROUPS_BY_KIND,
    PP_BLIND_GROUPS_BY_FACE,   /* openings of one face form a group */
    PP_BLIND_GROUPS_ALL_PLAIN, /* openings of all faces form one group */
};

struct pp_blind_groups {
    int count;
    enum pp_blind_grouping grouping;
    int *of_opening;                            /* group of each opening; owned */
    int first[PP_BLIND_GROUPS_MOST];            /* index of one opening of each group */
    double transmittance[PP_BLIND_GROUPS_MOST]; /* area-weighted mean transmittance of
                                                 * panes and devices for uniform light,
                                                 * without the blinds of LM-83 */
};

/* On success the caller clears *groups. PP_BAD_INPUT if there are too many kinds of
 * openings that scatter light by direction. */
enum pp_status pp_blind_groups_of_world(struct pp_blind_groups *groups,
                                        const struct pp_world *world,
                                        struct pp_error *err);
void pp_blind_groups_clear(struct pp_blind_groups *groups);

/* True if the group is closed in an hour: if more than 2 % of the plane has direct sun
 * of 1000 lx or more through it. sunlit: sum of the weights of such points (1 for equal
 * areas); whole: of all points.
 *
 * LM-83-12 words it as 2 % of the analysis points, and sDA and ASE as shares of the
 * points as well. Its points form a regular grid, so that each represents the same
 * area. Where they do not, all three are shares of the area. */
bool pp_blind_groups_closes(double sunlit, double whole);

#endif
