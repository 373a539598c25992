/* irc_minimum.h - the published table of the least internally reflected component in
 * side-lit rooms, with its factors, read between their rows as a careful person does.
 *
 * Between printed figures everything is taken in proportion, but for the size of the
 * floor: that by the side of a square of its area, of which 10, 40 and 90 m2 are even
 * steps. Outside the printed figures the table has nothing to say
 * (pp_irc_minimum_lacks), but for very little glass, for which it goes in proportion to
 * none. Conditions: tables/irc_minimum.csv.
 */
#ifndef PP_METHODS_REFLECTED_IRC_MINIMUM_H
#define PP_METHODS_REFLECTED_IRC_MINIMUM_H

/* What the table is entered with. Areas in m2, reflectances 0 to 1. */
struct pp_irc_minimum_entry {
    double glass_m2; /* net area of all openings */
    double floor_m2;
    double floor, walls, ceiling; /* mean reflectances */
};

/* What it gives: a fraction, and the factors for the room's own floor and ceiling. */
struct pp_irc_minimum {
    double printed; /* for 40 m2, a ceiling of 0.7, an obstruction of 20 degrees */
    double floor_factor, ceiling_factor;
};

/* Why the room is outside the printed figures, as a static sentence, or NULL. */
const char *pp_irc_minimum_lacks(const struct pp_irc_minimum_entry *entry);

struct pp_irc_minimum pp_irc_minimum_read(const struct pp_irc_minimum_entry *entry);

/* The room's average over its minimum, 1.8 to 1.2, by the mean reflectance of its
 * walls; the end's where that is below 0.2 or above 0.8. */
double pp_irc_minimum_average_ratio(double walls);

#endif
