/* criteria.h - the list of all criteria, and the entry of each criterion. */
#ifndef PP_STUDIES_CRITERIA_CRITERIA_H
#define PP_STUDIES_CRITERIA_CRITERIA_H

#include "studies/criteria/criterion.h"

extern const struct pp_criterion pp_criterion_vertical_sky;
extern const struct pp_criterion pp_criterion_former_sky;
extern const struct pp_criterion pp_criterion_obstruction;
extern const struct pp_criterion pp_criterion_sunlight;
extern const struct pp_criterion pp_criterion_sun_exposure;
extern const struct pp_criterion pp_criterion_gardens;
extern const struct pp_criterion pp_criterion_view_out;
extern const struct pp_criterion pp_criterion_no_sky_line;
extern const struct pp_criterion pp_criterion_mirror_image;
extern const struct pp_criterion pp_criterion_sky_line;
extern const struct pp_criterion pp_criterion_limiting_depth;
extern const struct pp_criterion pp_criterion_glazing_ratio;
extern const struct pp_criterion pp_criterion_average;
extern const struct pp_criterion pp_criterion_uniformity;
extern const struct pp_criterion pp_criterion_en17037;
extern const struct pp_criterion pp_criterion_uk_annex;
extern const struct pp_criterion pp_criterion_rights_of_light;
extern const struct pp_criterion pp_criterion_en17037_hours;
extern const struct pp_criterion pp_criterion_leed;
extern const struct pp_criterion pp_criterion_glare;

/* All criteria, in the order of results; NULL at the end. index is at most one past the
 * last. */
const struct pp_criterion *pp_criteria_at(int index);

/* True if `name` is the criterion's name or alias. */
bool pp_criteria_is_called(const struct pp_criterion *criterion, const char *name);

#endif
