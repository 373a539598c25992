/* reliability.h - kinds of rooms in which the figures of hand methods are unreliable,
 * and the errors measured there.
 *
 * There are four kinds, each with a threshold and with the ratios of hand to traced
 * figures that were measured in rooms of that kind (tables/reliability.csv):
 *
 *     outside      0.3 or more of the average daylight factor is reflected from outside
 *     inside       at the darkest point no sky is seen, or 0.65 or more of the daylight
 *                  factor is the room's average reflected light
 *     proportions  the room is more than twice as deep as wide, the limit of the table
 *                  of `bre-min`
 *     ground       its reflectance differs by 0.3 or more from the one built into the
 *                  method
 *
 * Methods with a built-in ground reflectance that differs from the room's are always
 * named.
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

/* Names of the kinds, as in the table and in JSON. */
extern const char *const pp_reliability_names[PP_RELIABILITY_KINDS];

struct pp_reliability {
    bool is[PP_RELIABILITY_KINDS];
    double share[PP_RELIABILITY_KINDS]; /* value compared with the threshold: a share,
                                         * depth over width, reflectance of the
                                         * ground */
    bool any;
    char grounds[320]; /* methods whose built-in ground differs from the room's, as a
                        * sentence without a full stop; empty: none */
};

/* A row of the table: lowest and highest ratio of hand to simulated figures; of: the
 * figures' kind; rooms: their number. */
struct pp_reliability_band {
    const char *kind, *of;
    double low, high;
    int rooms;
};

const struct pp_reliability_band *pp_reliability_band(enum pp_reliability_kind kind);

/* Assesses the hand figures of the report: the first daylight factor by a pair of
 * methods, at its points and on average, and all other methods in the report. A report
 * without a pair has no room of the first two kinds. */
struct pp_reliability pp_reliability_of(const struct pp_report *report);

/* "Hand figures here are not to be relied on: ...", a sentence without a full stop;
 * empty if the figures are reliable. */
void pp_reliability_sentence(const struct pp_reliability *reliability, char *text,
                             size_t size);

/* The same for a report, with its full stop, as a note below a drawing. */
void pp_reliability_note(const struct pp_report *report, char *text, size_t size);

#endif
