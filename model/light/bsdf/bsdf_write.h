/* bsdf_write.h - a scattering pane as a WINDOW XML file, for other programs. */
#ifndef PP_MODEL_LIGHT_BSDF_BSDF_WRITE_H
#define PP_MODEL_LIGHT_BSDF_BSDF_WRITE_H

#include <stdio.h>

#include "model/light/pane_scatter.h"

/* Writes both directions of transmission, multiplied by `scale`, over the pane's own
 * basis, or over Klems's full basis if the pane has none. Values are taken at the
 * centres of patches. Unscattered light is in the patch of its direction. name: name of
 * the system. */
void pp_bsdf_write(FILE *out, const struct pp_pane_scatter *scatter, double scale,
                   const char *name);

#endif
