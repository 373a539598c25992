/* radiance_export.h - writes a room as a directory of Radiance files. */
#ifndef PP_CLI_RADIANCE_RADIANCE_EXPORT_H
#define PP_CLI_RADIANCE_RADIANCE_EXPORT_H

#include "cli/output_directory.h"
#include "cli/rooms.h"

/* Luminous efficacy with which Radiance converts radiance to luminance, lm/W [WS98]. */
#define PP_RADIANCE_EFFICACY 179.0

/* Names of all files that an export may contain, including files made by running the
 * exported script. */
extern const char *const pp_radiance_files[];

/* Adds the files of a room to `folder` (NULL: top level). external_lux: horizontal
 * illuminance under the open sky; gloss: include colour and gloss of finishes;
 * sky_note: comment on the sky; NULL: none. */
enum pp_status pp_radiance_export(struct pp_output_directory *directory,
                                  const char *folder, const struct pp_study_room *room,
                                  double external_lux, bool gloss, const char *sky_note,
                                  struct pp_error *err);

#endif
