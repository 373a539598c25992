/* sky_picture_view.h - orientation of a picture of the sky, from options, the VIEW of
 * Radiance's header, or defaults (sky_picture_file.h). */
#ifndef PP_MODEL_PICTURES_SKY_PICTURE_VIEW_H
#define PP_MODEL_PICTURES_SKY_PICTURE_VIEW_H

#include "model/base/error.h"
#include "model/light/photographs/sky_picture.h"
#include "model/pictures/sky_picture_file.h"

/* Sets the frame's projection, angle, circle and axes for a picture of that size. view:
 * options after VIEW=, "" for none. PP_BAD_INPUT if they are inconsistent. */
enum pp_status pp_sky_picture_view(struct pp_sky_frame *frame, int width, int height,
                                   const char *view,
                                   const struct pp_sky_picture_options *options,
                                   struct pp_error *err);

#endif
