/* report.h - all results of one room, as printed and drawn.
 *
 * A column contains a component by one method ("exact"), by a pair of methods
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

/* Daylight factors (fractions); the report gives the share of the plane that reaches
 * each. */
enum { PP_PLANE_LEVELS = 3 };
extern const double pp_plane_levels[PP_PLANE_LEVELS];

/* Statistics over the points of a grid on the working plane; NAN without a grid. */
struct pp_plane_reading {
    struct pp_reading minimum, median, average;
    double uniformity;            /* minimum over average */
    double over[PP_PLANE_LEVELS]; /* share of the plane that reaches each level */
};

struct pp_column {
    enum pp_component component;
    char name[48];
    struct pp_reading average; /* average over the whole working plane */
    struct pp_reading
        margin_average;      /* over the plane less a strip of 0.5 m along its edge
                              * (plane_margin.h) */
    bool has_margin_average; /* true if requested */
    bool of_all_surfaces; /* `average` is over all surfaces of the room; not comparable
                             * with averages over the working plane */
    bool has_plane;       /* has a daylight factor at every point of the grid */
    struct pp_plane_reading plane;    /* statistics over the grid, if has_plane */
    struct pp_reading *points;        /* one per receiver; NULL: only an average */
    struct pp_band_ends average_band; /* likely range of the average, if known */
    struct pp_band_ends *bands;       /* likely ranges, one per point; NULL: none */
    double common, common_near;       /* correlated share of the points' variance
                                       * (common_error.h): of all points, and of
                                       * neighbours */
};

struct pp_method_options; /* methods/method.h */

struct pp_report {
    const struct pp_world *world;            /* not owned */
    struct pp_outside_light light;           /* outdoor light, in the axes of world */
    const struct pp_method_options *options; /* not owned; NULL: defaults */
    const struct pp_receiver *receivers;     /* not owned */
    struct pp_receiver *more_receivers;      /* owned list of receivers, freed with the
                                         * report; NULL: none */
    int receiver_count;
    int grid_points;       /* number of grid points for the statistics `plane`; 0: no
                            * grid */
    bool grid_of_standard; /* grid of EN 17037, which differs from the receivers */
    struct pp_column *columns; /* sorted by component, then in order of selection */
    int column_count;
    bool finished;        /* false: interrupted; the existing columns are valid */
    bool explain;         /* methods record their steps */
    int threads;          /* for the methods; 0: one per processor */
    const char *no_bands; /* reason why no column has likely ranges; NULL: some have,
                           * or none were requested. Owned, with the sentences */
    const char *stand_in; /* methods used because the default methods do not cover the
                           * room; NULL: they do. Owned, with the sentences */
    const char *missed_error; /* places where the simulation's standard errors exceed
                               * the target; NULL: none, or no target. Owned, with
                               * the sentences */
    char **sentences;         /* texts that `why` of readings points to, unless
                               * static */
    int sentence_count;
    struct pp_steps **steps; /* lists that `steps` of readings points to */
    int steps_count;
};

/* Adds a column after the others of its component; all readings, one per point if
 * for_points, are "not calculated". NULL if memory runs out. The pointer is valid until
 * the next call. */
struct pp_column *pp_report_add(struct pp_report *report, enum pp_component component,
                                const char *name, bool for_points);

/* Column of that component and name; NULL if there is none. */
const struct pp_column *pp_report_find(const struct pp_report *report,
                                       enum pp_component component, const char *name);

/* Makes a text for `why` of a reading. The report owns it until it is cleared; equal
 * texts are stored once. NULL if memory runs out. */
const char *pp_report_say(struct pp_report *report, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Makes an empty list of steps, owned by the report until it is cleared; NULL if memory
 * runs out. */
struct pp_steps *pp_report_steps(struct pp_report *report);

/* Frees the columns, sentences, steps and more_receivers; the other members stay. */
void pp_report_clear(struct pp_report *report);

#endif
