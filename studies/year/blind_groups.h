/* blind_groups.h - openings whose blinds close together, and when they do, by LM-83-12. */
#ifndef PP_STUDIES_YEAR_BLIND_GROUPS_H
#define PP_STUDIES_YEAR_BLIND_GROUPS_H

#include "model/base/error.h"
#include "model/room/world.h"

enum { PP_BLIND_GROUPS_MOST = 16 };

/* Share of the light on a closed blind that it transmits, all of it diffusely. */
#define PP_BLIND_GROUPS_TRANSMITTANCE 0.2

struct pp_blind_groups {
    int count;
    int *of_opening;                 /* owned */
    int first[PP_BLIND_GROUPS_MOST]; /* an opening of each */
    double
        transmittance[PP_BLIND_GROUPS_MOST]; /* diffuse, of its panes without blinds */
};

/* Openings of one face with one glass, frame, dirt and curtains are a group; from the 16th
 * on, all others are one. On success the caller clears *groups. */
enum pp_status pp_blind_groups_of_world(struct pp_blind_groups *groups,
                                        const struct pp_world *world,
                                        struct pp_error *err);
void pp_blind_groups_clear(struct pp_blind_groups *groups);

/* Closes the group in an hour with so many of the points in 1000 lx or more of direct sun
 * by it: more than 2 %? */
bool pp_blind_groups_closes(int sunlit_points, int points);

#endif
