/* read_outline.h - reads obstructions that were outlined in a photograph. Inside
 * model/room/ only.
 *
 * The file of an outline is a list of pixels, "x,y" from the left and the top of a
 * fisheye photograph, along the upper edge of the obstructions. Between two successive
 * pixels, the obstruction is a vertical plane up to the straight line through both; its
 * two ends are at the horizontal `distance` from the camera. An empty line begins
 * another outline.
 */
#ifndef PP_MODEL_ROOM_READ_READ_OUTLINE_H
#define PP_MODEL_ROOM_READ_READ_OUTLINE_H

#include "model/light/photographs/sky_picture.h"
#include "model/room/read/reader.h"

/* Reads an outline and its file. The outline becomes a mesh whose x points east and
 * whose y points north. Mistakes in the file are reported on the line of the element;
 * the message gives their line in the file. */
void pp_read_outline(struct pp_reader *r, struct pp_room *room,
                     const struct pp_xml_element *e);

/* Adds the outlines in a text to a mesh with its origin in the camera. The faces end at
 * z = 0. text: ends with a NUL, which text_length does not count. frame: the lens. title:
 * name of the text in messages. PP_BAD_INPUT for another NUL, for a line that is no
 * pixel of the circle, for points 88 degrees or more above or below the
 * horizon, for successive points more than 60 degrees of bearing apart, for an outline
 * of one point, and if no face is above the horizon. */
enum pp_status pp_read_outline_parse(struct pp_mesh_triangles *mesh, const char *text,
                                     size_t text_length, const char *title,
                                     const struct pp_sky_frame *frame,
                                     double distance_m, struct pp_error *err);

/* Extends the faces of an outline down to the level z if it is below 0. */
void pp_read_outline_stand(struct pp_mesh_triangles *mesh, double z);

#endif
