/* daylight_plan.c - see daylight_plan.h. */
#include "model/results/daylight_plan.h"

void pp_daylight_plan_clear(struct pp_daylight_plan *plan)
{
    pp_curve_list_clear(&plan->contours);
    pp_curve_list_clear(&plan->below);
    pp_curve_list_clear(&plan->bands);
    pp_curve_list_clear(&plan->no_sky);
    pp_curve_list_clear(&plan->dark);
    *plan = (struct pp_daylight_plan){0};
}
