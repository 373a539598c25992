/* retained_sky.h - sky light that the windows or rooms around a site retain when a
 * building changes, and the share of it that they must retain.
 *
 * The value of a window is its vertical sky component
 * (criteria/windows/vertical_sky.h). The value of a room is the area of its working
 * plane that can see the sky (studies/lit_line.h). After building, each must have at
 * least `due`:
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

/* "vsc", "lit-area", NULL. */
extern const char *const pp_retained_sky_words[];

struct pp_retained_sky_rule {
    enum pp_retained_sky_of of;
    const char *room;   /* only rooms of that name count; NULL: all */
    const char *window; /* only windows of that name count, for VSC; NULL: all */
    double keep;        /* share to retain, above 0, below 1 */
    double french_m;    /* as for pp_vertical_sky_at_point (vertical_sky.h); 0: none */
    double enough;      /* value that is sufficient in any case; INFINITY: none */
};

/* A vertical window, or a room, that is assessed. */
struct pp_retained_sky_place {
    char room[64],
        window[64]; /* names, cut to fit; may be empty; window: empty for a room */
    char label[PP_WORLD_LABEL]; /* label of the window, as on drawings; "" for a room */
    int place, line; /* place: of the room in its building; line: of the window in the
                      * file, 0 for a room */
    struct pp_vec3 middle,
        outward;               /* centre of the window's outer face, or the French VSC
                                * point; outward normal; in the building's axes. Both 0
                                * for a room */
    double before, now, after; /* VSC (a fraction) or area (m2): before building; in the
                                * state listed; with the result */
};

struct pp_retained_sky {
    struct pp_retained_sky_place *list;
    int count;
};

/* Lists the windows or rooms selected by the rule, with the building in its present
 * state. Fills in `now`; `before` and `after` stay NAN. PP_BAD_INPUT if the rule
 * selects none, or if a room is invalid. The caller clears *retained in any case. */
enum pp_status pp_retained_sky_list(struct pp_retained_sky *retained,
                                    const struct pp_retained_sky_rule *rule,
                                    struct pp_building *building, struct pp_error *err);

/* Fill in `before` or `after` with the building in its present state, which need not be
 * the state of the list. A window or room that does not exist in this state has the
 * value 0. */
enum pp_status pp_retained_sky_before(struct pp_retained_sky *retained,
                                      const struct pp_retained_sky_rule *rule,
                                      struct pp_building *building,
                                      struct pp_error *err);
enum pp_status pp_retained_sky_after(struct pp_retained_sky *retained,
                                     const struct pp_retained_sky_rule *rule,
                                     struct pp_building *building,
                                     struct pp_error *err);

/* Fills in `after` of one place, given by its index in the list. */
enum pp_status pp_retained_sky_after_one(struct pp_retained_sky *retained, int number,
                                         const struct pp_retained_sky_rule *rule,
                                         struct pp_building *building,
                                         struct pp_error *err);

/* Surplus of a place: after / due - 1, with `due` from the head of this file. INFINITY
 * if `before` is practically 0 (at most 1e-6). */
double pp_retained_sky_surplus_of(const struct pp_retained_sky_place *due,
                                  const struct pp_retained_sky_rule *rule);

/* Least surplus of all places; INFINITY if `before` is practically 0 in all of them.
 * *deciding: index of the place with the least surplus; -1: none. */
double pp_retained_sky_surplus(const struct pp_retained_sky *retained,
                               const struct pp_retained_sky_rule *rule, int *deciding);

void pp_retained_sky_clear(struct pp_retained_sky *retained);

#endif
