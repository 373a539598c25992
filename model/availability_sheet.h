/* availability_sheet.h - how often daylight does, for whoever prints or draws it.
 *
 * design/availability.h fills it; charts/availability_chart.h draws it. Shares are of
 * the working hours, 0 to 1; illuminances in lx.
 */
#ifndef PP_MODEL_AVAILABILITY_SHEET_H
#define PP_MODEL_AVAILABILITY_SHEET_H

#include "model/reading.h"

/* Where the light outside was taken from. */
enum pp_light_origin {
    PP_LIGHT_ILLUMINANCE, /* diffuse illuminance of a weather file */
    PP_LIGHT_IRRADIANCE,  /* its diffuse irradiance, by a model of luminous efficacy */
    PP_LIGHT_OVERCAST,    /* an overcast sky, by the altitude of the sun */
};

#endif
