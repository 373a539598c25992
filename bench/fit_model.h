/* fit_model.h - a form of the internally reflected component, fitted to traced rooms by
 * least squares of the logarithm of its ratio to the traced value, or of that and of their
 * difference together.
 *
 *     irc = sum over openings of (S_V + S_b v^b + u S_g v^g) f_d(k) f_s(s)
 *                                times exp(sum over terms of c_j t_j)
 *
 * k, s, c, b, g, u and the c_j are fitted, by the method of Levenberg and Marquardt.
 */
#ifndef PP_BENCH_FIT_MODEL_H
#define PP_BENCH_FIT_MODEL_H

#include "bench/fit_rooms.h"

/* Shape of the decrease with the distance x from the opening's wall. */
enum pp_fit_shape {
    PP_FIT_EVEN,        /* not at all */
    PP_FIT_EXPONENTIAL, /* exp(-q x/d_r), its mean over the depth made 1 */
    PP_FIT_COSH,        /* the same with a back wall that gives all back */
    PP_FIT_INSIDE,      /* exp(-q x/d_r), q from a start c l/k inside the room */
    PP_FIT_SHAPES
};
/* And sideways: by half of which breadth. */
enum pp_fit_side {
    PP_FIT_ALIKE,          /* not at all */
    PP_FIT_WALL,           /* of the opening's wall, w_r */
    PP_FIT_BESIDE_OPENING, /* of the wall beside it, w_r - w */
    PP_FIT_SIDES
};
/* By which power of v the ground is in the shade. */
enum pp_fit_shade {
    PP_FIT_OWN_SHADE,  /* g */
    PP_FIT_ONE_SHADE,  /* b, as what stands outside */
    PP_FIT_HALF_SHADE, /* b/2 */
    PP_FIT_SHADES
};
/* Over which length, and how reflectances stretch it: by a power of 1 - R. */
enum pp_fit_range { PP_FIT_SECTION, PP_FIT_ROOT, PP_FIT_HEIGHT, PP_FIT_RANGES };

enum {
    PP_FIT_DEPTH_K, /* the parameters of every model, before those of its terms */
    PP_FIT_SIDE_S,
    PP_FIT_START_C,
    PP_FIT_SHADE_B,
    PP_FIT_SHADE_G,
    PP_FIT_UPWARD_U,
    PP_FIT_FIRST_TERM,
    PP_FIT_MOST_TERMS = 8,
    PP_FIT_PARAMETERS = PP_FIT_FIRST_TERM + PP_FIT_MOST_TERMS
};

struct pp_fit_model {
    enum pp_fit_source source;
    enum pp_fit_shape shape;
    enum pp_fit_range range;
    double power; /* of 1 - R in q: 0, 1/4, 1/2, 1 */
    enum pp_fit_side side;
    enum pp_fit_shade shade;
    bool upward;   /* is u fitted? Else it is 1 */
    bool fading;   /* does u enter to the power 1 - R? */
    double differ; /* what a difference of 1 % counts beside a ratio of e */
    bool of_df;    /* of the average daylight factor, not of the component */
    int count;
    enum pp_fit_term terms[PP_FIT_MOST_TERMS];
    double value[PP_FIT_PARAMETERS]; /* where a fit begins and ends */
    bool held;                       /* k, s, c, b, g are as they are, not fitted */
};

/* The model's figure for a row. */
double pp_fit_model_value(const struct pp_fit_model *model,
                          const struct pp_fit_row *row);

/* Fits the rows by their weights: a number for each row, or NULL for 1. */
void pp_fit_model_fit(struct pp_fit_model *model, const struct pp_fit_rooms *rooms,
                      const int *times);

/* Errors of figures against traced values. */
struct pp_fit_error {
    int count;
    double log, relative, absolute; /* sums of squares: ln(F/T), F/T - 1, F - T in % */
    double bias;                    /* sum of ln(F/T) */
};
void pp_fit_model_note(struct pp_fit_error *error, double figure, double truth);

#endif
