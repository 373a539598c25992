/* annual_sheet.h - annual daylight in a room, as printed and drawn.
 *
 * studies/year/annual.h fills it. Illuminances are in lx, durations in h, shares 0 to
 * 1.
 */
#ifndef PP_MODEL_RESULTS_SHEETS_ANNUAL_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_ANNUAL_SHEET_H

#include <stdbool.h>

#include "model/results/sheets/annual_value.h"
#include "model/results/sheets/lighting_sheet.h"
#include "model/room/world.h"

enum {
    PP_ANNUAL_ILLUMINANCES_MOST = 8,
    PP_ANNUAL_WORDS = 640,
    PP_ANNUAL_WARNINGS_MOST = 8,
    PP_ANNUAL_LEVELS = 4, /* EN 17037: 100, 300, 500, 750 lx */
};

extern const double pp_annual_sheet_levels_lx[PP_ANNUAL_LEVELS];

/* Results for a point, or their means over the plane. "Hours" are occupied hours. */
struct pp_annual_figures {
    struct pp_annual_value
        autonomy[PP_ANNUAL_ILLUMINANCES_MOST]; /* share of hours with E >= target */
    struct pp_annual_value
        continuous[PP_ANNUAL_ILLUMINANCES_MOST]; /* mean of min(1, E/target) */
    struct pp_annual_value udi_below, udi_low, udi_good,
        udi_above;                  /* shares of hours with E below 100, 100 to
                                     * 300, 300 to 3000, above 3000 lx */
    struct pp_annual_value sun_h;   /* hours with more than 1000 lx of direct sun */
    struct pp_annual_value mean_lx; /* mean over the hours */
    struct pp_annual_value
        median_lx; /* median illuminance of the 4380 brightest hours of the year */
    struct pp_annual_value year_lxh; /* sum over all hours of the year */
    struct pp_annual_value sky_lxh, sun_lxh, sun_reflected_lxh; /* parts: sky and
                                                                 * ground; direct
                                                                 * sun; reflected
                                                                 * sun */
    struct pp_annual_value autonomy_300; /* share of hours with 300 lx, blinds open */
    struct pp_annual_value
        blinds_autonomy; /* share of hours with 300 lx, with blinds; NAN: no blinds */
};

/* Number of values of pp_annual_figures. */
enum {
    PP_ANNUAL_FIGURES =
        sizeof(struct pp_annual_figures) / sizeof(struct pp_annual_value)
};

/* Value of pp_annual_figures with that index. */
static inline struct pp_annual_value *pp_annual_sheet_figure(
    struct pp_annual_figures *figures, int index)
{
    return (struct pp_annual_value *)figures + index;
}

/* Shares of the plane; if the points are not a grid with areas, of the points. */
struct pp_annual_plane {
    struct pp_annual_value autonomous; /* 300 lx in half of the hours or more */
    struct pp_annual_value sda;        /* the same with blinds; NAN: no blinds */
    struct pp_annual_value ase;        /* ASE: more than 250 h with more than 1000 lx of
                                 * direct sun; NAN: no hour has direct sun */
    struct pp_annual_value level[PP_ANNUAL_LEVELS]; /* EN 17037, method 2 */
};

enum {
    PP_ANNUAL_PLANE = sizeof(struct pp_annual_plane) / sizeof(struct pp_annual_value)
};

/* Openings whose blinds close together (studies/year/blind_groups.h). */
struct pp_annual_group {
    char name[64];
    const char *device; /* "blind", "screen" or "curtain" of its own; NULL: none */
    double closed_h;    /* occupied hours with blinds closed */
    double unmet_h;     /* of those: hours in which more than 2 % of the plane has 1000
                         * lx of direct sun through the closed device */
    struct pp_annual_value
        light_lxh; /* annual light through the group, mean of the points */
};

