/* sun_closure.c - finds the least difference over shifts from -1 to 1 h, in steps of 3
 * minutes. */
#include "studies/year/sun_closure.h"

#include <math.h>

#include "model/light/sun.h"

enum { STEPS = 20, SHIFTS = 2 * STEPS + 1 };

/* The balance counts as closed if the difference is below CLOSES_W_M2. A shift counts
 * if it is above SHIFT_H and more than halves the difference. */
static const double CLOSES_W_M2 = 50.0, SHIFT_H = 0.1;

int pp_sun_closure_year(const struct pp_epw *epw)
{
    int year = epw->record_count > 0 ? epw->records[0].year : 2001;
    for (int i = 1; i < epw->record_count; i++)
        if (epw->records[i].year != year)
            return 2001;
    return year >= 1950 && year <= 2050 ? year : 2001;
}

/* Sums of squares of the difference: for each shift; and without a shift for the file's
 * columns of direct and diffuse light swapped. */
struct closure_sums {
    double squares[SHIFTS], swapped;
    int records;
};

static void add_record(struct closure_sums *sums, const struct pp_epw *epw,
                       const struct pp_epw_record *record, int year)
{
    double middle_h = record->start_h + 0.5 * epw->record_h - epw->time_zone_h;
    sums->records++;
    for (int k = 0; k < SHIFTS; k++) {
        double shift_h = (double)(k - STEPS) / STEPS;
        double n = pp_sun_days_since_2000(year, record->date.month, record->date.day,
                                          middle_h + shift_h);
        struct pp_sun sun = pp_sun_at(n, epw->latitude_rad, epw->longitude_rad);
        double s = fmax(0.0, sin(sun.altitude_rad));
        double gap =
            record->direct_w_m2 * s + record->diffuse_w_m2 - record->global_w_m2;
        sums->squares[k] += gap * gap;
        double swapped =
            record->diffuse_w_m2 * s + record->direct_w_m2 - record->global_w_m2;
        if (k == STEPS)
            sums->swapped += swapped * swapped;
    }
}

static int best_of(const struct closure_sums *sums)
{
    int best = STEPS;
    for (int k = 0; k < SHIFTS; k++)
        if (sums->squares[k] < sums->squares[best])
            best = k;
    return best;
}

static double hours_of(int shift)
{
    return (double)(shift - STEPS) / STEPS;
}

static double rms(double squares, int records)
{
    return records > 0 ? sqrt(squares / records) : NAN;
}

struct pp_sun_closure pp_sun_closure_of_epw(const struct pp_epw *epw)
{
    struct closure_sums half[2] = {{.records = 0}, {.records = 0}}, all;
    int year = pp_sun_closure_year(epw);
    for (int i = 0; i < epw->record_count; i++) {
        const struct pp_epw_record *record = &epw->records[i];
        bool summer = record->date.month >= 4 && record->date.month <= 9;
        if (record->direct_w_m2 > 0.0 && !isnan(record->diffuse_w_m2)
            && !isnan(record->global_w_m2))
            add_record(&half[summer], epw, record, year);
    }
    all = half[0];
    all.records += half[1].records;
    all.swapped += half[1].swapped;
    for (int k = 0; k < SHIFTS; k++)
        all.squares[k] += half[1].squares[k];
    int best = best_of(&all);
    struct pp_sun_closure closure = {.records = all.records,
                                     .best_h = hours_of(best),
                                     .rms_best = rms(all.squares[best], all.records),
                                     .rms_0 = rms(all.squares[STEPS], all.records),
                                     .winter_h = hours_of(best_of(&half[0])),
                                     .summer_h = hours_of(best_of(&half[1]))};
    bool seasonal = half[0].records > 0 && half[1].records > 0
                    && fabs(closure.summer_h - closure.winter_h) > 0.7;
    if (all.records == 0)
        closure.finding = PP_CLOSURE_UNKNOWN;
    else if (rms(all.swapped, all.records) < 0.5 * closure.rms_best
             && closure.rms_best > 10.0)
        closure.finding = PP_CLOSURE_SWAPPED;
    else if (seasonal)
        closure.finding = PP_CLOSURE_SEASONAL;
    else if (closure.rms_best > CLOSES_W_M2)
        closure.finding = PP_CLOSURE_NONE;
    else if (fabs(closure.best_h) > SHIFT_H && closure.rms_best < 0.5 * closure.rms_0)
        closure.finding = PP_CLOSURE_SHIFTED;
    else
        closure.finding = PP_CLOSURE_AT_MIDDLE;
    return closure;
}
