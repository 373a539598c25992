/* diffuse_curve.c - sorts the working hours of a year in descending order of
 * illuminance, and accumulates them. Fractions and illuminances are then found by
 * bisection.
 */
#include "studies/climate/diffuse_curve.h"

#include <math.h>
#include <stdlib.h>

/* A period of working time with constant illuminance. */
struct worked_hour {
    double lx, length_h;
};

/* Sorts in descending order of illuminance, then of length, so that the result does not
 * depend on the sorting algorithm. */
static int compare_hours(const void *a, const void *b)
{
    const struct worked_hour *p = a, *q = b;
    if (p->lx != q->lx)
        return p->lx > q->lx ? -1 : 1;
    return (p->length_h < q->length_h) - (p->length_h > q->length_h);
}

/* Collects the working time with known illuminance in `worked`, sorted. Returns the
 * number of periods. Adds the time with unknown illuminance to curve->missing_h. */
static int collect_hours(struct worked_hour *worked, struct pp_diffuse_curve *curve,
                         const struct pp_diffuse_light *light,
                         const struct pp_working_hours *hours,
                         const struct pp_summer_time *summer)
{
    int count = 0;
    for (int i = 0; i < light->count; i++) {
        double length_h = pp_working_hours_share_h(hours, summer, &light->list[i]);
        if (length_h <= 0.0)
            continue;
        if (isnan(light->list[i].lx)) {
            curve->missing_h += length_h;
            continue;
        }
        worked[count++] = (struct worked_hour){light->list[i].lx, length_h};
    }
    qsort(worked, (size_t)count, sizeof *worked, compare_hours);
    return count;
}

enum pp_status pp_diffuse_curve_init(struct pp_diffuse_curve *curve,
                                     const struct pp_diffuse_light *light,
                                     const struct pp_working_hours *hours,
                                     const struct pp_summer_time *summer,
                                     struct pp_error *err)
{
    *curve = (struct pp_diffuse_curve){0};
    size_t most = (size_t)light->count + 1;
    struct worked_hour *worked = malloc(most * sizeof *worked);
    curve->lx = malloc(most * sizeof *curve->lx);
    curve->reached_h = malloc(most * sizeof *curve->reached_h);
    enum pp_status status =
        worked && curve->lx && curve->reached_h ? PP_OK : pp_fail_memory(err);
    int count =
        status == PP_OK ? collect_hours(worked, curve, light, hours, summer) : 0;
    for (int i = 0; i < count; i++) {
        if (curve->count == 0 || worked[i].lx != curve->lx[curve->count - 1])
            curve->lx[curve->count++] = worked[i].lx;
        curve->total_h += worked[i].length_h;
        curve->reached_h[curve->count - 1] = curve->total_h;
    }
    free(worked);
    if (status == PP_OK && count == 0)
        status = pp_fail(err, PP_BAD_INPUT,
                         "the records have no diffuse light from %g to %g h",
                         hours->from_h, hours->to_h);
    if (status != PP_OK)
        pp_diffuse_curve_clear(curve);
    return status;
}

void pp_diffuse_curve_clear(struct pp_diffuse_curve *curve)
{
    free(curve->lx);
    free(curve->reached_h);
    *curve = (struct pp_diffuse_curve){0};
}

double pp_diffuse_curve_share(const struct pp_diffuse_curve *curve, double lx)
{
    /* Bisection for the number of illuminances that are greater than 0 and at least
     * `lx`. */
    int low = 0, high = curve->count;
    while (low < high) {
        int middle = (low + high) / 2;
        if (curve->lx[middle] >= lx && curve->lx[middle] > 0.0)
            low = middle + 1;
        else
            high = middle;
    }
    return low ? curve->reached_h[low - 1] / curve->total_h : 0.0;
}

double pp_diffuse_curve_lx(const struct pp_diffuse_curve *curve, double share)
{
    /* Bisection for the first illuminance that is reached in that fraction of the time.
     * A tolerance allows for a rounded fraction. */
    int low = 0, high = curve->count - 1;
    while (low < high) {
        int middle = (low + high) / 2;
        if (curve->reached_h[middle] >= share * curve->total_h * (1.0 - 1e-12))
            high = middle;
        else
            low = middle + 1;
    }
    return curve->lx[low];
}
