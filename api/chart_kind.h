/* chart_kind.h - list of all charts. Each chart draws a room, or a blank form, on a
 * canvas.
 *
 * A chart kind computes its data by studies and methods and draws them with functions
 * of charts/. A new kind needs a file of its own, a declaration here, and a line in
 * chart_kind.c.
 */
#ifndef PP_API_CHART_KIND_H
#define PP_API_CHART_KIND_H

#include <stdbool.h>

#include "charts/room/plan_chart.h"
#include "charts/section/section_chart.h"
#include "charts/sheet/canvas.h"
#include "model/geometry/lens.h"
#include "model/light/glass.h"
#include "model/light/mirror_box.h"
#include "model/light/slats/slats.h"
#include "model/light/sky.h"
#include "model/results/lit_area.h"
#include "model/results/nomogram_sheet.h"
#include "studies/climate/year_light.h"
#include "studies/section_line.h"
#include "studies/study_options.h"
#include "studies/study_room.h"
#include "studies/year/moment.h"

/* Value of a yes-or-no option; PP_UNSAID: not given. */
enum pp_yes_no { PP_UNSAID, PP_YES, PP_NO };

struct pp_overlay_options {
    enum pp_lens lens;
    double diameter_mm;    /* 0: the largest that fits on the sheet */
    bool said;             /* true if any of dots, cells and sun is given */
    bool dots, cells, sun; /* parts to draw */
    const char *typed;     /* last of these options as typed; NULL: none */
};

struct pp_board_options {
    enum pp_yes_no glazed;   /* blank form: clear single glazing; default yes */
    bool fine;               /* pepper-pot diagram: dots of 0.01 % */
    enum pp_yes_no vertical; /* vertical receiver of a blank pepper-pot diagram;
                              * default no */
    double viewing_mm;       /* pepper-pot diagram: distance from eye to drawing; 0:
                              * 30 mm, or 60 mm if fine */
    struct pp_sky sky;       /* sky of a blank form; set by the caller */
    struct pp_sky_picture *picture; /* photograph of the sky; reference held; NULL:
                                     * none */

    int number;          /* number of a published protractor, 1 to 10; 0: not given */
    const char *glazing; /* glazing of the protractor by name, or "none"; NULL: not
                          * given */
    double slope_deg;    /* slope of that glazing, from --slope */
    bool slope_said;     /* true if slope_deg is given */
    bool any_protractor; /* use glass and slope_rad below in place of a published
                          * protractor; set by pp_board_options_check */
    struct pp_glass glass;
    double slope_rad;
    char glass_words[72];

    enum pp_nomogram_kind nomogram; /* from --which */
    bool nomogram_said;             /* true if nomogram is given */

    struct pp_slats slats; /* slats: of a blind without a room */
    bool slats_said;       /* true if slats are given */

    bool unsolved; /* diagram for a point of a room: draw the exercise, not its
                    * solution */

    struct pp_overlay_options overlay;
    double inclined_deg; /* Waldram: droop lines of edges at this angle in plan */
    bool inclined;       /* true if inclined_deg is given */

    const char *window; /* window by its line or wall, for kinds that show one; NULL:
                         * the first vertical window */
};

/* Options of a scale model. */
struct pp_model_options {
    double scale; /* denominator of the scale, 20 for 1:20; 0: not given */
    struct pp_mirror_box box;
    bool has_box;
    const char *typed; /* last of these options as typed; NULL: none */
};

/* Rooms of one file, each with its former state. */
struct pp_chart_site {
    const struct pp_study_room *rooms;
    const struct pp_study_room *const *before; /* one for each room; NULL: new room, or
                                                * former state unknown */
    int count;
    double french_m; /* French windows: point height, m; see vertical_sky.h */
};

/* Options for the content of a chart. */
struct pp_chart_choice {
    struct pp_chart_site
        site;              /* for kinds that compare states (the first room is drawn) or
                            * draw a site (all rooms are drawn); set for each sheet */
    bool line_said;        /* plan: lit area instead of contours */
    enum pp_lit_line line; /* boundary of the lit area, if line_said */

    const struct pp_report *known; /* the room's averages, which a plan prints in place
                                    * of its own; NULL: not known; not owned */
    struct pp_section_place cut;   /* place of a section, and of its mark on a plan */
    enum pp_section_scale scale;   /* scale of the daylight factors in a section */
    enum pp_plan_fill fill;        /* filling between the contours of a plan */
    struct pp_board_options board; /* for diagrams of the drawing board */
    struct pp_model_options model;
    struct pp_year_options availability;   /* for kinds that show light outside */
    const struct pp_moment_source *moment; /* plan: illuminances at this moment; NULL:
                                            * daylight factors; not owned */
};

struct pp_chart_kind {
    const char *name;    /* as typed on the command line */
    const char *summary; /* one line, without a full stop */
    bool board;          /* drawing-board diagram: can be blank, without a room */
    bool from_point;     /* drawing-board diagram for one point of a room */
    bool of_window;      /* drawing-board diagram for one window under the overcast
                          * sky */
    bool outside;        /* shows light outside: needs no room */
    bool compares;       /* can show a room's former state too */
    bool of_site;        /* one sheet shows all rooms of a file */
    enum pp_paper paper; /* default paper */
    bool of_sun;         /* needs a latitude for sun paths */
    bool of_weather;     /* can also show hours of a weather file */
    bool of_year;        /* needs a weather file and a room */
    bool transparent;    /* overlay: no white background */

    bool landscape; /* the sheet is always landscape */
    bool (*landscape_for)(const struct pp_world *world); /* by room; NULL: never */

    /* Checks whether the kind can draw these methods (NULL: default), or the simulation
     * if simulate is set. PP_BAD_INPUT lists the methods it can draw. NULL function:
     * all methods. */
    enum pp_status (*check)(const char *methods, bool simulate, struct pp_error *err);

    /* Computes and draws the chart of the room (NULL: a blank form); may change the
     * room's points. If the simulation was stopped: sets *finished to false, or returns
     * PP_INTERRUPTED if there is nothing to draw. */
    enum pp_status (*draw)(struct pp_canvas *canvas, struct pp_study_room *room,
                           const struct pp_study_options *study,
                           const struct pp_chart_choice *choice, bool *finished,
                           struct pp_error *err);
};

extern const struct pp_chart_kind pp_draw_section, pp_draw_plan, pp_draw_site_plan,
    pp_draw_elevation, pp_draw_note, pp_draw_waldram, pp_draw_pepper_pot,
    pp_draw_protractor, pp_draw_nomogram, pp_draw_position_nomogram, pp_draw_brs_table,
    pp_draw_vertical_sky, pp_draw_skylight_indicator, pp_draw_overlay, pp_draw_sun_path,
    pp_draw_slats, pp_draw_model_net, pp_draw_availability, pp_draw_year,
    pp_draw_en17037;

/* Chart kinds in list order; NULL for the first index past the end. */
const struct pp_chart_kind *pp_chart_kind_at(int index);

/* Chart kind of that name; NULL if there is none. */
const struct pp_chart_kind *pp_chart_kind_find(const char *name);

/* True if the sheet of this room (NULL: blank form) is landscape. */
bool pp_chart_kind_landscape(const struct pp_chart_kind *kind,
                             const struct pp_world *world);

#endif
