/* site_sheet.h - data of site drawings: the objects on the site, and the windows of its
 * rooms with their vertical sky component, in plan and in elevation.
 *
 * Lengths are in metres, in the building's axes (placement.h). Names are not owned; all
 * other data are.
 */
#ifndef PP_MODEL_RESULTS_SHEETS_SITE_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_SITE_SHEET_H

#include <stdbool.h>

#include "model/geometry/bounds.h"
#include "model/geometry/curve.h"
#include "model/geometry/region.h"
#include "model/geometry/vec.h"

/* Time when an object exists: before and at present, only before, or only at
 * present. */
enum pp_site_when { PP_SITE_ALWAYS, PP_SITE_GONE, PP_SITE_NEW };

/* A polygon outside, a part of a mesh, or a room's own floor. */
struct pp_site_shape {
    int count;
    struct pp_vec3 *corners;
    int *
        ends; /* index past the last corner of each ring; only a part of a mesh can have
                * several; NULL: one ring */
    int ring_count;
    bool *
        unseen; /* [i]: edge from corner i to i + 1 is not drawn; NULL: all are drawn */
    double top_m;     /* z of its highest corner */
    const char *name; /* name of the object that it belongs to; NULL: none */
    enum pp_site_when when;
    bool is_room;  /* floor of a room */
    bool is_level; /* not vertical: it covers an area in plan */
};

/* A vertical window. */
struct pp_site_window {
    struct pp_vec3 from,
        to; /* its lower corners, left and right as seen from outside */
    double height_m;
    struct pp_vec3 out;       /* unit, horizontal, away from the room */
    double component, before; /* vertical sky component; before NAN: not known */
    const char *name;         /* NULL: no name */
    const char *label;        /* name, or W1, W2 ... by its place in the file */
    const char *room;         /* name of its room; NULL: it has none */
    int room_at, face;        /* its room in the list of rooms, and the face it is in */
    int line;
    int storey; /* number of windows below it in the same wall */
};

/* A garden, and its area without two hours of sun on 21 March. */
struct pp_site_garden {
    int count;
    double (*corners)[2];
    struct pp_curve_list dark;
    double share;     /* share with two hours of sun or more; NAN: no latitude */
    const char *name; /* NULL: no name */
};

/* A tree and its crown. */
struct pp_site_tree {
    struct pp_vec3 foot;           /* on the ground */
    double crown_base_m, height_m; /* above the ground */
    double crown_width_m;          /* diameter */
    double transmittance;          /* with leaves */
    double winter_transmittance;   /* without leaves */
    enum pp_site_when when;
};

/* A part of a plot, and the permissible height on it; 0: no building. */
struct pp_site_cell {
    double corners[4][2];
    double height_m;
};

struct pp_site_sheet {
    const char *title;
    double north_rad; /* bearing of +y */
    bool has_before;  /* true if any window has a value `before` */
    double french_m;  /* windows down to the floor: height of their reference point
                      * above the floor; 0: their centre */
    double ground_m;  /* z of the ground */
    struct pp_site_shape *shapes; /* ascending by height */
    int shape_count;
    struct pp_site_window *windows;
    int window_count;
    struct pp_site_garden *gardens;
    int garden_count;
    struct pp_site_tree *trees;
    int tree_count;
    struct pp_site_cell *cells; /* cells of the plot that is drawn; NULL: none */
    int cell_count;
    double cells_m3; /* total volume of the cells */
};

void pp_site_sheet_clear(struct pp_site_sheet *sheet);
void pp_site_sheet_clear_shape(struct pp_site_shape *shape);

/* Vertical sky components (fractions, ascending) at which the advice on windows changes
 * [BR209]. */
enum { PP_SITE_LEVELS = 3 };
extern const double pp_site_sheet_levels[PP_SITE_LEVELS];

/* An outer wall in elevation: u runs to the right seen from outside, from the sheet's
 * origin; v is z. */
struct pp_elevation_wall {
    const char *room;  /* name of its room; NULL: it has none */
    int room_at, face; /* its room in the list of rooms, and its face */
    double front_m;    /* position of its inner face along the direction it faces */
    struct pp_region outline;
    struct pp_curve_list below; /* areas below each level, as in pp_daylight_plan;
                                 * each curve has its level */
    struct pp_curve_list lines; /* contours of the levels */
    struct pp_bounds2 *doors;   /* in u and v */
    int door_count;
};

/* Walls of a site that face the same way and do not hide each other. */
struct pp_site_elevation {
    struct pp_vec3 out, right; /* unit, level */
    int layer;                 /* 0: the walls in front; 1 and more: walls behind */
    double bearing_rad;        /* bearing that the walls face, clockwise from north,
                                * 0 to 2 pi */
    struct pp_elevation_wall *walls;
    int wall_count;
    struct pp_bounds2 *facades; /* in u and v; drawn behind the walls */
    int facade_count;
    struct pp_bounds2 *shades; /* parts of balconies and other shades of windows */
    int shade_count;
    int *windows; /* indices of windows in `site` */
    int window_count;
    struct pp_bounds2
        *crowns; /* of the trees in front of the walls, in u and v; foremost first */
    int *crown_trees; /* their indices in `site` */
    int crown_count;
    double low[2], high[2]; /* extent in u and v, including the ground */
};

struct pp_elevation_sheet {
    struct pp_site_sheet site;
    struct pp_site_elevation *elevations; /* clockwise from north, then by layer */
    int count;
};

void pp_site_sheet_clear_elevations(struct pp_elevation_sheet *sheet);

#endif
