/* method_run.h - one method on one world: its sum over the openings at a receiver or
 * for the room, corrected for glass, frame and dirt (methods/allowance.h), and the
 * average of this sum over the working plane. */
#ifndef PP_METHODS_METHOD_RUN_H
#define PP_METHODS_METHOD_RUN_H

#include "methods/method.h"
#include "methods/variant.h"
#include "model/base/thread_pool.h"
#include "model/results/report.h"

/* Relative error allowed in an average over points, and the limit on their number. */
#define PP_AVERAGE_ERROR 1e-3
enum { PP_AVERAGE_POINTS = 2000 };

/* Tools shared by the methods of one evaluation; not owned. */
struct pp_method_shared {
    struct pp_beams *beams; /* beams of the world */
    struct pp_thread_pool *pool;
};

/* A method as published or with a variant of a formula. */
struct pp_method_run {
    const struct pp_method *method;
    const char *name; /* name of its columns */
    bool varied;      /* true: with a variant of a formula */
    const struct pp_world *world;
    const struct pp_outside_light *light;
    double *factors; /* product of the corrections that the figures lack, for each
                      * opening */
    void *tools;     /* made by the method; NULL for a room, or an opening, that it
                      * refuses for any receiver */
    struct pp_formulary *formulary;
    bool refuses_alike; /* which openings are refused does not depend on the receiver */
    const struct pp_opening *refused; /* with refuses_alike: the first opening that the
                                       * method does not cover; NULL: none */
    const char *why_refused;
    struct pp_method_shared shared;
    bool plain;   /* true: no tables, beams and other fast methods */
    bool roughly; /* true: by evaluate_roughly, for an average */
    struct pp_stop stop;
};

/* A method's corrected components, summed over all openings, or the reason why there
 * are none. */
struct pp_method_answer {
    struct pp_amounts amounts;
    const char *why;                  /* not owned; NULL: the amounts are valid */
    const struct pp_opening *opening; /* opening to which `why` refers; NULL: the
                                       * room */
    int column;                       /* column of the mistake in a variant's text, from
                                       * 1; 0: none */
    struct pp_steps *steps;           /* where the sum is recorded; may be NULL */
};

/* Makes the method's tools for the report's world, light and options. variant: NULL for
 * the published formula. On success the caller clears the run. */
enum pp_status pp_method_run_init(struct pp_method_run *run,
                                  const struct pp_method *method,
                                  const struct pp_variant *variant,
                                  const struct pp_report *report,
                                  struct pp_method_shared shared, struct pp_error *err);
void pp_method_run_clear(struct pp_method_run *run);

/* Finds the sum over the openings for a receiver (NULL: for the room), or the reason
 * why there is none. The caller sets answer->steps, and owns the steps. May be called
 * from several threads at once. */
enum pp_status pp_method_run_answer(const struct pp_method_run *run,
                                    const struct pp_receiver *receiver,
                                    struct pp_method_answer *answer,
                                    struct pp_error *err);

/* Finds the average over the working plane by a method that gives values at points. */
enum pp_status pp_method_run_average(const struct pp_method_run *run,
                                     struct pp_method_answer *answer,
                                     struct pp_error *err);

#endif
