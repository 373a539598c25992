/* criteria.c - the list of all criteria, in the order in which they are shown. */
#include "studies/criteria/criteria.h"

#include <stddef.h>
#include <string.h>

static const struct pp_criterion *const criteria[] = {
    &pp_criterion_vertical_sky,
    &pp_criterion_former_sky,
    &pp_criterion_obstruction,
    &pp_criterion_sunlight,
    &pp_criterion_sun_exposure,
    &pp_criterion_gardens,
    &pp_criterion_view_out,
    &pp_criterion_no_sky_line,
    &pp_criterion_mirror_image,
    &pp_criterion_sky_line,
    &pp_criterion_limiting_depth,
    &pp_criterion_glazing_ratio,
    &pp_criterion_average,
    &pp_criterion_uniformity,
    &pp_criterion_en17037,
    &pp_criterion_en17037_hours,
    &pp_criterion_uk_annex,
    &pp_criterion_rights_of_light,
    &pp_criterion_glare,
    &pp_criterion_leed,
    NULL,
};

const struct pp_criterion *pp_criteria_at(int index)
{
    return criteria[index];
}

bool pp_criteria_is_called(const struct pp_criterion *criterion, const char *name)
{
    return strcmp(criterion->name, name) == 0
           || (criterion->alias && strcmp(criterion->alias, name) == 0);
}
