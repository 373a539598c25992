/* en17037_sheet.h - a room's assessment by the four parts of EN 17037, in words, as
 * drawn on one page. */
#ifndef PP_MODEL_RESULTS_SHEETS_EN17037_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_EN17037_SHEET_H

#include <stdbool.h>

#include "model/room/world.h"

enum {
    PP_EN17037_PARTS = 5, /* daylight provision has two methods */
    PP_EN17037_ROWS = 12,
    PP_EN17037_MAPS = 2
};

/* One line of a part: a requirement, or a result for information. */
struct pp_en17037_row {
    char what[128], figure[64], wanted[64], over[32], verdict[32];
    bool decides; /* true if the verdict is on the minimum level */
};

struct pp_en17037_part {
    const char *title; /* short; not owned */
    char level[48];    /* "minimum", "none, perhaps minimum", "not assessed" */
    int reached;       /* 0 none to 3 high; -1: not assessed */
    struct pp_en17037_row rows[PP_EN17037_ROWS];
    int row_count;
    char basis[1600]; /* calculation, assumptions and notes; "" if there are none */
};

/* Illuminances reached in half of the daylight hours, at points of the plane. */
struct pp_en17037_map {
    const char *title;                   /* not owned */
    const struct pp_receiver *receivers; /* not owned */
    int count;                           /* 0: no map */
    double *lux;                         /* by receiver; owned by the maker */
};

struct pp_en17037_sheet {
    const struct pp_world *world; /* not owned */
    const char *place;            /* the site and its climate, in words; not owned */
    struct pp_en17037_part parts[PP_EN17037_PARTS];
    int part_count;
    struct pp_en17037_map maps[PP_EN17037_MAPS];
    char room[640]; /* assumptions on the room */
};

#endif
