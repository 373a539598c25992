/* nomogram_sheet.h - the stems and marks of a nomogram, and a sheet with the readings
 * of a room. */
#ifndef PP_MODEL_RESULTS_NOMOGRAM_SHEET_H
#define PP_MODEL_RESULTS_NOMOGRAM_SHEET_H

#include <stdbool.h>

#include "model/results/formula.h"

/* Prominence of a mark on a scale. */
enum pp_mark_rank { PP_MARK_FINE, PP_MARK_MIDDLE, PP_MARK_LABELLED };

/* ---- the nomogram ----
 *
 * A nomogram is a chart of vertical scales, the stems, on which a straight-edge
 * performs a calculation. Positions are fractions: x of the sheet's width from the
 * left, y of the scales' height from the bottom. A method defines them
 * (methods/nomogram/nomogram_scale.h has the derivation); a chart draws them.
 */

enum pp_nomogram_kind {
    PP_NOMOGRAM_AVERAGE,   /* I: average IRC of a side-lit room */
    PP_NOMOGRAM_MINIMUM,   /* II: average and minimum IRC of a side-lit room */
    PP_NOMOGRAM_ROOFLIGHT, /* III: average IRC of a top-lit room */
    PP_NOMOGRAM_POSITION,  /* IV: IRC at a point of a side-lit room */
    PP_NOMOGRAMS,
};

enum pp_nomogram_quantity {
    PP_NOMOGRAM_GLASS,       /* net glass area / area of all inside surfaces */
    PP_NOMOGRAM_REFLECTANCE, /* mean of all inside surfaces */
    PP_NOMOGRAM_COMPONENT,   /* internally reflected component, fraction of Eh */
    PP_NOMOGRAM_OBSTRUCTION, /* altitude of the obstruction, rad */
    PP_NOMOGRAM_SLOPE,       /* slope of the glass, 0 horizontal, rad */
    PP_NOMOGRAM_WALLS,       /* mean reflectance of the walls */
    PP_NOMOGRAM_LOSS,        /* mean reflectance R; position by 1/(1 - R) */
    PP_NOMOGRAM_GAIN,        /* glass area over losses, W/(A (1 - R)), a ratio */
    PP_NOMOGRAM_LIGHT,       /* weighted light on the glass, fraction of Eh */
    PP_NOMOGRAM_FACTOR,      /* factor for the position of a point */
    PP_NOMOGRAM_PLACE,       /* position of a point, as share of the depth or half
                              * width */
};

struct pp_nomogram_stem {
    char letter; /* 'A' */
    enum pp_nomogram_quantity quantity;
    double x;
    double foot, decade; /* y = foot + decade log10 f(value); f depends on the
                          * quantity */
    double low, high;    /* lowest and highest value on the stem */
};

/* A straight-edge between two stems, and the stem read between them. */
struct pp_nomogram_edge {
    int from, to, read;
};

enum { PP_NOMOGRAM_STEMS = 8, PP_NOMOGRAM_EDGES = 3 };

struct pp_nomogram {
    enum pp_nomogram_kind kind;
    double k;      /* rule of the nomogram: R_cw = k R_fw */
    double R_fw_R; /* R_fw / R = 2/(1 + k) */
    int stem_count, edge_count;
    struct pp_nomogram_stem stems[PP_NOMOGRAM_STEMS];
    struct pp_nomogram_edge edges[PP_NOMOGRAM_EDGES];
};

/* Factor for the position of a point, on nomogram IV. The factor is read with a
 * straight-edge from the stem of positions through a point on a curve. That point
 * depends on q, the room's depth (or half its width) divided by the range of the
 * light. */
struct pp_nomogram_place {
    double q, share, factor;  /* as set and read */
    double x, y;              /* point of the curve for q */
    double share_y, factor_y; /* positions on the two stems */
};

/* Readings for one opening. Values are in the order of the stems, as set or read; NAN:
 * stem not used. Without an obstruction (or slope) stem C is used instead of stem E. */
struct pp_nomogram_reading {
    double glass_m2, inside_m2; /* W, A */
    double ratio;               /* W/A */
    int tens;                   /* scale A is set to ratio times 10^tens */
    double value[PP_NOMOGRAM_STEMS];
    bool used[PP_NOMOGRAM_EDGES]; /* straight-edges that are used */
    double component;             /* average, times 10^tens, before allowances */
    double
        further; /* like component: minimum (II) or value at the point (IV); else NAN */
    struct pp_nomogram_place places[2]; /* nomogram IV: by depth and by width */
};

/* ---- the sheet: scales with marks, and the readings of a room ---- */

struct pp_nomogram_mark {
    double x;      /* on a curve: fraction of the sheet's width, from the left */
    double y;      /* fraction of the scales' height, from the bottom */
    double number; /* as printed: per cent, degrees, or the value itself */
    enum pp_mark_rank rank;
};

struct pp_nomogram_scale {
    int count;
    struct pp_nomogram_mark *marks; /* owned */
};

/* An opening, and others with the same readings. */
struct pp_nomogram_window {
    const char *label; /* label of the first opening, not owned */
    int alike;         /* number of openings with these readings */
    struct pp_nomogram_reading read;
    double y[PP_NOMOGRAM_STEMS]; /* positions of the readings on the stems */
    double allowance;            /* factor for glass, frame and dirt */
};

struct pp_nomogram_sheet {
    struct pp_nomogram nomogram;
    struct pp_nomogram_scale scales[PP_NOMOGRAM_STEMS];
    struct pp_nomogram_scale curve;           /* nomogram IV: marks along the curve;
                                               * else empty */
    const struct pp_formula *const *formulae; /* nomogram IV: formulae calculated
                                               * first; NULL-terminated; NULL: none */
    const char *name;                         /* name of the room, or NULL; not owned */
    bool blank;                               /* blank nomogram, without a room */
    int window_count;
    struct pp_nomogram_window *windows; /* owned */
    int left_out;       /* openings of the room outside the range of the nomogram */
    double decorations; /* D, factor for deterioration of decorations, all windows */
    double component;   /* average of all windows, including allowances */
    double
        further; /* all windows: minimum (II), or value at the point (IV); else NAN */
};

void pp_nomogram_sheet_clear(struct pp_nomogram_sheet *sheet);

#endif
