/* fit_rooms.h - traced rooms (tests/lib/traced_rooms.h) as rows for the fit of
 * formulae: for each point, and each opening seen from it, all quantities that a hand
 * formula may use. */
#ifndef PP_BENCH_FIT_ROOMS_H
#define PP_BENCH_FIT_ROOMS_H

#include <stdbool.h>

/* Light of an opening at the centre of the room, divided by Eh, including glass, frame
 * and dirt. E_b = C_b v^b and E_g = C_g v^g; b and g are fitted (fitted_light.h). */
enum pp_fit_source {
    PP_FIT_BRE, /* as printed */
    PP_FIT_FLUX,
    PP_FIT_SPHERE,
    PP_FIT_DF,         /* average-df, as printed */
    PP_FIT_SPHERE_NOW, /* tau Ag sqrt(rho_u)/(A (1-R)) ((V + E_b) rho_l + E_g) */
    PP_FIT_BRE_NOW,    /* as printed, with V + E_b and E_g instead of C and 5 */
    PP_FIT_FLUX_NOW,
    PP_FIT_DF_NOW,   /* 2 (V + E_b + E_g) instead of theta */
    PP_FIT_BRE_DOWN, /* 0.85 W/(A (1-R)) ((V + E_b) R_fw + E_g) */
    PP_FIT_FLUX_ALL, /* 2 tau Ag rho_u/(A (1-R^2)) ((V + E_b) rho_l + E_g) */
    PP_FIT_SOURCES
};

/* Dimensionless terms of the exponential; logarithms of quantities that enter as
 * powers. */
enum pp_fit_term {
    PP_FIT_ONE,
    PP_FIT_UPPER,        /* ln rho_u */
    PP_FIT_LOWER,        /* ln rho_l */
    PP_FIT_SKY,          /* ln v */
    PP_FIT_ANGLE,        /* ln max(1 - alpha/90, 0.02) */
    PP_FIT_PARTS,        /* (1 - R) ln(A_l/A_u) */
    PP_FIT_PARTS_ALWAYS, /* ln(A_l/A_u) */
    PP_FIT_REVEAL,       /* -(1 - R) d (1/w + 1/h) */
    PP_FIT_REVEAL_ALWAYS,
    PP_FIT_LOW,        /* -n */
    PP_FIT_LOW_LOST,   /* -(1 - R) n */
    PP_FIT_FLOOR_AREA, /* ln(A/A_f) */
    PP_FIT_GROUND,     /* -C_g/(V + C_b + C_g) */
    PP_FIT_CEILING,    /* ln of the reflectances of ceiling, walls, floor */
    PP_FIT_WALLS,
    PP_FIT_FLOOR,
    PP_FIT_MEAN,       /* ln R */
    PP_FIT_LOSS,       /* 1 - R */
    PP_FIT_DEEP,       /* ln(d_r/h_r) */
    PP_FIT_SHALLOW,    /* (1 - R) ln(1 + h_r/d_r) */
    PP_FIT_BROAD,      /* ln(w_r/h_r) */
    PP_FIT_GLASS,      /* ln(Ag/A) */
    PP_FIT_SILL,       /* (height of the sill above the plane)/h_r */
    PP_FIT_HEAD,       /* (height of the head above the plane)/h_r */
    PP_FIT_PLACE,      /* -x/d_r */
    PP_FIT_PLACE_LOST, /* -(1 - R) (x/d_r - 1/2); 0 for averages */
    PP_FIT_SQUARE,     /* -(x/d_r)^2 */
    PP_FIT_NEAR,       /* -ln(1 + (x/h_r)^2) */
    PP_FIT_ASIDE,      /* -y/w_r */
    PP_FIT_BESIDE,     /* -(distance from the nearer jamb along the wall)/l */
    PP_FIT_TERMS
};

struct pp_fit_opening {
    double source[PP_FIT_SOURCES][3]; /* parts due to V, C_b, C_g; printed formulae:
                                       * total, 0, 0 */
    double v;                         /* V divided by its value under the open sky; at
                                       * least 0.003 */
    double term[PP_FIT_TERMS];
    double R, d_r, w_r, h_r, w, x, y; /* as in fitted_position.h; x, y 0 for averages */
};

enum { PP_FIT_OPENINGS = 12 };

struct pp_fit_row {
    int room;       /* number */
    bool average;   /* average over the plane, not at a point */
    bool dark;      /* among the darkest quarter of the room's points */
    double irc, df; /* traced */
    double weight;  /* 1, or less if the simulated value is uncertain */
    int count;
    struct pp_fit_opening openings[PP_FIT_OPENINGS];
};

struct pp_fit_rooms {
    int count;
    struct pp_fit_row *rows; /* rows of one room are adjacent */
};

/* Reads a file of traced rooms. Leaves out rooms that the fitted formulae reject or
 * that have more than PP_FIT_OPENINGS openings, and points with a traced component
 * below 0.002 % or a standard error above 30 %. Exits with a message on errors. */
struct pp_fit_rooms pp_fit_rooms_read(const char *path);

#endif
