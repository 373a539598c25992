/* finding.h - one figure that a criterion asks for, and its verdict.
 */
#ifndef PP_STUDIES_CRITERIA_FINDING_H
#define PP_STUDIES_CRITERIA_FINDING_H

#include <stdbool.h>

#include "pepperpot.h"
#include "model/base/error.h"

enum pp_figure {
    PP_FIGURE_FACTOR, /* a fraction of the open-sky horizontal illuminance */
    PP_FIGURE_SHARE,  /* a fraction of anything else; both are read in per cent */
    PP_FIGURE_RATIO,
    PP_FIGURE_ANGLE, /* radians */
    PP_FIGURE_AREA,  /* m2 */
};

struct pp_finding {
    char what[80]; /* "south, line 9"; "300 lx over 50 % of the plane" */
    int line;      /* of the opening in the room file; 0: the room as a whole */
    enum pp_figure kind;
    double figure;       /* NAN: not judged */
    double std_error;    /* of it; NAN where nothing was sampled */
    double wanted;       /* NAN: stated */
    bool at_most;        /* wanted is the most, else the least */
    double reached_over; /* share of the plane on which `wanted` is reached; NAN where
                          * that is not what is asked */
    enum pp_verdict verdict;
    double confidence; /* probability that the verdict is right, of one not decided that
                        * the criterion is met; NAN where nothing was sampled */
    char note[320];    /* sentences without the last full stop; empty: nothing to add */
};

/* What one criterion found. */
struct pp_finding_list {
    struct pp_finding *list;
    int count;
    char basis[320]; /* what the figures rest on, as a sentence without a full stop;
                      * empty: the room as its file describes it */
};

/* Verdicts are given where the probability is this at least. */
#define PP_SURE 0.95

/* A figure with what is wanted of it, judged: it is met by a figure that is what is
 * wanted to 1e-9 of it. wanted NAN: stated. A figure of NAN is not judged. */
struct pp_finding pp_finding_of(enum pp_figure kind, double figure, double wanted,
                                bool at_most, const char *what, ...)
    __attribute__((format(printf, 5, 6)));

/* One that is not judged, and why. */
struct pp_finding pp_finding_not_judged(const char *why, const char *what, ...)
    __attribute__((format(printf, 2, 3)));

/* The figure is known to within `error` only: nearer to what is wanted than that it is
 * not decided. */
void pp_finding_within(struct pp_finding *finding, double error);

/* The figure was sampled, with that standard error, and the criterion is met with that
 * probability. */
void pp_finding_sampled(struct pp_finding *finding, double std_error,
                        double probability);

/* Probability that a value sampled as `value` with a standard error (greater than 0) is
 * `wanted` at least: of the normal distribution. */
double pp_finding_probability_at_least(double value, double std_error, double wanted);

/* Adds to the note. */
void pp_finding_note(struct pp_finding *finding, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Puts a copy at the end of the list. */
enum pp_status pp_finding_list_add(struct pp_finding_list *findings,
                                   const struct pp_finding *finding,
                                   struct pp_error *err);

/* Adds to the basis. */
void pp_finding_list_add_basis(struct pp_finding_list *findings, const char *format,
                               ...) __attribute__((format(printf, 2, 3)));
void pp_finding_list_clear(struct pp_finding_list *findings);

#endif
