/* render_view.h - converts the view options to a camera in a room. */
#ifndef PP_CLI_RENDER_RENDER_VIEW_H
#define PP_CLI_RENDER_RENDER_VIEW_H

#include "cli/render/render_choice.h"
#include "model/pictures/camera.h"
#include "simulate/scene/light_scene.h"

/* Sets the camera and the size of the picture. */
enum pp_status pp_render_view(struct pp_camera *camera, struct pp_picture_size *size,
                              const struct pp_render_choice *choice,
                              const struct pp_light_scene *scene,
                              const struct pp_world *world, struct pp_error *err);

/* Writes the description of a view for a sheet: "Perspective from (1.5, 8.6, 1.6) m to
 * bearing 180°". */
void pp_render_view_words(char *text, size_t room, const struct pp_camera *camera,
                          const struct pp_world *world);

#endif
