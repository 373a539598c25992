/* scattering_panes.h - rejects rooms with panes that scatter by direction, for engines
 * that cannot simulate them. */
#ifndef PP_STUDIES_ENGINES_SCATTERING_PANES_H
#define PP_STUDIES_ENGINES_SCATTERING_PANES_H

#include "model/base/error.h"
#include "model/room/world.h"

/* Returns PP_BAD_INPUT, with the engine's name, if an opening has such a pane. */
enum pp_status pp_scattering_panes_refuse(const struct pp_world *world,
                                          const char *engine, struct pp_error *err);

#endif
