/* plane_trace.c - simulates with a large error per point, and computes the error of the
 * plane's figures. Then simulates again with the error per point that these figures
 * need. */
#include "studies/criteria/grid/plane_trace.h"

#include <math.h>
#include <stddef.h>

#include "studies/criteria/grid/plane_share.h"
#include "studies/study_report.h"

/* Target error of a point in the first simulation, over the target error of a figure.
 * Medians of a hundred points in eight rooms had 0.35 to 0.7 of a point's error. */
static const double first_times = 2.0;

/* Ratio to the target error up to which no further simulation is needed. */
static const double near_enough = 1.05;

enum { RUNS_MOST = 3 };

/* Safety factor on the error of a point for which the figures would just reach the
 * target. */
static const double margin = 0.85;

static double relative_error(double value, double std_error)
{
    return value > 0.0 && isfinite(std_error) ? std_error / value : 0.0;
}

/* Largest standard error of a figure, over the figure. */
static enum pp_status find_worst(double *worst, const struct pp_report *report,
                                 bool of_average, struct pp_error *err)
{
    static const double parts[] = {0.5, 0.95};
    const struct pp_column *column = pp_report_find(report, PP_DF, "traced");
    enum pp_status status = PP_OK;
    *worst = of_average
                 ? relative_error(column->average.value, column->average.std_error)
                 : 0.0;
    for (size_t i = 0; i < sizeof parts / sizeof *parts && report->receiver_count > 0
                       && status == PP_OK;
         i++) {
        struct pp_plane_share share;
        status =
            pp_plane_share(&share, column->points, report->receivers,
                           report->receiver_count, column->common, parts[i], 0.0, err);
        if (status == PP_OK)
            *worst = fmax(*worst, relative_error(share.level, share.std_error));
    }
    return status;
}

enum pp_status pp_plane_trace(struct pp_report *report,
                              const struct pp_study_options *options, bool of_average,
                              bool *by_clock, struct pp_error *err)
{
    struct pp_study_options own = *options;
    if (!(options->error > 0.0) || options->seconds > 0.0)
        return pp_study_report_traced(report, options, by_clock, err);
    own.error = first_times * options->error;
    for (int run = 0; run < RUNS_MOST; run++) {
        double worst;
        enum pp_status status = pp_study_report_traced(report, &own, by_clock, err);
        if (status == PP_OK && report->finished)
            status = find_worst(&worst, report, of_average, err);
        if (status != PP_OK || !report->finished)
            return status;
        report->missed_error = NULL;
        if (worst <= near_enough * options->error || own.error <= options->error)
            return PP_OK;
        own.error = fmax(margin * own.error * options->error / worst, options->error);
    }
    return PP_OK;
}
