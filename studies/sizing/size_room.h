/* size_room.h - the smallest window for which a room reaches a target, by a hand method
 * or by simulation, and the corresponding edits of the room file. */
#ifndef PP_STUDIES_SIZING_SIZE_ROOM_H
#define PP_STUDIES_SIZING_SIZE_ROOM_H

#include "studies/criteria/grid/plane_grid.h"
#include "studies/study_room.h"
#include "studies/reliability.h"
#include "studies/sizing/size.h"
#include "methods/method.h"
#include "model/room/text/room_text.h"
#include "studies/study_options.h"
#include "studies/sizing/window_sizes.h"

/* Target and options. */
struct pp_size_request {
    const struct pp_study_options *study; /* for points and simulation; not owned */
    double target;                        /* a fraction; 0: not given */
    const char
        *criterion; /* target used instead of a value, as in criterion_margin.h: its
                     * margin must reach 1; NULL: none */
    struct pp_grid_choice grid; /* grid on which a criterion is judged */
    const char *by; /* a method, a pair, or "traced"; NULL: one that covers the room */
    bool traced;    /* by is "traced" */
    enum pp_size_change change;
    const char *wall; /* only windows in that wall; NULL: any */
    long line;        /* only the opening on that line of the file; 0: any line */
};

/* Names of quantities that may change: "width". */
extern const char *const pp_size_room_change_words[];

/* Results for one room. */
struct pp_size_room_result {
    const struct pp_study_room *room; /* not owned */
    const char *method; /* sizing method; NULL: a criterion's own; not owned */
    struct pp_size_answer answer;
    struct pp_text_edit *edits; /* changes of the room's openings; owned */
    int edit_count;
    const char *file_text; /* not owned */
    size_t file_length;
    int file_opening; /* number of openings in the file before the room's first */
    const char *why;  /* reason if there is no value; not owned */
    struct pp_reading traced; /* simulated value of the sized room; NAN if nothing
                               * was simulated */
    bool holds; /* false: the simulated value of the size found by hand is below the
                 * target, by more than two standard errors; if that of the largest size
                 * is too, the target cannot be reached, and that size is the answer */
    struct pp_band_ends
        band; /* band of the value of the sized room, if the atlas has one */
    struct pp_reliability reliability; /* reliability of hand methods in the present
                                        * room */
    char text[512];                    /* storage for why */
};

/* Sizes a room. PP_BAD_INPUT if it has no such window. The caller clears the result in
 * any case. */
enum pp_status pp_size_room(struct pp_size_room_result *result,
                            const struct pp_study_room *room,
                            const struct pp_size_request *request,
                            struct pp_error *err);

/* Marks the result as that of a room that cannot be sized, with the reason. */
void pp_size_room_result_refuse(struct pp_size_room_result *result, const char *why);

/* Quantity that a method, a pair or "traced" gives, to which the target applies. */
enum pp_gives pp_size_room_gives(const char *by);

void pp_size_room_result_clear(struct pp_size_room_result *result);

#endif
