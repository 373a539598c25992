/* protractor_sheet.h - a protractor's scales, and the readings of a room on them.
 *
 * Angles in section are altitudes: 0 on the horizon in front of the opening, pi/2 at
 * the zenith, pi behind. Angles in plan are measured from the normal to the opening,
 * positive to the right seen from inside. The plan may be rotated into the plane of the
 * average sight line.
 */
#ifndef PP_MODEL_RESULTS_PROTRACTOR_SHEET_H
#define PP_MODEL_RESULTS_PROTRACTOR_SHEET_H

#include "model/results/nomogram_sheet.h"
#include "model/room/world.h"

/* Readings for one rectangle of an opening, step by step. */
struct pp_protractor_reading {
    bool hidden;          /* true for an obstruction, false for sky */
    double factor;        /* luminance factor of sky (1) or obstruction */
    double edge_rad[2];   /* altitudes of lower and upper edge in the section */
    double share[2];      /* readings of the primary scale for the edges */
    double initial;       /* upper less lower reading, for an endless opening */
    double average_rad;   /* altitude, mean of both edges */
    double jamb_rad[2];   /* left and right jamb, in plan */
    double correction[2]; /* readings of the auxiliary scale for the jambs; negative
                           * left of the normal */
    double width_factor;  /* reading for the right jamb less that for the left */
    double component;     /* initial x width_factor x factor */
};

/* Readings for one opening from one point. */
struct pp_protractor_readings {
    int count;
    struct pp_protractor_reading *list; /* owned */
    struct pp_vec3 along, out;          /* unit, horizontal: in plan along the
                                         * opening, and outwards */
    double distance_m;                  /* of the point from the opening's plane */
    double slope_rad;     /* slope of that plane: atan2(out, z) of its outward normal */
    double sky, external; /* sums, before allowances */
    bool less_hidden;     /* sky is the first reading less all further ones */
};

void pp_protractor_sheet_readings_clear(struct pp_protractor_readings *readings);

/* A mark on the primary scale. */
struct pp_protractor_mark {
    double angle_rad;
    double share; /* a multiple of 0.1 %, as a fraction */
    enum pp_mark_rank rank;
};

/* A line on the auxiliary scale: jamb angles with one correction factor, at average
 * altitudes in steps of PP_PROTRACTOR_LINE_STEP_RAD. */
struct pp_protractor_line {
    double factor;
    int count;
    double *jamb_rad;
};

struct pp_protractor_scale {
    int number;     /* 1 to 10; 0: not published */
    char sky[48];   /* "CIE overcast sky" */
    char glass[96]; /* "vertical, clear single glass" */
    double slope_rad;
    double range_rad;        /* end of the primary scale */
    double whole;            /* reading at that end, a fraction */
    bool turned_down;        /* the auxiliary scale is for the plan rotated into the
                              * sight line */
    bool symmetric;          /* average altitudes over 90 degrees are read as 180
                              * degrees less altitude */
    double last_average_rad; /* end of the auxiliary scale */
    int mark_count;
    struct pp_protractor_mark *marks; /* ascending; owned */
    int line_count;
    struct pp_protractor_line *lines; /* ascending factors, above 0; owned */
};

/* A protractor alone, or with the readings for a room at one point. */
struct pp_protractor_sheet {
    const struct pp_world *world; /* NULL: a protractor alone; not owned */
    struct pp_vec3 point;
    const struct pp_opening *opening;   /* opening that is read; not owned */
    int others;                         /* number of further openings of the room */
    struct pp_protractor_readings read; /* readings for `opening` */
    double allowance;                   /* factor for glass, frame and dirt */
    struct pp_protractor_scale scale;
};

#define PP_PROTRACTOR_LINE_STEP_RAD (2.5 * PP_RAD)

void pp_protractor_sheet_scale_clear(struct pp_protractor_scale *scale);
void pp_protractor_sheet_clear(struct pp_protractor_sheet *sheet);

#endif
