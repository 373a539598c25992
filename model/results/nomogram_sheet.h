/* nomogram_sheet.h - a nomogram's scales with their marks, and what is read on it of a
 * room, for whoever draws it. */
#ifndef PP_MODEL_NOMOGRAM_SHEET_H
#define PP_MODEL_NOMOGRAM_SHEET_H

#include "model/results/mark_rank.h"
#include "model/results/nomogram.h"

struct pp_nomogram_mark {
    double y;      /* of the scales' height, from the bottom */
    double number; /* as it is printed: per cent, degrees, or the value itself */
    enum pp_mark_rank rank;
};

struct pp_nomogram_scale {
    int count;
    struct pp_nomogram_mark *marks; /* owned */
};

/* An opening, with those that read and count like it. */
struct pp_nomogram_window {
    int line;  /* of the room file, of the first */
    int alike; /* how many there are */
    struct pp_nomogram_reading read;
    double y[PP_NOMOGRAM_STEMS]; /* where the readings stand */
    double allowance;            /* for its glass, frame and dirt */
};

struct pp_nomogram_sheet {
    struct pp_nomogram nomogram;
    struct pp_nomogram_scale scales[PP_NOMOGRAM_STEMS];
    const char *name; /* the room's, or NULL; not owned */
    bool blank;       /* no room */
    int window_count;
    struct pp_nomogram_window *windows; /* owned */
    int left_out;       /* openings of the room that the nomogram is not made for */
    double decorations; /* D: what their deterioration leaves, of all windows */
    double component;   /* average of all windows, allowances settled */
    double minimum;     /* of II: the least of all windows; else NAN */
};

void pp_nomogram_sheet_clear(struct pp_nomogram_sheet *sheet);

#endif
