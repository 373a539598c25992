/* retained_sky.h - light from the sky that windows or rooms around a site retain, and
 * the share that they have to retain.
 *
 * The value of a window is its vertical sky component
 * (criteria/windows/vertical_sky.h), that of a room the area of its working plane that
 * sees sky, before the no-sky line (studies/lit_line.h). Each has to retain a share of
 * its value before building; a sufficient value is enough in any case:
 *
 *     due = min(keep before, enough)       [BR209]: keep = 0.8; of VSC, enough = 27 %
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
    const char *room;   /* counts only rooms of that name; NULL: all */
    const char *window; /* counts only windows of that name, for VSC; NULL: all */
    double keep;        /* share to retain, above 0, below 1 */
    double french_m;    /* as for pp_vertical_sky_at_point (vertical_sky.h); 0: none */
    double enough;      /* value that is sufficient in any case; INFINITY: none */
};

/* A vertical window, or a room, that counts. */
struct pp_retained_sky_place {
    char room[64],
        window[64]; /* names, cut to fit; may be empty; window: empty for a room */
    char label[PP_WORLD_LABEL]; /* label of the window, as on drawings; "" for a room */
    int place, line; /* place: of the room in its building; line: of the window in the
                      * file, 0 for a room */
    struct pp_vec3 middle,
        outward;               /* of the window's outside, or where its component is
                                * taken, in the building's axes; of a room 0 */
    double before, now, after; /* VSC (a fraction) or area (m2): before, as in the file,
                                * and with the result */
};

struct pp_retained_sky {
    struct pp_retained_sky_place *list;
    int count;
};

/* Lists the windows or rooms that count in the building in its present state, with
 * their `now`, and without before and after. PP_BAD_INPUT if none count, or a room is
 * invalid. The caller clears *retained in any case. */
enum pp_status pp_retained_sky_list(struct pp_retained_sky *retained,
                                    const struct pp_retained_sky_rule *rule,
                                    struct pp_building *building, struct pp_error *err);

/* Fills in `before` or `after`: the values with the building in its present state,
 * which may differ from that of the list. Windows or rooms that do not exist have 0. */
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

/* Surplus of a place: its value after over its due, less 1; INFINITY if it had nothing
 * before. */
double pp_retained_sky_surplus_of(const struct pp_retained_sky_place *due,
                                  const struct pp_retained_sky_rule *rule);

/* Least ratio of after to due, less 1, over all that had anything before; INFINITY if
 * none had. *deciding is its index, -1: none. */
double pp_retained_sky_surplus(const struct pp_retained_sky *retained,
                               const struct pp_retained_sky_rule *rule, int *deciding);

void pp_retained_sky_clear(struct pp_retained_sky *retained);

#endif
