/* sky_picture_view.h - how a picture of the sky lies: from what is given, from the VIEW of
 * Radiance's header, or by default (sky_picture_file.h). */
#ifndef PP_MODEL_PICTURES_SKY_PICTURE_VIEW_H
#define PP_MODEL_PICTURES_SKY_PICTURE_VIEW_H

#include "model/base/error.h"
#include "model/light/photographs/sky_picture.h"
#include "model/pictures/sky_picture_file.h"

/* Sets the frame's projection, angle, circle and axes for a picture of that size. view:
 * options behind VIEW=, "" for none. PP_BAD_INPUT if they make no sense. */
enum pp_status pp_sky_picture_view(struct pp_sky_frame *frame, int width, int height,
                                   const char *view,
                                   const struct pp_sky_picture_options *options,
                                   struct pp_error *err);

#endif
