/* gbxml_planes.h - divides the non-planar faces of a shell into triangles. Inside
 * formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_PLANES_H
#define PP_FORMATS_GBXML_GBXML_PLANES_H

#include "formats/gbxml/gbxml_shell.h"

/* Divides uneven faces by diagonals, so that the shell stays closed and no corner
 * moves. *divided: number of faces divided. Fails only if memory runs out. */
enum pp_status pp_gbxml_planes_divide(struct pp_gbxml_shell *shell, int *divided,
                                      struct pp_error *err);

#endif
