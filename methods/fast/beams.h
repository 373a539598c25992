/* beams.h - the beams of a world's openings, with the areas of all directions evaluated
 * so far.
 *
 * Methods that average over the working plane weight the same areas by different
 * lights. The methods exact, waldram and pepper-pot, in all variants, mostly use the
 * same directions, since their adaptive subdivisions begin in the same way. Each area
 * is calculated once, and so is a mean that two methods share.
 */
#ifndef PP_METHODS_FAST_BEAMS_H
#define PP_METHODS_FAST_BEAMS_H

#include "methods/fast/beam.h"

struct pp_beams;

/* Makes the store; a beam is made when it is first used. The caller owns *beams, which
 * refers to world. plain: averages are integrated over points instead
 * (plane_light.h). */
enum pp_status pp_beams_create(struct pp_beams **beams, const struct pp_world *world,
                               bool plain, struct pp_error *err);
void pp_beams_destroy(struct pp_beams *beams); /* NULL is allowed */

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

/* Reads the stored means of the beam's light through that glass, under the sky that all
 * users share; false if none are stored. */
bool pp_kept_beam_means(double means[2], const struct pp_kept_beam *kept,
                        const struct pp_glass *glass);
void pp_kept_beam_keep_means(struct pp_kept_beam *kept, const struct pp_glass *glass,
                             const double means[2]);

#endif
