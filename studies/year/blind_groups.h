/* blind_groups.h - groups of openings whose blinds close together, and the rule for
 * closing them, by LM-83-12. */
#ifndef PP_STUDIES_YEAR_BLIND_GROUPS_H
#define PP_STUDIES_YEAR_BLIND_GROUPS_H

#include "model/base/error.h"
#include "model/room/world.h"

enum { PP_BLIND_GROUPS_MOST = 16 };

/* Diffuse transmittance of a closed blind. */
#define PP_BLIND_GROUPS_TRANSMITTANCE 0.2

struct pp_blind_groups {
    int count;
    int *of_opening;                            /* owned */
    int first[PP_BLIND_GROUPS_MOST];            /* index of one opening of each group */
    double transmittance[PP_BLIND_GROUPS_MOST]; /* of its panes and devices for even
                                                 * light, without LM-83's blinds */
};

/* Openings of one face with the same glass, frame, dirt, curtains and device are a
 * group; from the 16th on, all others are one group. On success the caller clears
 * *groups. */
enum pp_status pp_blind_groups_of_world(struct pp_blind_groups *groups,
                                        const struct pp_world *world,
                                        struct pp_error *err);
void pp_blind_groups_clear(struct pp_blind_groups *groups);

/* True if the group is closed in an hour in which more than 2 % of the points have
 * direct sun of 1000 lx or more through it; sunlit_points: their number. */
bool pp_blind_groups_closes(int sunlit_points, int points);

#endif
