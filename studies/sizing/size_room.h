/* size_room.h - the smallest window with which a room reaches a target, by a hand
 * method or by simulation, and the corresponding edits to the room file. */
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

/* Request to size a window: target and options. */
struct pp_size_request {
    const struct pp_study_options *study; /* points and simulation options; not owned */
    double target;                        /* target as a fraction; 0: not given */
    const char
        *criterion; /* criterion used instead of a target, as in criterion_margin.h: the
                     * margin must reach 1; NULL: none */
    struct pp_grid_choice grid; /* grid on which a criterion is assessed */
    const char *by; /* a method, a pair, or "traced"; NULL: a pair that applies to the
                     * room */
    bool traced;    /* true if `by` is "traced" */
    enum pp_size_change change;
    const char *wall; /* change only windows in this wall; NULL: any wall */
    long line;        /* change only the opening on this line of the file; 0: any
                       * line */
};

/* Names of the quantities that may change, such as "width". */
extern const char *const pp_size_room_change_words[];

/* Results for one room. */
struct pp_size_room_result {
    const struct pp_study_room *room; /* not owned */
    const char *method; /* method used for the search; NULL: the method of the
                         * criterion; not owned */
    struct pp_size_answer answer;
    struct pp_text_edit *edits; /* changes to the openings in the file; owned */
    int edit_count;
    const char *file_text; /* not owned */
    size_t file_length;
    int file_opening; /* number of openings in the file before the first one of this
                       * room */
    const char *why;  /* reason why there is no value; not owned */
    struct pp_reading traced; /* simulated value of the sized room; NAN if nothing
                               * was simulated */
    bool holds; /* false: the simulated value of the size found by hand is below the
                 * target by more than two standard errors; if the same is true for the
                 * largest size, the target cannot be reached, and the largest size is
                 * the result */
    struct pp_band_ends
        band; /* band of the value of the sized room, if the atlas has one */
    struct pp_reliability reliability; /* reliability of hand methods for the present
                                        * room */
    char text[512];                    /* memory for the text of `why` */
};

/* Sizes a room. PP_BAD_INPUT if it has no window that matches the request. The caller
 * clears *result, also after a failure. */
enum pp_status pp_size_room(struct pp_size_room_result *result,
                            const struct pp_study_room *room,
                            const struct pp_size_request *request,
                            struct pp_error *err);

/* Sets the result of a room that cannot be sized, with the reason. */
void pp_size_room_result_refuse(struct pp_size_room_result *result, const char *why);

/* Component or daylight factor that a method, a pair or "traced" gives, to which the
 * target applies. */
enum pp_gives pp_size_room_gives(const char *by);

void pp_size_room_result_clear(struct pp_size_room_result *result);

#endif
