/* sky_mask.h - the hidden parts of the sky at a point, by bearing and altitude. */
#ifndef PP_MODEL_RESULTS_SHEETS_SKY_MASK_H
#define PP_MODEL_RESULTS_SHEETS_SKY_MASK_H

/* Adjacent bearings (clockwise from north, rad), each with the lowest and highest
 * hidden altitude (rad, 0 to pi/2). */
struct pp_sky_mask_piece {
    int count, capacity;
    double (*edges)[3]; /* bearing, low, high */
};

/* The hidden parts; pieces may overlap at their ends. */
struct pp_sky_mask {
    int count;
    struct pp_sky_mask_piece *pieces;
};

void pp_sky_mask_clear(struct pp_sky_mask *mask);

#endif
