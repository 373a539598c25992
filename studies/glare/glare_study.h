/* glare_study.h - daylight glare probability of a room's views, at one moment or in the
 * hours of a weather file.
 *
 * The illuminance at the eye is simulated like that at other points
 * (studies/year/annual.h). Glare sources are found by glare_view.h. Blinds, screens and
 * curtains of the room file are closed at all hours.
 */
#ifndef PP_STUDIES_GLARE_GLARE_STUDY_H
#define PP_STUDIES_GLARE_GLARE_STUDY_H

#include "model/results/sheets/glare_sheet.h"
#include "studies/study_room.h"
#include "studies/year/moment.h"

struct pp_glare_options {
    double threshold_cd_m2;          /* a surface with at least this luminance is a
                                      * source */
    struct pp_annual_options annual; /* hours, samples, error, seed, threads, watch */
};

/* Default options: the threshold of evalglare, and hours 8 to 18 on all days. */
extern const struct pp_glare_options pp_glare_options_default;

/* Height of the eye of a seated person, m. */
#define PP_GLARE_STUDY_EYE_M 1.2

/* Index of an opening with slats that follow the sun, whose glare is not calculated
 * over a year; -1: there is none. */
int pp_glare_study_turning(const struct pp_world *world);

/* Calculates glare at a moment (year is NULL) or over a year (moment is NULL). views:
 * at least one view of the room; must exist as long as *sheet. PP_BAD_INPUT over a
 * year if slats follow the sun. The caller clears *sheet, even after a failure. */
enum pp_status pp_glare_study_run(struct pp_glare_sheet *sheet,
                                  const struct pp_study_room *room,
                                  const struct pp_world_view *views, int view_count,
                                  const struct pp_moment *moment,
                                  const struct pp_weather_year *year,
                                  const struct pp_glare_options *options,
                                  struct pp_error *err);

#endif
