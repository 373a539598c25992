/* irc_minimum.h - the published table of the minimum internally reflected component in
 * side-lit rooms, with its factors [BRE310].
 *
 * Interpolation between printed figures is linear; for the floor area it is linear in
 * the square root, in which 10, 40 and 90 m2 are equal steps. There is no extrapolation
 * (pp_irc_minimum_lacks), except to smaller glass areas than printed: the minimum is
 * then proportional to the glass area. tables/irc_minimum.csv states the conditions.
 */
#ifndef PP_METHODS_REFLECTED_IRC_MINIMUM_H
#define PP_METHODS_REFLECTED_IRC_MINIMUM_H

/* The arguments of the table. Areas in m2, reflectances 0 to 1. */
struct pp_irc_minimum_entry {
    double glass_m2; /* net area of all openings */
    double floor_m2;
    double floor, walls, ceiling; /* mean reflectances */
};

/* The table's minimum, a fraction, and the factors for the room's floor and ceiling. */
struct pp_irc_minimum {
    double printed; /* for 40 m2, a ceiling of 0.7, an obstruction of 20 degrees */
    double floor_factor, ceiling_factor;
};

/* Reason why the room is outside the printed ranges, as a static sentence; NULL if it
 * is inside. */
const char *pp_irc_minimum_lacks(const struct pp_irc_minimum_entry *entry);

struct pp_irc_minimum pp_irc_minimum_read(const struct pp_irc_minimum_entry *entry);

/* Ratio of average to minimum of a room, 1.8 to 1.2, for this mean reflectance of the
 * walls. Below 0.2 and above 0.8 it is the ratio at that end. */
double pp_irc_minimum_average_ratio(double walls);

#endif
