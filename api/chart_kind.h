/* chart_kind.h - list of all charts. A chart draws a room or a blank form on a canvas.
 *
 * A chart kind obtains its data from the studies and methods, and draws them with the
 * functions in charts/. To add a kind, write its source file, declare it here, and add
 * a line to chart_kind.c.
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

/* Value of a yes-or-no option; PP_UNSAID: the option is not given. */
enum pp_yes_no { PP_UNSAID, PP_YES, PP_NO };

struct pp_overlay_options {
    enum pp_lens lens;
    double diameter_mm;    /* diameter of the overlay; 0: the largest that fits on the
                            * sheet */
    bool said;             /* true if any of dots, cells and sun is given */
    bool dots, cells, sun; /* parts to draw */
    const char *typed;     /* last overlay option on the command line, for messages;
                            * NULL: none */
};

struct pp_board_options {
    enum pp_yes_no glazed;   /* blank form: allow for clear single glazing; default
                              * yes */
    bool fine;               /* pepper-pot diagram: each dot is worth 0.01 % */
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

    enum pp_nomogram_kind nomogram; /* nomogram to be drawn, from --which */
    bool nomogram_said;             /* true if nomogram is given */

    struct pp_slats slats; /* blind to be drawn if there is no room, from --slats */
    bool slats_said;       /* true if slats are given */

    bool unsolved; /* with a room: draw the diagram as an exercise, without its
                    * solution */

    struct pp_overlay_options overlay;
    double inclined_deg; /* Waldram diagram: angle to the window, in plan, of the edges
                          * whose droop lines are drawn */
    bool inclined;       /* true if inclined_deg is given */

    const char *window; /* name, wall or line of the window (choose_window.h), for
                         * kinds that show one window; NULL: the first one */
};

/* Options of a scale model. */
struct pp_model_options {
    double scale; /* denominator of the scale, 20 for 1:20; 0: not given */
    struct pp_mirror_box box;
    bool has_box;
    const char *typed; /* last model option on the command line, for messages; NULL:
                        * none */
};

/* Rooms of one file, each with its former state. */
struct pp_chart_site {
    const struct pp_study_room *rooms;
    const struct pp_study_room *const *before; /* former state of each room; NULL entry:
                                                * new room, or former state unknown */
    int count;
    double french_m; /* height of the reference point of French windows, m; see
                      * vertical_sky.h */
};

/* Options for the content of a chart. */
struct pp_chart_choice {
    struct pp_chart_site
        site;              /* rooms of the sheet, set for each sheet: a chart of a site
                            * shows all of them, a chart that compares states only the
                            * first */
    bool line_said;        /* plan: draw the lit area instead of contours */
    enum pp_lit_line line; /* boundary of the lit area, used if line_said is set */

    const struct pp_report *known; /* report whose averages are printed on the plan
                                    * instead of the plan's own; NULL: none; not
                                    * owned */
    struct pp_section_place cut;   /* position of the section, also marked on a plan */
    enum pp_section_scale scale;   /* scale of the daylight factors in a section */
    enum pp_plan_fill fill;        /* filling between the contours of a plan */
    struct pp_board_options board; /* for diagrams of the drawing board */
    struct pp_model_options model;
    struct pp_year_options availability;   /* light outside, for kinds that show it */
    const struct pp_moment_source *moment; /* plan: draw illuminances at this moment;
                                            * NULL: daylight factors; not owned */
};

struct pp_chart_kind {
    const char *name;    /* as typed on the command line */
    const char *summary; /* one line, without a full stop */
    bool board;          /* drawing-board diagram: can be blank, without a room */
    bool from_point;     /* drawing-board diagram for one point of a room */
    bool of_window;      /* shows one window, from --window, instead of points; with a
                          * room, --sky does not apply */
    bool outside;        /* shows outdoor daylight: needs no room */
    bool compares;       /* can also show a room's former state */
    bool of_site;        /* one sheet shows all rooms of a file */
    enum pp_paper paper; /* default paper */
    bool of_sun;         /* needs a latitude for sun paths */
    bool of_weather;     /* can also show hours of a weather file */
    bool of_year;        /* needs a weather file and a room */
    bool transparent;    /* overlay: no white background */

    bool landscape; /* true if the sheet is landscape for every room */
    bool (*landscape_for)(const struct pp_world *world); /* true if the sheet for this
                                                          * room is landscape; NULL:
                                                          * never landscape */

    /* Checks whether the kind can draw these methods (NULL: the default methods), or
     * simulated values if `simulate` is set. PP_BAD_INPUT: it cannot, and the message
     * gives the reason. A kind without this function can draw all methods. */
    enum pp_status (*check)(const char *methods, bool simulate, struct pp_error *err);

    /* Computes and draws the chart of the room (NULL: a blank form). May change the
     * room's points. If the simulation was stopped, *finished is set to false;
     * PP_INTERRUPTED is returned if there is nothing to draw. */
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

/* True if the sheet for this room is landscape. world NULL: blank form. */
bool pp_chart_kind_landscape(const struct pp_chart_kind *kind,
                             const struct pp_world *world);

#endif
