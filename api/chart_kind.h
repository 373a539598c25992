/* chart_kind.h - list of all charts: each draws a room, or a blank, on a canvas.
 *
 * A kind computes its data by studies and methods and draws them by a chart of charts/.
 * A new one is a file of its own, its entry declared here, and a line in chart_kind.c.
 */
#ifndef PP_API_CHART_KIND_H
#define PP_API_CHART_KIND_H

#include <stdbool.h>

#include "charts/room/plan_chart.h"
#include "charts/room/section_chart.h"
#include "charts/sheet/canvas.h"
#include "model/geometry/lens.h"
#include "model/light/glass.h"
#include "model/light/mirror_box.h"
#include "model/light/sky.h"
#include "model/results/lit_area.h"
#include "model/results/nomogram_sheet.h"
#include "studies/climate/year_light.h"
#include "studies/study_options.h"
#include "studies/study_room.h"

/* Tri-state choice of what a diagram shows. */
enum pp_yes_no { PP_UNSAID, PP_YES, PP_NO };

struct pp_overlay_options {
    enum pp_lens lens;
    double diameter_mm;    /* 0: as large as the sheet allows */
    bool said;             /* are these: */
    bool dots, cells, sun; /* parts that are drawn */
    const char *typed;     /* the last of these options as typed; NULL: none */
};

struct pp_board_options {
    enum pp_yes_no glazed;   /* a blank: with clear single glass? unsaid: yes */
    bool fine;               /* pepper-pot: dots worth 0.01 % */
    enum pp_yes_no vertical; /* a blank pepper-pot's receiver; unsaid: no */
    double viewing_mm; /* pepper-pot: from the eye to the drawing; 0: 30, fine 60 */
    struct pp_sky sky; /* of a blank; set by the caller, */
    struct pp_sky_picture *picture; /* and its photograph, held; NULL: it has none */

    int number;          /* a blank protractor of the ten; 0: not said */
    const char *glazing; /* or of any glazing, "none" too; NULL: not said */
    double slope_deg;    /* of that glazing, by --slope, */
    bool slope_said;     /* if it was */
    bool any_protractor; /* not one of the ten by number but the one described below;
                          * set by pp_board_options_check */
    struct pp_glass glass;
    double slope_rad;
    char glass_words[72];

    enum pp_nomogram_kind nomogram; /* by --which, */
    bool nomogram_said;             /* if it was */

    bool unsolved; /* of kinds from a point: the exercise in place of its solution */

    struct pp_overlay_options overlay;
    double inclined_deg; /* Waldram: droop lines of edges at that angle in plan, */
    bool inclined;       /* if it was said */

    const char *window; /* of kinds that are of one, by line or wall; NULL: the first
                         * upright one */
};

/* Options of a scale model. */
struct pp_model_options {
    double scale; /* 20 for 1:20; 0: not said */
    struct pp_mirror_box box;
    bool has_box;
    const char *typed; /* the last of these options as typed; NULL: none */
};

/* Rooms of one file, each with its former state. */
struct pp_chart_site {
    const struct pp_study_room *rooms;
    const struct pp_study_room *const *before; /* as many; NULL: it was not there, or
                                                * nothing is known of it */
    int count;
    double french_m; /* as a site's rooms' (site_study.h) */
};

/* Choices for the content of a chart. */
struct pp_chart_choice {
    struct pp_chart_site
        site;              /* for kinds that compare states or draw a site: the first
                            * room or all rooms are drawn; set for each sheet */
    bool line_said;        /* plan: not contours but the part that is lit, by */
    enum pp_lit_line line; /* this */

    enum pp_section_scale scale;   /* section: of the daylight factors */
    enum pp_plan_fill fill;        /* plan: between the contours */
    struct pp_board_options board; /* of kinds worked at the drawing board */
    struct pp_model_options model;
    struct pp_year_options availability; /* for kinds of the light outside */
};

struct pp_chart_kind {
    const char *name;    /* as typed on the command line */
    const char *summary; /* one line, without a full stop */
    bool board;          /* worked at the drawing board: can be blank, without a room */
    bool from_point;     /* and is drawn from one point of a room */
    bool of_window;      /* or for one window of a room, under the overcast sky */
    bool outside;        /* draws the light outside: needs no room */
    bool compares;       /* can draw a room's former state as well */
    bool of_site;        /* one sheet for all rooms of a file */
    enum pp_paper paper; /* default paper */
    bool of_sun;         /* takes a latitude, for the sun's paths */
    bool of_year;        /* needs a weather file and a room */
    bool transparent;    /* is laid on something: has no white ground */

    bool landscape; /* its sheet always lies on its side */
    bool (*landscape_for)(const struct pp_world *world); /* or does so for some rooms;
                                                          * NULL: for none */

    /* Checks whether the kind can draw these methods (NULL: its own choice), or the
     * simulation if simulate is set. PP_BAD_INPUT names the ones it can. NULL function:
     * all. */
    enum pp_status (*check)(const char *methods, bool simulate, struct pp_error *err);

    /* Computes and draws the chart of the room (NULL: a blank); may change the room's
     * points. Sets *finished to false if the simulation was stopped. */
    enum pp_status (*draw)(struct pp_canvas *canvas, struct pp_study_room *room,
                           const struct pp_study_options *study,
                           const struct pp_chart_choice *choice, bool *finished,
                           struct pp_error *err);
};

extern const struct pp_chart_kind pp_draw_section, pp_draw_plan, pp_draw_site_plan,
    pp_draw_elevation, pp_draw_note, pp_draw_waldram, pp_draw_pepper_pot,
    pp_draw_protractor, pp_draw_nomogram, pp_draw_position_nomogram, pp_draw_brs_table,
    pp_draw_vertical_sky, pp_draw_skylight_indicator, pp_draw_overlay, pp_draw_sun_path,
    pp_draw_model_net, pp_draw_availability, pp_draw_year;

/* Chart kinds in list order; NULL for the index just past the end of the list. */
const struct pp_chart_kind *pp_chart_kind_at(int index);

/* The kind of that name, or NULL. */
const struct pp_chart_kind *pp_chart_kind_find(const char *name);

/* Does the kind look better on a sheet that lies on its side for this room (NULL: for a
 * blank)? */
bool pp_chart_kind_landscape(const struct pp_chart_kind *kind,
                             const struct pp_world *world);

#endif
