/* rad_functions.h - "pepperpot.cal": functions evaluated by Radiance, for the skies and
 * glazings that no Radiance material or pattern can describe.
 *
 *     pp_sky       skies with a sharp horizon, which gensky cannot generate; they may
 *                  have skylines too distant for parallax
 *     pp_through,  clear glazings of any number of panes, with their frame and dirt:
 *     pp_mirrored  transmittance and reflectance by angle, as in glass.h
 *
 * Materials that differ by side are written as a mixfunc with "if(Rdot,1,0)". The
 * writer (rad_write.h) uses these functions; the reader recognises their names and uses
 * its own formulae.
 */
#ifndef PP_FORMATS_RADIANCE_RAD_FUNCTIONS_H
#define PP_FORMATS_RADIANCE_RAD_FUNCTIONS_H

#include "model/light/scene_description.h"

#define PP_RAD_CAL_NAME "pepperpot.cal"
#define PP_RAD_SIDES "if(Rdot,1,0)"

/* The text of "pepperpot.cal". */
const char *pp_rad_functions_cal_text(void);

/* Reads a primitive written by pepperpot that uses these functions; *taken is false if
 * it has another type or function. Inside the reader only (rad_reader.h). */
struct pp_rad_reader;
struct pp_rad_primitive;
struct pp_rad_context;
enum pp_status pp_rad_functions_read(struct pp_rad_reader *reader,
                                     const struct pp_rad_primitive *primitive,
                                     const struct pp_rad_context *context, bool *taken,
                                     struct pp_error *err);

/* Arguments of pp_sky: horizontal irradiance, type (0 uniform, 1 to 15 of ISO 15469, 16
 * overcast, 17 by parameters), normalisation, parameters a to e, direction to the sun.
 * Each skyline adds four numbers: x and y of its direction, slope, radiance. */
enum {
    PP_RAD_SKY_NUMBERS = 11,
    PP_RAD_SKYLINE_NUMBERS = 4,
    PP_RAD_OVERCAST = 16,
    PP_RAD_PEREZ = 17
};

/* Arguments of a glazing: diffuse reflectance of the front and of the back and diffuse
 * transmittance (always 0), three channels each; then A10 to A15 of pepperpot.cal. */
enum { PP_RAD_PANE_NUMBERS = 15 };

#endif
