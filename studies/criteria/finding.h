/* finding.h - one figure of a criterion, its bound, and the verdict. */
#ifndef PP_STUDIES_CRITERIA_FINDING_H
#define PP_STUDIES_CRITERIA_FINDING_H

#include <stdbool.h>

#include "pepperpot.h"
#include "model/base/error.h"
#include "model/results/band.h"
#include "model/results/lit_area.h"

enum pp_figure {
    PP_FIGURE_FACTOR, /* a fraction of the open-sky horizontal illuminance */
    PP_FIGURE_SHARE,  /* a fraction of anything else; printed in per cent, as factors */
    PP_FIGURE_RATIO,  /* dimensionless */
    PP_FIGURE_COUNT,  /* a whole number */
    PP_FIGURE_ANGLE,  /* radians */
    PP_FIGURE_LENGTH, /* m */
    PP_FIGURE_AREA,   /* m2 */
    PP_FIGURE_HOURS,
    PP_FIGURE_LUX,
};

struct pp_finding {
    char what[128]; /* "W1, south"; "300 lx over 50 % of the plane" */
    int line;       /* line of the opening in the room file; 0: the room as a whole */
    enum pp_figure kind;
    double figure;                        /* value compared with the bound; NAN: not
                                           * assessed */
    double now, before;                   /* the values compared by the figure
                              * (pp_finding_compares); NAN: none */
    enum pp_figure compared;              /* kind of the values */
    double now_unshaded, before_unshaded; /* `now` and `before` without the overhangs
                                           * and balconies of the building itself; NAN:
                                           * none, or not known */
    const char *season; /* "year" or "winter", for sunlight hours; NULL. Static */
    double std_error;   /* standard error of the figure, from noise and grid; NAN:
                         * nothing was sampled */
    double grid_error;  /* part of std_error due to the spacing of the grid; NAN: no
                        * grid */
    struct pp_band_ends band; /* band of a hand figure, if known */
    double wanted;            /* the bound; NAN: none, the figure is only stated */
    bool at_most;             /* true: the bound is an upper bound; false: a lower
                               * bound */
    bool strict;              /* true: the figure must be greater than the lower
                               * bound */
    double reached_over; /* fraction of the plane on which the bound is reached; NAN:
                          * the criterion does not concern a fraction of the plane */
    double over_error;   /* standard error of reached_over, from noise and grid; NAN:
                          * not known */
    enum pp_verdict verdict;
    double confidence; /* probability that the verdict is right; for PP_UNDECIDED
                        * that the criterion is met; NAN if nothing was sampled */
    bool
        is_optional; /* a level above the lowest, or one of several options: its verdict
                      * is not counted */
    int level; /* level of EN 17037 that the finding belongs to: 1 minimum to 3 high; 0:
                * none */
    const char *decided_by; /* criterion that decides if this one is not met, so that
                             * missing this one is not a failure; NULL: none. Static */
    char note[480];         /* sentences without the last full stop; may be empty */
};

/* Word for a verdict: "met", "not met", "undecided", "not judged"; NULL for a figure
 * that is only stated. Static. */
const char *pp_finding_verdict(enum pp_verdict verdict);

/* Word for a verdict in reports: as pp_finding_verdict, but "not applicable" for
 * PP_NOT_JUDGED. */
const char *pp_finding_word(enum pp_verdict verdict);

/* Word for a finding's verdict: as pp_finding_word, but "reached" or "not reached" for
 * an optional level. */
const char *pp_finding_own_word(const struct pp_finding *finding);

/* The findings of one criterion. */
struct pp_finding_list {
    struct pp_finding *list;
    int count;
    char basis[640]; /* method by which the figures were found, as a sentence without
                      * a full stop; empty if they follow from the room file */
    struct pp_lit_change
        lit; /* areas for rights of light; plane_m2 is 0 for other criteria and if not
              * assessed */
};

/* Least probability of being right for a verdict on a sampled figure: the usual level
 * of statistical tests, not calibrated. */
#define PP_SURE 0.95

/* A finding with a figure and its bound. A figure within 1e-9 of the bound, relative,
 * meets it. wanted NAN: the figure is only stated. A figure of NAN is not assessed.
 * `what` is a printf format. */
struct pp_finding pp_finding_of(enum pp_figure kind, double figure, double wanted,
                                bool at_most, const char *what, ...)
    __attribute__((format(printf, 5, 6)));

/* Stores the values that the figure compares: now, and before something was built (NAN:
 * not known). */
void pp_finding_compares(struct pp_finding *finding, enum pp_figure compared,
                         double now, double before);

/* A finding without a figure, not assessed; `why` becomes its note. */
struct pp_finding pp_finding_not_judged(const char *why, const char *what, ...)
    __attribute__((format(printf, 2, 3)));

/* Makes a verdict PP_UNDECIDED if the bound is within `error` of the figure. */
void pp_finding_within(struct pp_finding *finding, double error);

/* Sets verdict and confidence by PP_SURE, for a figure sampled with that standard
 * error; probability: that the criterion is met. */
void pp_finding_sampled(struct pp_finding *finding, double std_error,
                        double probability);

/* Sets the likely range of a hand figure. The verdict is PP_UNDECIDED, with a note, if
 * the finding is open (pp_finding_is_open). */
void pp_finding_by_hand(struct pp_finding *finding, struct pp_band_ends band);

/* Probability that a quantity is `wanted` or more, if it is sampled as `value` with a
 * standard error (greater than 0), by the normal distribution. */
double pp_finding_probability_at_least(double value, double std_error, double wanted);

/* True if the true value may be on the other side of the bound, that is, if the bound
 * lies in the band, or between the band and the figure. */
bool pp_finding_is_open(const struct pp_finding *finding);

/* Adds text to the finding's note; cut off where the note is full. */
void pp_finding_note(struct pp_finding *finding, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Puts a copy of the finding at the end of the list. */
enum pp_status pp_finding_list_add(struct pp_finding_list *findings,
                                   const struct pp_finding *finding,
                                   struct pp_error *err);

/* Adds text to the list's basis; cut off where the basis is full. */
void pp_finding_list_add_basis(struct pp_finding_list *findings, const char *format,
                               ...) __attribute__((format(printf, 2, 3)));
void pp_finding_list_clear(struct pp_finding_list *findings);

#endif
