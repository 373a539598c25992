/* nomogram_sheet.h - the stems of a nomogram, how much a mark on them stands out, and a
 * sheet of one: its stems, with the readings of a room if it has one. */
#ifndef PP_MODEL_RESULTS_NOMOGRAM_SHEET_H
#define PP_MODEL_RESULTS_NOMOGRAM_SHEET_H

#include <stdbool.h>

#include "model/results/formula.h"

/* Prominence of a mark of a scale. */
enum pp_mark_rank { PP_MARK_FINE, PP_MARK_MIDDLE, PP_MARK_LABELLED };

/* ---- the nomogram ----
 *
 * A nomogram is a chart of upright scales on which a straight-edge does a sum. A stem
 * is a scale on an upright line. Places on the sheet are fractions of its width and of
 * the scales' height, x from the left, y from the bottom. A method sets them out
 * (methods/nomogram/nomogram_scale.h), where the derivation stands; a chart draws them.
 */

enum pp_nomogram_kind {
    PP_NOMOGRAM_AVERAGE,   /* I: average component of a side-lit room */
    PP_NOMOGRAM_MINIMUM,   /* II: its minimum, too */
    PP_NOMOGRAM_ROOFLIGHT, /* III: average of a top-lit room */
    PP_NOMOGRAM_POSITION,  /* IV: at a point of a side-lit room */
    PP_NOMOGRAMS,
};

enum pp_nomogram_quantity {
    PP_NOMOGRAM_GLASS,       /* net glass over all inside surfaces: a ratio */
    PP_NOMOGRAM_REFLECTANCE, /* mean, of all inside surfaces */
    PP_NOMOGRAM_COMPONENT,   /* internally reflected, over Eh */
    PP_NOMOGRAM_OBSTRUCTION, /* altitude of the obstruction, radians */
    PP_NOMOGRAM_SLOPE,       /* of the glass, 0 horizontal, radians */
    PP_NOMOGRAM_WALLS,       /* mean reflectance of the walls */
    PP_NOMOGRAM_LOSS,        /* mean reflectance R, by 1/(1 - R) */
    PP_NOMOGRAM_GAIN,        /* glass over losses, W/(A (1 - R)): a ratio */
    PP_NOMOGRAM_LIGHT,       /* on the glass, as it counts, over Eh */
    PP_NOMOGRAM_FACTOR,      /* of the place of a point */
    PP_NOMOGRAM_PLACE,       /* of a point: its share of the depth or half breadth */
};

struct pp_nomogram_stem {
    char letter; /* 'A' */
    enum pp_nomogram_quantity quantity;
    double x;
    double foot, decade; /* y = foot + decade log10 of the quantity's function */
    double low, high;    /* the lowest and the highest value on it */
};

/* A straight-edge from one stem to another, and the stem read between them. */
struct pp_nomogram_edge {
    int from, to, read;
};

enum { PP_NOMOGRAM_STEMS = 8, PP_NOMOGRAM_EDGES = 3 };

struct pp_nomogram {
    enum pp_nomogram_kind kind;
    double k;      /* the rule: R_cw = k R_fw */
    double R_fw_R; /* and R_fw over R, 2/(1 + k) */
    int stem_count, edge_count;
    struct pp_nomogram_stem stems[PP_NOMOGRAM_STEMS];
    struct pp_nomogram_edge edges[PP_NOMOGRAM_EDGES];
};

/* Factor for a point's place, on IV. A straight-edge from the stem of places through a
 * curve gives it; the curve is for the room's depth (or half its width) q in ranges of
 * the light. */
struct pp_nomogram_place {
    double q, share, factor;  /* as set and read */
    double x, y;              /* of q on its curve */
    double share_y, factor_y; /* on their stems */
};

/* Reading of one opening. Values are in the order of the stems, as set and read; NAN: not
 * used. Without an obstruction (a slope) E is not read: it is C. */
struct pp_nomogram_reading {
    double glass_m2, inside_m2; /* W, A */
    double ratio;               /* W/A */
    int tens;                   /* scale A was set to ratio times 10^tens */
    double value[PP_NOMOGRAM_STEMS];
    bool used[PP_NOMOGRAM_EDGES]; /* which lines were laid */
    double component;             /* average, over 10^tens, before allowances */
    double
        further; /* the same of the minimum, by II, or at the point, by IV; else NAN */
    struct pp_nomogram_place places[2]; /* of IV: by the depth, and sideways */
};

/* ---- the sheet: scales with their marks, and the readings of a room ---- */

struct pp_nomogram_mark {
    double x;      /* on a curve: of the sheet's width, from the left */
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
    const char *label; /* of the first opening, not owned */
    int alike;         /* how many there are */
    struct pp_nomogram_reading read;
    double y[PP_NOMOGRAM_STEMS]; /* where the readings stand */
    double allowance;            /* for its glass, frame and dirt */
};

struct pp_nomogram_sheet {
    struct pp_nomogram nomogram;
    struct pp_nomogram_scale scales[PP_NOMOGRAM_STEMS];
    struct pp_nomogram_scale curve;           /* of IV, from end to end; else empty */
    const struct pp_formula *const *formulae; /* formulae calculated before setting, on
                                               * IV; ends with NULL; NULL: none */
    const char *name;                         /* the room's, or NULL; not owned */
    bool blank;                               /* no room */
    int window_count;
    struct pp_nomogram_window *windows; /* owned */
    int left_out;       /* openings of the room that the nomogram is not made for */
    double decorations; /* D: share that their deterioration leaves, of all windows */
    double component;   /* average of all windows, allowances settled */
    double
        further; /* of II: the minimum; of IV: at the point; of all windows, else NAN */
};

void pp_nomogram_sheet_clear(struct pp_nomogram_sheet *sheet);

#endif
