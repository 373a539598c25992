/* report.h - all results of one room, as they are printed and drawn.
 *
 * A column is one entry of the results: a component by a method ("exact"), by a pair
 * ("exact+bre"), or by the simulation ("traced").
 */
#ifndef PP_MODEL_RESULTS_REPORT_H
#define PP_MODEL_RESULTS_REPORT_H

#include <stdbool.h>

#include "model/light/outside_light.h"
#include "model/results/band.h"
#include "model/results/reading.h"
#include "model/results/steps.h"
#include "model/room/world.h"

/* Levels (fractions) whose share of the plane is reported. */
enum { PP_PLANE_LEVELS = 3 };
extern const double pp_plane_levels[PP_PLANE_LEVELS];

/* Statistics over the points of a grid on the working plane; NAN where there is none. */
struct pp_plane_reading {
    struct pp_reading minimum, median, average;
    double uniformity;            /* minimum over average */
    double over[PP_PLANE_LEVELS]; /* share of the points that reach each level */
};

struct pp_column {
    enum pp_component component;
    char name[48];
    struct pp_reading average; /* over the whole working plane */
    struct pp_reading
        margin_average;      /* over the plane inside 0.5 m (plane_margin.h); */
    bool has_margin_average; /* true if requested */
    bool of_all_surfaces; /* the average is over the room's surfaces: not to be compared
                                * with those over its working plane */
    bool has_plane;       /* a daylight factor at every point of the grid? */
    struct pp_plane_reading plane; /* its results for the plane */
    struct pp_reading *points;     /* one for each receiver; NULL: of the room only */
    struct pp_band_ends average_band; /* of the average, where that is known */
    struct pp_band_ends *bands;       /* one for each point; NULL: none */
    double common, common_near;       /* correlated share of these points' variance
                                 * (common_error.h): among all, and among neighbours */
};

struct pp_method_options; /* methods/method.h */

struct pp_report {
    const struct pp_world *world;            /* not owned */
    struct pp_outside_light light;           /* from outside, on that world */
    const struct pp_method_options *options; /* not owned; NULL: defaults */
    const struct pp_receiver *receivers;     /* not owned */
    struct pp_receiver *more_receivers; /* list that is freed with the report; NULL:
                                              * none */
    int receiver_count;
    int grid_points;       /* that the columns' `plane` speaks of; 0: there is none */
    bool grid_of_standard; /* EN 17037's, not the receivers themselves */
    struct pp_column *columns; /* in order of component, then of selection */
    int column_count;
    bool finished;        /* false: interrupted; the columns so far are good */
    bool explain;         /* methods write down their steps */
    int threads;          /* for the methods; 0: one for each processor */
    const char *no_bands; /* reason why no column has bands; NULL: some have, or none
                           * were requested. Kept with the sentences */
    const char *stand_in; /* replacement for the default methods if these do not cover
                           * the room; NULL: they do. Kept with the sentences */
    const char *missed_error; /* places where the simulation's standard errors exceed
                               * the target; NULL: none, or no target. Kept with the
                               * sentences */
    char **sentences;         /* that readings' why points to, where it is not static */
    int sentence_count;
    struct pp_steps **steps; /* that readings' steps point to */
    int steps_count;
};

/* A new column behind the others of its component, with room for the points' readings
 * (or for none), all "not computed"; NULL when memory is out. The pointer is good until
 * the next call. */
struct pp_column *pp_report_add(struct pp_report *report, enum pp_component component,
                                const char *name, bool for_points);

/* The column of that component and name, or NULL. */
const struct pp_column *pp_report_find(const struct pp_report *report,
                                       enum pp_component component, const char *name);

/* A sentence for a reading's why, kept (once) by the report until it is cleared; NULL
 * when memory is out. */
const char *pp_report_say(struct pp_report *report, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* An empty list of steps, kept by the report until it is cleared; NULL when memory is
 * out. */
struct pp_steps *pp_report_steps(struct pp_report *report);

/* Frees the columns, sentences and steps; the rest of the report stays. */
void pp_report_clear(struct pp_report *report);

#endif
