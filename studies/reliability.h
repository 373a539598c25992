/* reliability.h - kinds of rooms in which hand methods are unreliable, and the errors
 * found in such rooms.
 *
 * There are four kinds. Each has a threshold, and the range of the ratio of hand value
 * to simulated value that was found in rooms of that kind (tables/reliability.csv):
 *
 *     outside      0.3 or more of the average daylight factor is reflected from outside
 *     inside       at the darkest point no sky is visible, or 0.65 or more of the
 *                  daylight factor is the room's average internally reflected component
 *     proportions  the room is more than twice as deep as wide, the limit of the table
 *                  of `bre-min`, and the report has a value by that method
 *     ground       the ground reflectance differs by 0.3 or more from the value built
 *                  into the method
 *
 * Methods whose built-in ground reflectance differs from that of the room are always
 * listed.
 */
#ifndef PP_STUDIES_RELIABILITY_H
#define PP_STUDIES_RELIABILITY_H

#include <stddef.h>

#include "model/results/report.h"

enum pp_reliability_kind {
    PP_RELIABILITY_OUTSIDE,
    PP_RELIABILITY_INSIDE,
    PP_RELIABILITY_PROPORTIONS,
    PP_RELIABILITY_GROUND,
    PP_RELIABILITY_KINDS,
};

/* Names of the kinds in the table and in JSON. */
extern const char *const pp_reliability_names[PP_RELIABILITY_KINDS];

struct pp_reliability {
    bool is[PP_RELIABILITY_KINDS];
    double share[PP_RELIABILITY_KINDS]; /* a fraction, depth divided by width, or the
                                         * room's ground reflectance */
    bool any;
    char grounds[320]; /* sentence, without full stop, on methods whose built-in ground
                        * reflectance differs from that of the room; empty: none */
};

/* Row of the table: lowest and highest ratio of hand value to simulated value. of:
 * quantity of these values; rooms: number of rooms. */
struct pp_reliability_band {
    const char *kind, *of;
    double low, high;
    int rooms;
};

const struct pp_reliability_band *pp_reliability_band(enum pp_reliability_kind kind);

/* Assesses the values of hand methods in the report: the first daylight factor by a
 * pair of methods, at its points and on average, and all other methods. Without a pair,
 * the first two kinds are not assessed. */
struct pp_reliability pp_reliability_of(const struct pp_report *report);

/* Writes the sentence "Do not rely on hand figures here: ...", without full stop; empty
 * if the hand methods are reliable. */
void pp_reliability_sentence(const struct pp_reliability *reliability, char *text,
                             size_t size);

/* Writes the same sentence with a full stop, as a note below a drawing of a report. */
void pp_reliability_note(const struct pp_report *report, char *text, size_t size);

#endif
