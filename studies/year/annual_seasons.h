/* annual_seasons.h - a year in which trees lose their leaves. Inside studies/year/ only.
 *
 * If a tree's crown has another transmittance without leaves, open windows have two
 * states: work->open with leaves and work->bare without. Both are calculated for all
 * hours, and each hour takes the light of its season. Closed states are divided by
 * season.
 */
#ifndef PP_STUDIES_YEAR_ANNUAL_SEASONS_H
#define PP_STUDIES_YEAR_ANNUAL_SEASONS_H

#include "studies/year/annual_work.h"

/* Sets the worlds of the open states. Before, work->open.world is the world without a
 * season. */
enum pp_status pp_annual_seasons_plan(struct pp_annual_work *work,
                                      struct pp_error *err);
void pp_annual_seasons_clear(struct pp_annual_work *work);

/* Takes the direct sun of hours without leaves from work->bare. */
void pp_annual_seasons_merge_sun(struct pp_annual_work *work);

/* Light on the panes of a group, [batch][step], by season. */
enum pp_status pp_annual_seasons_on_panes(const struct pp_annual_work *work, int group,
                                          float *on_panes, struct pp_error *err);

/* Replaces rows of light [row][step] in hours without leaves by those of `bare`. */
void pp_annual_seasons_merge(const struct pp_annual_work *work, float *light,
                             const float *bare, size_t rows);

/* Divides the closed states by season, each with its own world. */
enum pp_status pp_annual_seasons_divide(struct pp_annual_work *work,
                                        struct pp_error *err);

#endif
