/* sky_view.h - the sky and the sun that a point sees through clear openings, for any
 * hour.
 *
 * The view through each opening is the same all year and is found once
 * (methods/view/visible.h). The sun of every hour is tested against this view. For the
 * light of any sky, the view is cut into pieces, each with one direction:
 *
 *     E = sum of coefficient x L(u),   coefficient = integral tau (n.u) over the piece
 *
 * with the integral of n.u in closed form and tau (glass, frame, dirt, curtains) at u.
 * For panes that scatter, only unscattered light is included; diffusing panes are left
 * out.
 */
#ifndef PP_METHODS_EXACT_SKY_VIEW_H
#define PP_METHODS_EXACT_SKY_VIEW_H

#include "methods/view/visible.h"
#include "model/base/error.h"
#include "model/room/world.h"

struct pp_sky_view {
    const struct pp_world *world; /* not owned */
    struct pp_vec3 normal;
    struct pp_visible *visible; /* one view for each opening; no patches if nothing is
                                 * visible */
};

/* On success the caller clears *view. */
enum pp_status pp_sky_view_init(struct pp_sky_view *view, const struct pp_world *world,
                                const struct pp_receiver *receiver,
                                struct pp_error *err);

/* As pp_sky_view_init, but for pp_sky_view_sun only: the views are stored as convex
 * parts, which are found much faster behind many obstructions. */
enum pp_status pp_sky_view_init_for_sun(struct pp_sky_view *view,
                                        const struct pp_world *world,
                                        const struct pp_receiver *receiver,
                                        struct pp_error *err);
void pp_sky_view_clear(struct pp_sky_view *view);

struct pp_sky_piece {
    int opening;
    struct pp_vec3 u;   /* direction (unit vector): mean of the directions of the
                         * corners */
    double coefficient; /* integral of tau (n.u) over the piece, sr */
    bool ground;        /* true: below the horizon, where the ground extends without
                         * limit */
};

typedef void pp_sky_view_sink(void *data, const struct pp_sky_piece *piece);

/* Calls a function with each piece of sky and, if the world's ground is open, of the
 * ground below the horizon, at most size_rad wide and high. PP_BAD_INPUT if an outline
 * has too many corners. */
enum pp_status pp_sky_view_pieces(const struct pp_sky_view *view, double size_rad,
                                  pp_sky_view_sink *sink, void *data,
                                  struct pp_error *err);

/* Illuminance from the sun (centre in direction u, a unit vector), divided by that of a
 * plane outside normal to u. It is 0 if the sun is hidden, behind the receiver or below
 * the horizon; *opening is then unchanged. Otherwise *opening (may be NULL) is the
 * index of the opening that the sun shines through. */
double pp_sky_view_sun(const struct pp_sky_view *view, struct pp_vec3 u, int *opening);

#endif
