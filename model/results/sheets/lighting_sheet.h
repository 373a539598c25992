/* lighting_sheet.h - electric lighting with a daylight control in a year, as printed.
 *
 * studies/lighting/ fills it. Shares of energy are relative to all lamps at full power
 * in all occupied hours.
 */
#ifndef PP_MODEL_RESULTS_SHEETS_LIGHTING_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_LIGHTING_SHEET_H

#include <stdbool.h>

#include "model/results/sheets/annual_value.h"

enum { PP_LIGHTING_CONTROLS_MOST = 8 };

enum pp_lighting_kind {
    PP_LIGHTING_ON_OFF,  /* photoelectric switching of all lamps */
    PP_LIGHTING_STEPPED, /* photoelectric switching in equal steps */
    PP_LIGHTING_DIMMED,  /* lamps supply the missing light */
    PP_LIGHTING_MANUAL,  /* occupants switch on at arrival and off at departure */
};

struct pp_lighting_control {
    enum pp_lighting_kind kind;
    double target_lx;       /* illuminance to maintain; not used by manual */
    double differential_lx; /* on-off: off at target + differential */
    int steps;              /* stepped: number of equal groups of lamps */
    double residual_light;  /* dimmed: lowest output, share of full light */
    double residual_power;  /* dimmed: share of full power at that output */
    bool switches_off;      /* dimmed: off if the residual light is not needed */
    double power_w;         /* installed power; NAN: not given */
    double power_w_m2;      /* installed power per floor area; NAN: not given */
    int point;              /* number of the control point, from 1; 0: the darkest point
                             * of each hour */
    bool with_blinds;       /* blinds as in LM-83; otherwise always open */
};

/* Results of a control; hours are occupied hours. */
struct pp_lighting_figures {
    struct pp_annual_value saved;  /* energy saved, relative to lamps always on */
    struct pp_annual_value used_h; /* hours at full power with the same energy */
    struct pp_annual_value on_h;   /* hours with lamps on; expected value for manual */
    struct pp_annual_value
        saved_by_means;               /* `saved` from hourly means; equal to `saved`
                                            * unless records are shorter than an hour */
    struct pp_annual_value misjudged; /* saved_by_means - saved */
};

enum {
    PP_LIGHTING_FIGURES =
        sizeof(struct pp_lighting_figures) / sizeof(struct pp_annual_value)
};

/* The saving according to EN 15193:2007 (studies/lighting/en15193.h). */
struct pp_lighting_standard {
    const char *why;         /* reason why there is no saving; NULL: there is one */
    double depth_m, width_m; /* size of the daylight zone */
    double factor;           /* D_C, daylight factor of openings without glass */
    int class;               /* 0 none, 1 weak, 2 medium, 3 strong */
    double supply, control;  /* F_D,S and F_D,C */
    double saved;            /* F_D,S x F_D,C x the zone's share of the floor */
};

struct pp_lighting_sheet {
    struct pp_lighting_control control; /* both powers given, or both NAN */
    struct pp_lighting_figures figures;
    struct pp_annual_value
        *points;                 /* [receiver]: `saved` if it were the control point */
    struct pp_annual_value mean; /* mean of points */
    struct pp_lighting_standard standard;
    float *fraction; /* [record]: mean share of the installed power */
};

#endif
