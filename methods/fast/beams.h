/* beams.h - the beams of a world's openings, with the areas of all directions evaluated
 * so far.
 *
 * Methods that average over the working plane multiply the same areas by different
 * luminances. The methods exact, waldram and pepper-pot, in all variants, mostly use
 * the same directions, since their adaptive subdivisions begin in the same way. The
 * area of each direction is calculated once. A mean that two methods have in common is
 * also calculated once.
 */
#ifndef PP_METHODS_FAST_BEAMS_H
#define PP_METHODS_FAST_BEAMS_H

#include "methods/fast/beam.h"
#include "model/base/stop.h"

struct pp_beams;

/* Creates the store; each beam is created when it is first used. *beams refers to
 * world. On success the caller destroys *beams. plain: averages are integrated over
 * points instead (plane_light.h). */
enum pp_status pp_beams_create(struct pp_beams **beams, const struct pp_world *world,
                               bool plain, struct pp_error *err);
void pp_beams_destroy(struct pp_beams *beams); /* NULL is allowed */

/* Areas are not evaluated any more once the condition holds. */
void pp_beams_stop_when(struct pp_beams *beams, struct pp_stop stop);

const struct pp_world *pp_beams_world(const struct pp_beams *beams);
bool pp_beams_plain(const struct pp_beams *beams);

/* One beam (beam.h) with its stored results. Several threads may use beams of different
 * openings. */
struct pp_kept_beam;
enum pp_status pp_beams_of(struct pp_kept_beam **kept, struct pp_beams *beams,
                           const struct pp_opening *opening, bool with_outside,
                           struct pp_error *err);

/* Areas for a direction, as pp_beam_areas; for one thread at a time. All zero once the
 * beam's work budget is exhausted. */
enum pp_status pp_kept_beam_areas(struct pp_beam_areas *areas,
                                  struct pp_kept_beam *kept, struct pp_vec3 u,
                                  struct pp_error *err);

/* True if a beam has exhausted its work budget because obstructions have too many
 * pieces. No mean is valid then. */
bool pp_beams_gave_up(const struct pp_beams *beams);

/* Reads the stored means of the beam's light through that glass. All users must have
 * the same sky. Returns false if no means are stored. */
bool pp_kept_beam_means(double means[2], const struct pp_kept_beam *kept,
                        const struct pp_glass *glass);
void pp_kept_beam_keep_means(struct pp_kept_beam *kept, const struct pp_glass *glass,
                             const double means[2]);

#endif
