/* lighting_year.c - see lighting_year.h. */
#include "studies/lighting/lighting_year.h"

#include <math.h>

#include "studies/lighting/hunt_switching.h"
#include "studies/lighting/lighting_control.h"

static bool is_same_day(const struct pp_annual_hour *a, const struct pp_annual_hour *b)
{
    return a->month == b->month && a->day == b->day;
}

/* State of lamps and occupants as the year passes. */
struct lighting_state {
    bool on;                           /* on-off: state of the photocell */
    const struct pp_annual_hour *came; /* manual: record of the last arrival */
    double probability;                /* manual: probability that the light has been on
                                        * since then */
};

/* Fraction of the installed power while the room is occupied. */
static double lighting_power(const struct pp_lighting_control *control,
                             const struct pp_annual_hour *hour, double E,
                             struct lighting_state *state)
{
    if (control->kind != PP_LIGHTING_MANUAL)
        return pp_lighting_control_power(control, E, &state->on);
    if (hour->occupied_h > 0.0 && (!state->came || !is_same_day(state->came, hour))) {
        state->came = hour;
        state->probability = pp_hunt_switching_probability(E);
    }
    return state->probability;
}

struct pp_lighting_year pp_lighting_year_of(const struct pp_lighting_control *control,
                                            const struct pp_annual_hour *hours,
                                            int hour_count, const float *E,
                                            float *fraction)
{
    struct pp_lighting_year year = {0.0, 0.0, 0.0};
    struct lighting_state state = {.on = true};
    for (int i = 0; i < hour_count; i++) {
        const struct pp_annual_hour *hour = &hours[i];
        double power = 0.0;
        if (hour->known)
            power = lighting_power(control, hour, E[i], &state);
        year.occupied_h += hour->occupied_h;
        year.used_h += hour->occupied_h * power;
        if (control->kind == PP_LIGHTING_MANUAL)
            year.on_h += hour->occupied_h * power;
        else if (power > 0.0)
            year.on_h += hour->occupied_h;
        if (fraction)
            fraction[i] = (float)(power * hour->occupied_h / hour->length_h);
    }
    return year;
}

int pp_lighting_year_records_of_hour(const struct pp_annual_hour *hours, int hour_count,
                                     int first)
{
    int count = 1;
    /* Start times are multiples of a fraction of an hour, with rounding errors. */
    double hour = floor(hours[first].start_h + 1e-6);
    while (first + count < hour_count
           && is_same_day(&hours[first], &hours[first + count])
           && floor(hours[first + count].start_h + 1e-6) == hour)
        count++;
    return count;
}

void pp_lighting_year_average_hours(float *E, const struct pp_annual_hour *hours,
                                    int hour_count)
{
    for (int first = 0, count; first < hour_count; first += count) {
        double sum = 0.0;
        int known = 0;
        count = pp_lighting_year_records_of_hour(hours, hour_count, first);
        for (int i = first; i < first + count; i++)
            if (hours[i].known) {
                sum += (double)E[i];
                known++;
            }
        for (int i = first; i < first + count && known > 0; i++)
            E[i] = (float)(sum / known);
    }
}
