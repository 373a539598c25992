/* annual.h - the daylight of a room in every hour of a year, and its figures.
 *
 * Direct light from sky and sun at a point is calculated in closed form
 * (methods/exact/sky_view.h); all other light is simulated (simulate/year/). The room's
 * finishes are diffuse, as for daylight factors.
 *
 * By LM-83-12 [LM83], openings of one wall and one glass are a group; its blinds are
 * closed in hours when more than 2 % of the plane has 1000 lx or more of direct sun
 * through it. A window that has a blind, screen or curtain is then simulated with it.
 * Another window becomes a uniform Lambertian emitter of 20 % of the light that falls on
 * it, times the diffuse transmittance of the pane.
 */
#ifndef PP_STUDIES_YEAR_ANNUAL_H
#define PP_STUDIES_YEAR_ANNUAL_H

#include "model/light/outside_light.h"
#include "model/results/sheets/annual_sheet.h"
#include "studies/climate/working_hours.h"
#include "studies/study_options.h"
#include "studies/study_room.h"
#include "studies/year/weather_year.h"

enum { PP_ANNUAL_STORES_MOST = 3 };

struct pp_year_store; /* simulate/year/year_store.h */

/* Control of blinds, screens and curtains. Except as drawn, figures are for windows
 * without these devices, and one figure is with them. */
enum pp_blinds {
    PP_BLINDS_AS_DRAWN, /* the devices stay where they are */
    PP_BLINDS_NEVER,    /* no figure with devices */
    PP_BLINDS_LM83,     /* by LM-83-12; also for windows without a device */
    PP_BLINDS_ALWAYS,   /* in all hours */
    PP_BLINDS_SCHEDULE  /* in the hours of a schedule */
};

struct pp_annual_options {
    struct pp_working_hours hours;
    struct pp_summer_time summer;
    int illuminance_count;
    double illuminances_lx[PP_ANNUAL_ILLUMINANCES_MOST];
    int patches;  /* 145, 577 or 2305 */
    int samples;  /* paths per point in each randomisation; 0: by error */
    double error; /* target for the largest relative standard error of a point's
                   * light; 0: not set */
    enum pp_blinds blinds;
    const unsigned char *schedule; /* by record of the year: 1 closed, 0 open; not
                                    * owned */
    int schedule_count;
    bool strict;       /* PP_BAD_INPUT instead of warnings */
    bool coefficients; /* keep the coefficients in the sheet */
    bool measure;      /* measure the error of patches and cells */
    bool exact_sky;    /* without patches and cells: slow, for reference */
    int lighting_count;
    struct pp_lighting_control lighting[PP_LIGHTING_CONTROLS_MOST]; /* controls of the
                                                                     * electric light */
    uint64_t seed;
    int threads;
    struct pp_year_store
        *stores[PP_ANNUAL_STORES_MOST]; /* of coefficients; not owned */
    int store_count;
    int room_number; /* index of the room in the command, for the stores */
    struct pp_watch watch;
};

/* Options for the figures of LM-83-12 and LEED: 8 to 18 h in standard time, 300 lx,
 * blinds, 577 patches, seed 1. */
extern const struct pp_annual_options pp_annual_options_lm83;

/* Evaluates the room's points: a grid over its plane (is_grid), or others. *sheet
 * refers to world and receivers; the caller clears it, even after a failure. */
enum pp_status pp_annual_of_room(
    struct pp_annual_sheet *sheet, const struct pp_world *world,
    const struct pp_outside_light *light, const struct pp_receiver *receivers,
    int receiver_count, bool is_grid, const struct pp_weather_year *year,
    const struct pp_annual_options *options, struct pp_error *err);

/* As pp_annual_of_room, for the points of a study room; they are a grid if they form a
 * lattice. */
enum pp_status pp_annual_of_study_room(struct pp_annual_sheet *sheet,
                                       const struct pp_study_room *room,
                                       const struct pp_weather_year *year,
                                       const struct pp_annual_options *options,
                                       struct pp_error *err);

#endif