/* One hour of the year. */
struct pp_annual_hour {
    int month, day;
    double start_h, length_h; /* local standard time */
    double occupied_h;
    bool known;
    double sun_altitude_rad,
        sun_bearing_rad;          /* bearing clockwise from north; NAN: no sun */
    double diffuse_lx, direct_lx; /* horizontal; normal to the sun */
    int sky;                      /* index in lx and sun_lx; -1: dark */
};

/* Discretisation error of sky patches and sun cells, measured on a sample of points and
 * hours by comparison with light paths under the actual sky and sun. */
struct pp_annual_discretisation {
    int points, hours; /* size of the sample; 0: not measured */
    struct pp_annual_value
        sky;        /* error of patches, divided by the light of sky and ground; mean */
    double sky_rms; /* RMS error of single hours and points */
    struct pp_annual_value
        all; /* error, divided by all light except direct sun; mean of points */
};

struct pp_annual_sheet {
    const struct pp_world *world;        /* not owned */
    const struct pp_receiver *receivers; /* not owned */
    int receiver_count;
    int illuminance_count;
    double illuminances_lx[PP_ANNUAL_ILLUMINANCES_MOST];
    char weather[PP_ANNUAL_WORDS], period[PP_ANNUAL_WORDS], notes[2 * PP_ANNUAL_WORDS],
        method[PP_ANNUAL_WORDS], blinds[PP_ANNUAL_WORDS];
    int warning_count;
    char warnings[PP_ANNUAL_WARNINGS_MOST][PP_ANNUAL_WORDS];
    double sun_shift_min;
    double occupied_h;        /* occupied hours in the year */
    double daylit_h;          /* hours with a sky or a sun */
    double diffuse_median_lx; /* median of the 4380 brightest hours */
    bool is_grid;             /* the points are a grid over the plane; else `plane` is
                               * for the points only */
    bool has_blinds;          /* there are figures with blinds */
    bool blinds_of_lm83; /* operated as in LM-83: the share with blinds is its sDA */
    bool standard_hours; /* 8 to 18 h on all days, as in LM-83 */
    bool finished;

    struct pp_annual_figures *points; /* by receiver; owned */
    struct pp_annual_figures mean;
    struct pp_annual_plane plane;
    struct pp_annual_discretisation discretisation;
    int near_half; /* points whose autonomy is within 2 standard errors of 0.5 */
    int group_count;
    struct pp_annual_group *groups; /* owned */

    int lighting_count; /* number of controls of electric light; 0: not studied */
    struct pp_lighting_sheet *lighting; /* owned */

    int hour_count;
    struct pp_annual_hour *hours; /* owned */
    const char *sky_name;         /* sky of a moment: "perez", ...; not owned */
    int sky_count;
    float *lx; /* [receiver][sky]: illuminances, blinds open, except if they are
                * always closed or have a schedule; owned */
    int patch_count;
    float *
        coefficients; /* [receiver][1 + patch]: lx over cd/m2 of the ground, of patches of
                          * the sky; owned; NULL: not kept */
    char coefficient_record[320]; /* of the room and options of the coefficients, lines
                                   * "NAME=value" */
    float *sun_lx;                /* [receiver][sky]: direct sun, blinds open; owned */
};

/* Credits of LEED v4.1, daylight, option 1. The credits of a building depend on the
 * mean sDA of all regularly occupied areas; here only this room is considered. */
struct pp_annual_leed {
    const char *why_not; /* reason why points is not known; NULL: known */
    int points;          /* 1, 2, 3 for an sDA of 40, 55, 75 % */
    bool ase_to_explain; /* ASE exceeds 10 %: a statement on glare is required */
};
struct pp_annual_leed pp_annual_sheet_leed(const struct pp_annual_sheet *sheet);

/* False if no hour of the year has direct sun, so that ASE says nothing. */
bool pp_annual_sheet_has_sun(const struct pp_annual_sheet *sheet);

/* Illuminance of a point in an hour; 0 in the dark, NAN if the hour is not known. */
double pp_annual_sheet_lx(const struct pp_annual_sheet *sheet, int receiver, int hour);

void pp_annual_sheet_clear(struct pp_annual_sheet *sheet);

#endif
