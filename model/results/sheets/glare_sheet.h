/* glare_sheet.h - daylight glare probability of views in a room, at one moment or in
 * the occupied hours of a year, as printed.
 *
 * studies/glare/glare_study.h fills it.
 */
#ifndef PP_MODEL_RESULTS_SHEETS_GLARE_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_GLARE_SHEET_H

#include <stdbool.h>

#include "model/results/sheets/annual_sheet.h"
#include "model/room/world.h"

/* Number of DGP values that separate the classes of glare, and the levels of EN 17037
 * for a year. */
enum { PP_GLARE_LIMITS = 3 };
/* Share of the occupied hours in which a limit may be exceeded. */
#define PP_GLARE_SHARE 0.05
extern const double pp_glare_sheet_limits[PP_GLARE_LIMITS]; /* 0.35, 0.40, 0.45 */

/* "imperceptible", "perceptible", "disturbing", "intolerable". */
const char *pp_glare_sheet_class(double dgp);

/* The sources seen through one opening, or on the surfaces of the room. */
struct pp_glare_part {
    double sum;      /* sum of L^2 omega/P^2, cd2/m4 sr */
    double omega_sr; /* solid angle of the sources; 0: none */
    double light;    /* sum of L omega */
    double square;   /* sum of L^2 omega */
};

/* Mean luminance (cd/m2); and mean position index: the index P of the mean of 1/P^2
 * weighted by L^2 omega. */
double pp_glare_sheet_luminance(const struct pp_glare_part *part);
double pp_glare_sheet_index(const struct pp_glare_part *part);

/* Solid angle of the sun, 0.533 degrees wide. */
#define PP_GLARE_SUN_SR 6.7967e-5

struct pp_glare_sun {
    bool visible;
    int opening;     /* opening through which the sun is seen; -1: none */
    double omega_sr; /* of the visible part of its disc */
    double cd_m2, index, sum;
};

struct pp_glare_moment {
    struct pp_annual_value eye_lx, dgp;
    double sum;
    int part_count;              /* openings, then the surfaces of the room */
    struct pp_glare_part *parts; /* owned */
    struct pp_glare_sun sun;
};

/* Results of a view for a year. */
struct pp_glare_year {
    struct pp_annual_value above_h[PP_GLARE_LIMITS]; /* hours above each limit */
    double exceeded_in_5; /* DGP exceeded in 5 % of the occupied hours */
    double most;          /* greatest DGP in the occupied hours */
    int most_hour;        /* index of that hour in the year; -1: none */
    double sun_h;         /* occupied hours with the sun in the field of view */
    float *dgp;           /* DGP by sky; owned */
};

struct pp_glare_sheet {
    const struct pp_world *world;      /* not owned */
    const struct pp_world_view *views; /* not owned */
    int view_count;
    double threshold_cd_m2;
    bool is_year;
    bool has_devices;                /* a window has a blind, screen or curtain */
    struct pp_glare_moment *moments; /* by view; owned; NULL for a year */
    struct pp_glare_year *years;     /* by view; owned; NULL for a moment */
    struct pp_annual_sheet annual;   /* illuminances at the eyes, hours and sentences */
};

/* Level of EN 17037 5.4: "high", "medium", "minimum" or "none". At a level, the DGP
 * exceeds its limit (0.35, 0.40, 0.45) in at most 5 % of the occupied hours. */
const char *pp_glare_sheet_level(const struct pp_glare_year *year, double occupied_h);

/* State of blinds, screens and curtains, as a sentence without a full stop. */
const char *pp_glare_sheet_devices(const struct pp_glare_sheet *sheet);

void pp_glare_sheet_clear(struct pp_glare_sheet *sheet);

#endif
