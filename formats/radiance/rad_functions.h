/* rad_functions.h - "pepperpot.cal": functions, evaluated by Radiance, for skies and
 * glazings of a room without a Radiance material or pattern.
 *
 *     pp_sky       skies without gensky's fade into the ground at the horizon, and
 *                  skylines so far away that they are the same from every point
 *     pp_through,  clear glazings of any number of panes, with their frame and dirt:
 *     pp_mirrored  transmittance and reflectance by angle, as in glass.h
 *
 * Materials that differ by side are a mixfunc by "if(Rdot,1,0)". The writer
 * (rad_write.h) uses these; the reader recognises their names and uses its own
 * formulae.
 */
#ifndef PP_FORMATS_RADIANCE_RAD_FUNCTIONS_H
#define PP_FORMATS_RADIANCE_RAD_FUNCTIONS_H

#include "model/light/scene_description.h"

#define PP_RAD_CAL_NAME "pepperpot.cal"
#define PP_RAD_SIDES "if(Rdot,1,0)"

/* The text of "pepperpot.cal". */
const char *pp_rad_functions_cal_text(void);

/* Reads a primitive that uses these functions, as pepperpot writes it; *taken is false
 * if it is another type or function. Inside the reader only (rad_reader.h). */
struct pp_rad_reader;
struct pp_rad_primitive;
struct pp_rad_context;
enum pp_status pp_rad_functions_read(struct pp_rad_reader *reader,
                                     const struct pp_rad_primitive *primitive,
                                     const struct pp_rad_context *context, bool *taken,
                                     struct pp_error *err);

/* The numbers behind pp_sky: horizontal irradiance, type (0 uniform, 1 to 15 of ISO
 * 15469, 16 overcast), its normalisation and parameters a to e, direction to the sun;
 * then four a skyline: x and y of its direction, slope, radiance. */
enum {
    PP_RAD_SKY_NUMBERS = 11,
    PP_RAD_SKYLINE_NUMBERS = 4,
    PP_RAD_OVERCAST = 16,
    PP_RAD_PEREZ = 17
};

/* ... and behind a glazing's: diffuse reflectance of the front and the back, diffuse
 * transmittance (0), three channels each; panes, n, KL, scale, clear share, dirt. */
enum { PP_RAD_PANE_NUMBERS = 15 };

#endif
