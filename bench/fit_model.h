/* fit_model.h - a form of the internally reflected component, fitted to traced rooms.
 * The least-squares fit uses the logarithm of the ratio of fitted to traced value, and
 * optionally also the difference between the two.
 *
 *     irc = sum over openings of (S_V + S_b v^b + u S_g v^g) f_d(k) f_s(s)
 *                                times exp(sum over terms of c_j t_j)
 *
 * S_V, S_b and S_g are the parts of the source due to the sky, obstructions and ground.
 * f_d and f_s are the decreases with depth and sideways. k, s, c, b, g, u and the c_j
 * are fitted, by the method of Levenberg and Marquardt.
 */
#ifndef PP_BENCH_FIT_MODEL_H
#define PP_BENCH_FIT_MODEL_H

#include "bench/fit_rooms.h"

/* Decrease with the distance x from the opening's wall. */
enum pp_fit_shape {
    PP_FIT_EVEN,        /* none */
    PP_FIT_EXPONENTIAL, /* exp(-q x/d_r), normalised to mean 1 over the depth */
    PP_FIT_COSH,        /* as PP_FIT_EXPONENTIAL, with a totally reflecting back wall */
    PP_FIT_INSIDE,      /* exp(-q x/d_r), q for the depth less c l/k */
    PP_FIT_SHAPES
};
/* Width to which the exponent of the lateral decrease is proportional. */
enum pp_fit_side {
    PP_FIT_ALIKE,          /* none */
    PP_FIT_WALL,           /* the opening's wall, w_r */
    PP_FIT_BESIDE_OPENING, /* the wall beside the opening, w_r - w */
    PP_FIT_SIDES
};
/* Exponent of v that reduces the light of the ground. */
enum pp_fit_shade {
    PP_FIT_OWN_SHADE,  /* g */
    PP_FIT_ONE_SHADE,  /* b, as for obstructions */
    PP_FIT_HALF_SHADE, /* b/2 */
    PP_FIT_SHADES
};
/* Length scale l of the decrease: 2 w_r h_r/(w_r + h_r), sqrt(w_r h_r), h_r. */
enum pp_fit_range { PP_FIT_SECTION, PP_FIT_ROOT, PP_FIT_HEIGHT, PP_FIT_RANGES };

enum {
    PP_FIT_DEPTH_K, /* parameters of every model; those of its terms follow */
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
    double power; /* exponent of 1 - R in q: 0, 1/4, 1/2, 1 */
    enum pp_fit_side side;
    enum pp_fit_shade shade;
    bool upward;   /* u is fitted; otherwise u is 1 */
    bool fading;   /* u has the exponent 1 - R */
    double differ; /* weight of a difference of 1 %; the weight of a ratio of e is 1 */
    bool of_df;    /* fits the average daylight factor, not the component */
    int count;
    enum pp_fit_term terms[PP_FIT_MOST_TERMS];
    double value[PP_FIT_PARAMETERS]; /* initial values, then results */
    bool held;                       /* k, s, c, b, g are constant */
};

/* Value of the model for a row. */
double pp_fit_model_value(const struct pp_fit_model *model,
                          const struct pp_fit_row *row);

/* Fits the rows with weights `times`, one per row; NULL: 1. */
void pp_fit_model_fit(struct pp_fit_model *model, const struct pp_fit_rooms *rooms,
                      const int *times);

/* Errors relative to traced values. */
struct pp_fit_error {
    int count;
    double log, relative, absolute; /* sums of squares: ln(F/T), F/T - 1, F - T in % */
    double bias;                    /* sum of ln(F/T) */
};
void pp_fit_model_note(struct pp_fit_error *error, double figure, double truth);

#endif
