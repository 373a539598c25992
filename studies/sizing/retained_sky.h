/* retained_sky.h - sky that the windows or rooms around a site keep when a building
 * changes, and the amount that they must keep.
 *
 * The value of a window is its vertical sky component
 * (criteria/windows/vertical_sky.h). The value of a room is the area of its working
 * plane with a view of the sky (studies/lit_line.h). After building, each value must be
 * at least `due`:
 *
 *     due = min(keep x before, enough)
 *
 * [BR209] has keep = 0.8 and, for the vertical sky component, enough = 27 %.
 */
#ifndef PP_STUDIES_SIZING_RETAINED_SKY_H
#define PP_STUDIES_SIZING_RETAINED_SKY_H

#include "model/base/error.h"
#include "model/room/building.h"

enum pp_retained_sky_of { PP_RETAINED_SKY_VSC, PP_RETAINED_SKY_LIT_AREA };

/* Names of the quantities: "vsc", "lit-area", NULL. */
extern const char *const pp_retained_sky_words[];

struct pp_retained_sky_rule {
    enum pp_retained_sky_of of;
    const char *room;   /* name of the rooms to be assessed; NULL: all rooms */
    const char *window; /* name of the windows to be assessed, for the vertical sky
                         * component; NULL: all windows */
    double keep;        /* fraction of the former value to be retained, 0 < keep < 1 */
    double french_m;    /* height of the reference point on French windows, m
                         * (vertical_sky.h); 0: none */
    double enough;      /* value that is always sufficient; INFINITY: none */
};

/* A vertical window or a room that is assessed. */
struct pp_retained_sky_place {
    char room[64],
        window[64]; /* names, truncated; may be empty; window: empty for a room */
    char label[PP_WORLD_LABEL]; /* label of the window on drawings; "" for a room */
    int place, line; /* place: index of the room in its building; line: line of the
                      * window in the file, 0 for a room */
    struct pp_vec3 middle,
        outward;               /* centre of the window's outer face, or reference point
                                * of a French window; outward normal; in the building's
                                * axes; both 0 for a room */
    double before, now, after; /* vertical sky component (fraction) or area (m2): before
                                * building, in the state listed, and with the result */
};

struct pp_retained_sky {
    struct pp_retained_sky_place *list;
    int count;
};

/* Lists the windows or rooms selected by the rule, for the present state of the
 * building. Sets `now`; `before` and `after` are NAN. PP_BAD_INPUT if the rule does not
 * select any, or if a room is invalid. The caller clears *retained, also after a
 * failure. */
enum pp_status pp_retained_sky_list(struct pp_retained_sky *retained,
                                    const struct pp_retained_sky_rule *rule,
                                    struct pp_building *building, struct pp_error *err);

/* Set `before` or `after` from the present state of the building, which need not be the
 * state of the list. The value of a window or room that does not exist in this state is
 * 0. */
enum pp_status pp_retained_sky_before(struct pp_retained_sky *retained,
                                      const struct pp_retained_sky_rule *rule,
                                      struct pp_building *building,
                                      struct pp_error *err);
enum pp_status pp_retained_sky_after(struct pp_retained_sky *retained,
                                     const struct pp_retained_sky_rule *rule,
                                     struct pp_building *building,
                                     struct pp_error *err);

/* Sets `after` of one place. number: its index in the list. */
enum pp_status pp_retained_sky_after_one(struct pp_retained_sky *retained, int number,
                                         const struct pp_retained_sky_rule *rule,
                                         struct pp_building *building,
                                         struct pp_error *err);

/* Surplus of a place: after / due - 1, with `due` from the head of this file. INFINITY
 * if `before` is practically 0 (at most 1e-6). */
double pp_retained_sky_surplus_of(const struct pp_retained_sky_place *due,
                                  const struct pp_retained_sky_rule *rule);

/* Least surplus of all places; INFINITY if `before` is practically 0 at all of them.
 * *deciding is set to the index of the place with the least surplus; -1: none. */
double pp_retained_sky_surplus(const struct pp_retained_sky *retained,
                               const struct pp_retained_sky_rule *rule, int *deciding);

void pp_retained_sky_clear(struct pp_retained_sky *retained);

#endif
