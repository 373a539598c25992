/* site_sheet.h - data of site drawings: the objects on the site, and the windows of its
 * rooms with their vertical sky component, seen from above and at right angles to the
 * walls.
 *
 * Lengths are metres of the building's axes (placement.h). Names are not owned; all
 * else is the sheet's.
 */
#ifndef PP_MODEL_RESULTS_SHEETS_SITE_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_SITE_SHEET_H

#include <stdbool.h>

#include "model/geometry/bounds.h"
#include "model/geometry/curve.h"
#include "model/geometry/region.h"
#include "model/geometry/vec.h"

/* States in which an object exists: both, only before, or only now. */
enum pp_site_when { PP_SITE_ALWAYS, PP_SITE_GONE, PP_SITE_NEW };

/* A polygon that stands outside, a part of a mesh, or a room's own floor. */
struct pp_site_shape {
    int count;
    struct pp_vec3 *corners;
    int *
        ends; /* of a part of a mesh, which has several rings: past the last corner of each;
                * NULL: the corners are one ring */
    int ring_count;
    bool *
        unseen; /* true: the edge from a corner to the next is no line; NULL: all are lines */
    double top_m;     /* z of its highest corner */
    const char *name; /* of the thing that it is a side of; NULL: none */
    enum pp_site_when when;
    bool is_room;  /* a floor of a room */
    bool is_level; /* not upright: it covers something, seen from above */
};

/* An upright window. */
struct pp_site_window {
    struct pp_vec3 from,
        to; /* its lower corners, left and right as seen from outside */
    double height_m;
    struct pp_vec3 out;       /* unit, level, away from the room */
    double component, before; /* vertical sky component; before NAN: not known */
    const char *name;         /* NULL: it has none */
    int line;
    int storey; /* how many windows stand below it, in the same wall and place */
};

/* A garden, and the part of it that has less than two hours of sun on 21 March. */
struct pp_site_garden {
    int count;
    double (*corners)[2];
    struct pp_curve_list dark;
    double share;     /* that has two hours or more; NAN: no latitude is known */
    const char *name; /* NULL: it has none */
};

/* A part of a plot, and how high may be built on it: 0 where nothing may stand. */
struct pp_site_cell {
    double corners[4][2];
    double height_m;
};

struct pp_site_sheet {
    const char *title;
    double north_rad; /* bearing of +y */
    bool has_before;  /* of any window */
    double french_m; /* height above the floor where the component of windows down to it
                      * is taken; 0: at their middle */
    double ground_m; /* z of the ground */
    struct pp_site_shape *shapes; /* from low to high */
    int shape_count;
    struct pp_site_window *windows;
    int window_count;
    struct pp_site_garden *gardens;
    int garden_count;
    struct pp_site_cell *cells; /* of the plot that the drawing is about; NULL: none */
    int cell_count;
    double cells_m3; /* total volume of the cells */
};

void pp_site_sheet_clear(struct pp_site_sheet *sheet);
void pp_site_sheet_clear_shape(struct pp_site_shape *shape);

/* The vertical sky components at which the advice on windows changes [BR209]: fractions,
 * ascending. */
enum { PP_SITE_LEVELS = 3 };
extern const double pp_site_sheet_levels[PP_SITE_LEVELS];

/* An outer wall, flattened: u runs to the right as seen from outside, from the sheet's
 * origin; v up, from z = 0. */
struct pp_elevation_wall {
    struct pp_region outline;
    struct pp_curve_list below; /* the parts below each level, as in pp_daylight_plan;
                                 * every one has its level */
    struct pp_curve_list lines; /* of the levels */
    struct pp_bounds2 *doors;   /* by u and v */
    int door_count;
};

/* The walls of a site that look the same way. */
struct pp_site_elevation {
    struct pp_vec3 out, right; /* unit, level */
    double bearing_rad;        /* in which it looks, clockwise from north, 0 to 2 pi */
    struct pp_elevation_wall *walls;
    int wall_count;
    int *windows; /* of the site's sheet: which are in it */
    int window_count;
    double low[2], high[2]; /* u and v: its extent, with the ground */
};

struct pp_elevation_sheet {
    struct pp_site_sheet site;
    struct pp_site_elevation *elevations; /* clockwise from north */
    int count;
};

void pp_site_sheet_clear_elevations(struct pp_elevation_sheet *sheet);

#endif
