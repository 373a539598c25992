/* protractor_sheet.h - a protractor's scales, and the readings of a room on them.
 *
 * Angles of the section are altitudes, from 0 on the horizon in front of the opening
 * over pi/2 at the zenith to pi behind. Angles of the plan are from the normal to the
 * opening, to the right positive seen from inside; on a plan turned down into the plane
 * of the average sight line too.
 */
#ifndef PP_MODEL_RESULTS_PROTRACTOR_SHEET_H
#define PP_MODEL_RESULTS_PROTRACTOR_SHEET_H

#include "model/results/nomogram_sheet.h"
#include "model/room/world.h"

/* One rectangle of an opening, read step by step. */
struct pp_protractor_reading {
    bool hidden;          /* an obstruction, or sky? */
    double factor;        /* luminance factor of sky (1) or obstruction */
    double edge_rad[2];   /* section altitudes of the lower and upper edge */
    double share[2];      /* primary scale there */
    double initial;       /* their difference: of an endless opening */
    double average_rad;   /* altitude, mean of both edges' */
    double jamb_rad[2];   /* left and right, on the plan */
    double correction[2]; /* auxiliary scale there; negative left of the normal */
    double width_factor;  /* right less left: their sum for jambs on both sides */
    double component;     /* initial x width_factor x factor */
};

/* The readings of one opening from one point. */
struct pp_protractor_readings {
    int count;
    struct pp_protractor_reading *list; /* owned */
    struct pp_vec3 along, out;          /* unit, level: of plan and section */
    double distance_m;                  /* from the point to the opening's plane */
    double slope_rad;     /* of that plane: atan2(out, z) of its normal outwards */
    double sky, external; /* sums, before allowances */
    bool less_hidden;     /* sky is the first reading less the obstructions' */
};

void pp_protractor_sheet_readings_clear(struct pp_protractor_readings *readings);

/* A mark on the primary scale. */
struct pp_protractor_mark {
    double angle_rad;
    double share; /* a fraction, a multiple of 0.1 % */
    enum pp_mark_rank rank;
};

/* A line on the auxiliary scale: one correction factor over average altitudes that are
 * PP_PROTRACTOR_LINE_STEP_RAD apart. */
struct pp_protractor_line {
    double factor;
    int count;
    double *jamb_rad;
};

struct pp_protractor_scale {
    int number;     /* 1 to 10; 0: never published */
    char sky[48];   /* "CIE overcast sky" */
    char glass[96]; /* "vertical, clear single glass" */
    double slope_rad;
    double range_rad;        /* the end of the primary scale */
    double whole;            /* its reading there, a fraction */
    bool turned_down;        /* the auxiliary is laid on the plan turned down */
    bool symmetric;          /* average altitudes over 90 degrees read as 180 less */
    double last_average_rad; /* of the auxiliary */
    int mark_count;
    struct pp_protractor_mark *marks; /* ascending; owned */
    int line_count;
    struct pp_protractor_line *lines; /* ascending factors over 0; owned */
};

/* A protractor by itself, or laid on a room at one point. */
struct pp_protractor_sheet {
    const struct pp_world *world; /* NULL: by itself; not owned */
    struct pp_vec3 point;
    const struct pp_opening *opening;   /* that is read; not owned */
    int others;                         /* further openings of the room */
    struct pp_protractor_readings read; /* of that opening */
    double allowance;                   /* for its glass, frame and dirt */
    struct pp_protractor_scale scale;
};

#define PP_PROTRACTOR_LINE_STEP_RAD (2.5 * PP_RAD)

void pp_protractor_sheet_scale_clear(struct pp_protractor_scale *scale);
void pp_protractor_sheet_clear(struct pp_protractor_sheet *sheet);

#endif
